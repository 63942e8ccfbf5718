// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_services.h"

#include <algorithm>

namespace candela::ir {

/// The number of the use, which the function gets if it has it not.
static int internUse(Function &function, const ServiceInfo &service,
                     const std::vector<std::string> &texts, int results) {
    ServiceUse use{&service, {}, results};
    for (const std::string &text : texts)
        use.texts.push_back(intern(function.strings, text));
    const auto found = std::find(function.services.begin(), function.services.end(), use);
    const int index = int(found - function.services.begin());
    if (found == function.services.end())
        function.services.push_back(std::move(use));
    return index;
}

Values query(Builder &b, const ServiceInfo &service, const std::vector<std::string> &texts,
             const Values &operands, int results) {
    return b.emit(Op::Query, operands, internUse(b.function(), service, texts, results));
}

void command(Builder &b, const ServiceInfo &service, const std::vector<std::string> &texts,
             const Values &operands) {
    b.emit(Op::Command, operands, internUse(b.function(), service, texts, 0));
}

void printValues(Builder &b, const std::string &format, const Values &values) {
    command(b, info(Service::print), {format}, values);
}

} // namespace candela::ir

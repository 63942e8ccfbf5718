// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_services.h"

#include "language/ir/core/builder_sources.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// The number of the use, which the function gets if it has it not.
int internUse(Function &function, ServiceUse use) {
    const auto found = std::find(function.services.begin(), function.services.end(), use);
    const int index = int(found - function.services.begin());
    if (found == function.services.end())
        function.services.push_back(std::move(use));
    return index;
}

void addTexts(Function &function, ServiceUse &use, const std::vector<std::string> &texts) {
    for (const std::string &text : texts)
        use.texts.push_back(intern(function.strings, text));
}

int internUse(Function &function, const ServiceInfo &service, const std::vector<std::string> &texts,
              int results) {
    ServiceUse use{&service, {}, results};
    addTexts(function, use, texts);
    return internUse(function, std::move(use));
}

} // namespace

Values query(Builder &b, const ServiceInfo &service, const std::vector<std::string> &texts,
             const Values &operands, int results) {
    return b.emit(Op::Query, operands, internUse(b.function(), service, texts, results));
}

Values queryNamed(Builder &b, const ServiceInfo &service, ValueId name,
                  const std::vector<std::string> &texts, Values operands, int results) {
    ServiceUse use{&service, {ServiceUse::atRunTime}, results};
    if (const std::string *known = constantText(b, name))
        use.texts[0] = intern(b.function().strings, *known);
    else
        operands.push_back(name);
    addTexts(b.function(), use, texts);
    return b.emit(Op::Query, operands, internUse(b.function(), std::move(use)));
}

Values queryOther(Builder &b, const ServiceInfo &service, const ServiceUse &use,
                  const Values &operands, int results) {
    return b.emit(Op::Query, operands, internUse(b.function(), {&service, use.texts, results}));
}

void command(Builder &b, const ServiceInfo &service, const std::vector<std::string> &texts,
             const Values &operands) {
    b.emit(Op::Command, operands, internUse(b.function(), service, texts, 0));
}

void printValues(Builder &b, const std::string &format, const Values &values) {
    command(b, info(Service::print), {format}, values);
}

} // namespace candela::ir

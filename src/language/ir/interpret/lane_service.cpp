// SPDX-License-Identifier: Apache-2.0
#include "language/ir/interpret/lane_service.h"

#include "language/ir/core/op_info.h"

namespace candela::ir {

LaneService::LaneService(const Function &function, const Instruction &i)
    : function_(function), instruction_(i) {}

void LaneService::add(Type type, ServiceCell cell) {
    types_ += type == Type::Float ? 'f' : type == Type::String ? 's' : 'i';
    if (type == Type::String && cell.integer >= 0) {
        const std::string &text = function_.strings[std::size_t(cell.integer)];
        cell.integer = std::int32_t(strings_.size());
        strings_.append(text.c_str(), text.size() + 1);
    }
    operands_.push_back(cell);
}

std::vector<float> LaneService::ask(const ShaderArgs &args, int lane) const {
    const ServiceUse &use = serviceOf(function_, instruction_);
    std::vector<const char *> texts;
    for (int text : use.texts)
        texts.push_back(
            text == ServiceUse::atRunTime ? nullptr : function_.strings[std::size_t(text)].c_str());
    const auto file = std::size_t(instruction_.file);
    const ServiceSite site{.name = use.info->name,
                           .service = use.info->service,
                           .operandCount = std::int32_t(operands_.size()),
                           .resultCount = use.results,
                           .line = instruction_.line,
                           .file = function_.files.empty() ? "" : function_.files[file].c_str(),
                           .texts = texts.data(),
                           .types = types_.c_str(),
                           .strings = strings_.c_str()};
    std::vector<float> results(std::size_t(use.results));
    askService({&args, &site, lane, 1, 1, operands_.data(), results.data()});
    return results;
}

} // namespace candela::ir

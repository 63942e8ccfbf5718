// SPDX-License-Identifier: Apache-2.0
#include "world/shading/lowered_shaders.h"

#include "language/semantics/typed_ast.h"
#include "world/shading/shader_answers.h"

#include <algorithm>

namespace candela {

namespace {

/// Text that tells apart what is compiled apart.
void addToKey(std::string &key, const std::string &part) {
    key += std::to_string(part.size()) + ":" + part;
}

void addToKey(std::string &key, const ir::StringValue &value) {
    addToKey(key, value.name);
    for (std::size_t k = 0; k < value.value.size(); ++k)
        value.isLeft(k) ? void(key += "*") : addToKey(key, value.value[k]);
}

std::string keyWith(std::string key, const std::vector<ir::StringValue> &strings) {
    for (const ir::StringValue &value : strings)
        addToKey(key, value);
    return key;
}

/// The strings that the record gives to parameters of that type and size.
std::vector<ir::StringValue> stringsGiven(const sl::TypedShader &shader,
                                          const ShaderRecord &record) {
    std::vector<ir::StringValue> strings;
    for (const Parameter &given : record.parameters.all)
        for (const sl::Parameter &parameter : shader.parameters)
            if (given.declaration.type == ValueType::String &&
                parameter.symbol->name == given.name &&
                parameter.symbol->type.base == sl::BaseType::String &&
                int(given.strings.size()) == std::max(1, parameter.symbol->type.length)) {
                strings.push_back({given.name, given.strings});
                break;
            }
    return strings;
}

void addOptions(const Options &options, ir::LoweringOptions &lowering, std::string &key) {
    if (options.named.string("shading:highlights", "production") == "ri") {
        lowering.highlightScale = 1;
        addToKey(key, "RI's highlights");
    }
    lowering.mostTurns = int(options.named.number("shading:loopturns", ir::mostLoopTurns));
    if (lowering.mostTurns != ir::mostLoopTurns)
        addToKey(key, "turns " + std::to_string(lowering.mostTurns));
}

} // namespace

void LoweredText::placeStrings(ShaderAnswers &answers, std::vector<float> &block) const {
    const auto &slots = shader->whole.parameters;
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        const auto given = std::ranges::find(strings, slots[slot].name, &ir::StringValue::name);
        const auto element = std::size_t(slots[slot].component);
        if (given != strings.end() && given->isLeft(element))
            block[slot] = float(answers.numberOf(given->value[element]));
    }
}

const std::set<std::string> &LoweredShaders::textsIn(const sl::TypedShader &shader) {
    const auto [entry, isNew] = texts_.try_emplace(&shader);
    if (isNew)
        for (std::string &text : ir::textsOf(shader))
            entry->second.insert(std::move(text));
    return entry->second;
}

std::vector<ir::StringValue> LoweredShaders::stringsFor(const sl::TypedShader &shader,
                                                        const ShaderRecord &record,
                                                        const Wishes &wishes) {
    std::vector<ir::StringValue> strings = stringsGiven(shader, record);
    if (wishes.told)
        for (const auto &[name, parameter] : *wishes.told)
            if (!parameter.strings.empty())
                strings.push_back({name, parameter.strings});
    if (!wishes.leavesStrings)
        return strings;
    for (ir::StringValue &given : strings)
        for (const std::string &text : given.value)
            given.leftToRunTime.push_back(!textsIn(shader).contains(text));
    return strings;
}

LoweredText LoweredShaders::find(const sl::TypedShader &shader, const ShaderRecord &record,
                                 const Options &options, const Wishes &wishes, std::string &key,
                                 DiagnosticSink &words) {
    LoweredText text{nullptr, stringsFor(shader, record, wishes)};
    ir::LoweringOptions lowering = wishes.lowering;
    addToKey(key, *shader.where.location().file + ":" + shader.name);
    std::vector<std::string> overriding;
    for (const sl::Parameter &parameter : shader.parameters)
        if (wishes.variables && wishes.variables->contains(parameter.symbol->name)) {
            addToKey(key, "variable " + parameter.symbol->name);
            overriding.push_back(parameter.symbol->name);
        }
    addOptions(options, lowering, key);

    const auto [needed, isFirst] = needed_.try_emplace(keyWith(key, text.strings));
    for (ir::StringValue &given : text.strings)
        if (needed->second.contains(given.name))
            given.leftToRunTime.clear();
    const auto known = lowered_.find(keyWith(key, text.strings));
    if (known != lowered_.end()) {
        key = known->first;
        text.shader = known->second ? &*known->second : nullptr;
        return text;
    }
    const std::vector<ir::StringValue> wanted = text.strings;
    auto made = ir::lower(shader, text.strings, overriding, words, lowering);
    for (std::size_t k = 0; k < wanted.size(); ++k)
        if (wanted[k].isLeft() && !text.strings[k].isLeft())
            needed->second.insert(wanted[k].name);
    key = keyWith(key, text.strings);
    const auto &entry = lowered_.try_emplace(key, std::move(made)).first->second;
    text.shader = entry ? &*entry : nullptr;
    return text;
}

} // namespace candela

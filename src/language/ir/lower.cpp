// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower.h"

#include "foundation/units/color.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_sources.h"
#include "language/ir/lower_defaults.h"
#include "language/ir/lower_internal.h"

#include <algorithm>

namespace candela::ir {

Lowering::Lowering(const sl::TypedShader &shader, Function &function, DiagnosticSink &sink)
    : b(function), shader(shader), function_(function), sink_(sink),
      inMemory_(computedArrays(shader)) {}

void Lowering::error(const sl::Place &where, const std::string &message) {
    failed_ = true;
    const std::string key = where.location().text() + message;
    if (reported_.insert(key).second) // Functions and loop conditions are lowered repeatedly.
        sink_.report(sl::diagnosticAt(Severity::Error, where, message));
}

std::string Lowering::requiredText(ValueId value, const sl::Place &where, const std::string &what) {
    if (const std::string *known = constantText(b, value))
        return *known;
    error(where, what + " must be known when the shader is compiled; here it depends on what "
                        "happens at run time");
    return "";
}

void Lowering::declareParameters(LoweredShader &lowered, const std::vector<StringValue> &strings,
                                 const std::vector<std::string> &variables) {
    for (size_t i = 0; i < shader.parameters.size(); ++i) {
        const sl::Symbol &symbol = *shader.parameters[i].symbol;
        ShaderParameter &parameter = lowered.parameters[i];
        Components initial;
        if (symbol.type.base == sl::BaseType::String) {
            std::vector<std::string> value = parameter.stringDefaults;
            for (const StringValue &given : strings)
                if (given.name == parameter.name)
                    value = given.value;
            value.resize(size_t(parameter.arraySize));
            for (const std::string &element : value)
                initial.push_back(text(b, element));
            declare(symbol, initial);
            continue;
        }
        const bool isVariable =
            std::find(variables.begin(), variables.end(), parameter.name) != variables.end();
        auto &slots = isVariable ? function_.variables : function_.parameters;
        const int first = int(slots.size());
        for (int c = 0; c < int(parameter.defaults.size()); ++c) {
            slots.push_back({parameter.name, c});
            initial.push_back(isVariable ? variable(b, first + c) : ir::parameter(b, first + c));
        }
        declare(symbol, initial);
    }
}

namespace {

/// What the renderer gives for a predefined variable; nothing for the others.
std::optional<ShaderInput> inputOf(sl::PredefinedId id) {
    using Id = sl::PredefinedId;
    static const std::map<Id, ShaderInput> table{
        {Id::P, ShaderInput::P},   {Id::Ps, ShaderInput::Ps},     {Id::N, ShaderInput::N},
        {Id::Ng, ShaderInput::Ng}, {Id::dPdu, ShaderInput::dPdu}, {Id::dPdv, ShaderInput::dPdv},
        {Id::I, ShaderInput::I},   {Id::E, ShaderInput::E},       {Id::Cs, ShaderInput::Cs},
        {Id::Os, ShaderInput::Os}, {Id::u, ShaderInput::u},       {Id::v, ShaderInput::v},
        {Id::du, ShaderInput::du}, {Id::dv, ShaderInput::dv},     {Id::s, ShaderInput::s},
        {Id::t, ShaderInput::t},   {Id::time, ShaderInput::time}, {Id::Du, ShaderInput::du},
        {Id::Dv, ShaderInput::dv}};
    const auto found = table.find(id);
    return found == table.end() ? std::nullopt : std::optional(found->second);
}

/// Values at the start. Oi is what Opacity says unless the shader sets it; Ci is black, so that an
/// empty shader does not glow; Ol outside of light statements is 0, in light shaders 1.
Components startOf(Lowering &lowering, const sl::PredefinedVariable &variable) {
    Builder &b = lowering.b;
    const int count = componentCount(variable.type.base);
    const bool isOi = variable.id == sl::PredefinedId::Oi;
    const auto input = isOi ? std::optional(ShaderInput::Os) : inputOf(variable.id);
    if (!input) {
        const bool isOne =
            variable.id == sl::PredefinedId::Ol && lowering.shader.kind == sl::ShaderKind::Light;
        const float start = variable.id == sl::PredefinedId::ncomps ? float(colorSamples)
                            : isOne                                 ? 1.0f
                                                                    : 0.0f;
        return Components(size_t(count), number(b, start));
    }
    Components result;
    for (int c = 0; c < count; ++c)
        result.push_back(ir::input(b, *input, c));
    return result;
}

} // namespace

void Lowering::declarePredefined() {
    for (const sl::PredefinedVariable &variable : sl::predefinedVariables()) {
        Storage storage{.base = variable.type.base};
        storage.cell = newCells(startOf(*this, variable));
        predefined_[variable.id] = storage;
    }
    for (const auto &symbol : shader.symbols)
        if (symbol->predefined)
            bind(*symbol, predefined_.at(symbol->predefined->id));
}

void Lowering::lowerBody() {
    Frame frame;
    frame.returned = newCells({boolean(b, false)});
    frames.push_back(frame);
    lower(shader.body);
    frames.pop_back();
}

void Lowering::writeOutputs(const LoweredShader &lowered) {
    const auto write = [&](const std::string &name, const Components &value) {
        for (int c = 0; c < int(value.size()); ++c)
            output(b, name, c, value[c]);
    };
    if (shader.kind == sl::ShaderKind::Surface) {
        write("Ci", predefined(sl::PredefinedId::Ci));
        write("Oi", predefined(sl::PredefinedId::Oi));
    } else {
        write("L", predefined(sl::PredefinedId::L));
        write("Cl", predefined(sl::PredefinedId::Cl));
    }
    for (const auto &symbol : shader.symbols) // The paper's bounds, where the shader sets them.
        if (symbol->predefined && symbol->written && symbol->predefined->name[1] == 'C')
            write(symbol->name, load(storageOf(*symbol)));
    for (size_t i = 0; i < lowered.parameters.size(); ++i)
        if (lowered.parameters[i].output && lowered.parameters[i].type != "string")
            write(lowered.parameters[i].name, load(storageOf(*shader.parameters[i].symbol)));
}

namespace {

/// Local arrays are written out, element by element. Formals are the arrays of their callers.
bool arraysFit(const sl::TypedShader &shader, DiagnosticSink &sink) {
    constexpr int mostNumbers = 1 << 16;
    for (const auto &symbol : shader.symbols)
        if (symbol->kind != sl::Symbol::Kind::Formal &&
            symbol->type.length > mostNumbers / std::max(1, componentCount(symbol->type.base))) {
            sink.report(sl::diagnosticAt(Severity::Error, symbol->where,
                                         "the array \"" + symbol->name + "\" is too large; " +
                                             std::to_string(mostNumbers) +
                                             " numbers are the most"));
            return false;
        }
    return true;
}

} // namespace

std::optional<LoweredShader> lower(const sl::TypedShader &shader,
                                   const std::vector<StringValue> &strings,
                                   const std::vector<std::string> &variables,
                                   DiagnosticSink &sink) {
    if (shader.kind != sl::ShaderKind::Surface && shader.kind != sl::ShaderKind::Light) {
        sink.report(sl::diagnosticAt(Severity::Error, shader.where,
                                     std::string(sl::nameOf(shader.kind)) +
                                         " shaders are not compiled yet; surface and light "
                                         "shaders are"));
        return std::nullopt;
    }
    if (!arraysFit(shader, sink))
        return std::nullopt;
    LoweredShader lowered;
    lowered.name = shader.name;
    lowered.kind = sl::nameOf(shader.kind);
    lowered.whole.name = shader.name;
    auto parameters = parametersOf(shader, strings, sink);
    if (!parameters)
        return std::nullopt;
    lowered.parameters = std::move(*parameters);

    Lowering lowering(shader, lowered.whole, sink);
    lowering.declarePredefined();
    lowering.declareParameters(lowered, strings, variables);
    lowering.lowerBody();
    lowering.writeOutputs(lowered);
    if (lowering.failed())
        return std::nullopt;
    lowering.b.finish();
    lowered.lightClass = lowering.lightClass;
    if (const auto power = lowering.lightDirection
                               ? powerOfDistance(lowered.whole, *lowering.lightDirection)
                               : std::nullopt) {
        lowered.inverseSquare = *power == (lowered.lightClass == LightClass::Local ? -2 : 0);
        lowered.directionOnly = *power == 0;
    }
    expandDerivatives(lowered.whole);
    removeUnused(lowered.whole, lowered.parameters);
    return lowered;
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/lowering.h"

#include "foundation/units/color.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/scan.h"

#include <map>

namespace candela::ir {

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
Components startOf(Builder &b, sl::ShaderKind kind, const sl::PredefinedVariable &variable) {
    const int count = componentCount(variable.type.base);
    const bool isOi = variable.id == sl::PredefinedId::Oi;
    const auto input = isOi ? std::optional(ShaderInput::Os) : inputOf(variable.id);
    if (!input) {
        const bool isOne = variable.id == sl::PredefinedId::Ol && kind == sl::ShaderKind::Light;
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

Lowering::Lowering(const sl::TypedShader &shader, const LoweringOptions &options,
                   Function &function, DiagnosticSink &sink)
    : shader(shader), options(options), b(function), messages(sink),
      variables(b, computedArrays(shader)), spaces(b, messages),
      turn(variables.newCells({number(b, 0)})) {
    for (const sl::PredefinedVariable &variable : sl::predefinedVariables())
        variables.declarePredefined(variable.id, variable.type.base,
                                    startOf(b, shader.kind, variable));
    for (const auto &symbol : shader.symbols)
        if (symbol->predefined)
            variables.bind(*symbol, variables.predefined(symbol->predefined->id));
}

std::string requiredText(Lowering &lowering, ValueId value, const sl::Place &where,
                         const std::string &what) {
    if (const std::string *known = constantText(lowering.b, value))
        return *known;
    lowering.messages.error(where, what + " must be known when the shader is compiled; here it "
                                          "depends on what happens at run time");
    return "";
}

} // namespace candela::ir

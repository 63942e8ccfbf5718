// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/lowering.h"

#include "foundation/units/color.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/scan.h"

#include <memory>
#include <optional>

namespace candela::ir {

namespace {

/// As predefined.def explains it.
struct Start {
    enum class From { Input, Captured, Number, OneIn, ColorSamples } from;
    ShaderInput input{};
    float number = 0;
    char kind = 0;
    PictureFact fact{};
    /// In imagers and volumes this input, whatever it is elsewhere.
    std::optional<ShaderInput> ofPixel{};
    std::shared_ptr<const Start> inLights{}; ///< Instead, in lights.
};

Start startOfPixel(ShaderInput input, Start elsewhere) {
    elsewhere.ofPixel = input;
    return elsewhere;
}

Start startInLights(Start lights, Start elsewhere) {
    elsewhere.inLights = std::make_shared<const Start>(std::move(lights));
    return elsewhere;
}

Start startOf(sl::PredefinedId id) {
    static const Start table[] = {
#define Given(name)                                                                                \
    { Start::From::Input, ShaderInput::name }
#define Picture(name)                                                                              \
    { Start::From::Captured, {}, 0, 0, PictureFact::name }
#define OfPixel(name, elsewhere) startOfPixel(ShaderInput::name, elsewhere)
#define InLights(lights, elsewhere) startInLights(lights, elsewhere)
#define Number(value)                                                                              \
    { Start::From::Number, {}, value }
#define OneIn(letter)                                                                              \
    { Start::From::OneIn, {}, 0, letter }
#define ColorSamples                                                                               \
    { Start::From::ColorSamples }
#define SL_PREDEFINED(name, type, detail, readable, writable, scope, start, doc) start,
#include "language/semantics/predefined.def"
#undef SL_PREDEFINED
#undef ColorSamples
#undef OneIn
#undef Number
#undef OfPixel
#undef InLights
#undef Picture
#undef Given
    };
    return table[int(id)];
}

/// Values at the start. Oi is what Opacity says unless the shader sets it; Ci is black, so that an
/// empty shader does not glow.
Components startOf(Builder &b, sl::ShaderKind kind, const sl::PredefinedVariable &variable) {
    const auto count = size_t(componentCount(b, variable.type.base));
    Start start = startOf(variable.id);
    const bool changesLight = kind == sl::ShaderKind::Imager || kind == sl::ShaderKind::Volume;
    if (changesLight && start.ofPixel)
        start = {Start::From::Input, *start.ofPixel};
    if (kind == sl::ShaderKind::Light && start.inLights)
        start = Start(*start.inLights);
    Components result;
    switch (start.from) {
    case Start::From::Input:
        for (int c = 0; c < int(count); ++c)
            result.push_back(input(b, start.input, c));
        return result;
    case Start::From::Captured: return Components(count, captured(b, int(start.fact)));
    case Start::From::Number: return Components(count, number(b, start.number));
    case Start::From::OneIn:
        return Components(count, number(b, sl::letterOf(kind) == start.kind ? 1.0f : 0.0f));
    case Start::From::ColorSamples: break;
    }
    return Components(count, number(b, float(b.colors().samples)));
}

} // namespace

Lowering::Lowering(const sl::TypedShader &shader, const LoweringOptions &options,
                   const std::vector<StringValue> &strings, Function &function,
                   DiagnosticSink &sink)
    : shader(shader), strings(strings), stringsAtRunTime(shader, strings), options(options),
      b(function, Budget(mostInstructions)), messages(sink),
      variables(b, computedArrays(shader), fixedTexts(shader)), spaces(b, messages, shader.kind),
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
    if (lowering.stringsAtRunTime.need(value))
        return "";
    lowering.messages.error(where, what + " must be known when the shader is compiled; here it "
                                          "depends on what happens at run time");
    return "";
}

} // namespace candela::ir

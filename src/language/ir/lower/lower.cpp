// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/lower.h"

#include "foundation/base/deep_stack.h"
#include "foundation/units/color.h"
#include "language/ir/analyse/falloff.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/cleanup.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/defaults.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/statement.h"
#include "language/ir/transform/jet.h"
#include "language/ir/transform/short_loops.h"

#include <algorithm>
#include <fmt/format.h>
#include <memory>
#include <set>

namespace candela::ir {

namespace {

/// The value that an instance gives the parameter, or else its default, computed here.
Components unlessGiven(Lowering &lowering, const sl::Parameter &parameter,
                       const Components &given) {
    Builder &b = lowering.b;
    auto &slots = b.function().parameters;
    const int slot = int(slots.size());
    slots.push_back({givenName(parameter.symbol->name), 0});
    const ValueId isGiven = notEqual(b, ir::parameter(b, slot), number(b, 0));
    lowering.inDefault = true;
    Components computed;
    for (const sl::ExprPtr &element : parameter.defaults)
        for (ValueId value : evaluate(lowering, *element))
            computed.push_back(value);
    lowering.inDefault = false;
    computed.resize(given.size(), number(b, 0));
    for (size_t c = 0; c < given.size(); ++c)
        computed[c] = select(b, isGiven, given[c], computed[c]);
    return computed;
}

/// Gives each parameter its cells: values of the parameter block, planes of overriding variables,
/// or strings.
void declareParameters(Lowering &lowering, LoweredShader &lowered,
                       const std::vector<StringValue> &strings,
                       const std::vector<std::string> &variables) {
    Builder &b = lowering.b;
    const sl::TypedShader &shader = lowering.shader;
    for (size_t i = 0; i < shader.parameters.size(); ++i) {
        const sl::Symbol &symbol = *shader.parameters[i].symbol;
        ShaderParameter &declared = lowered.parameters[i];
        Components initial;
        if (symbol.type.base == sl::BaseType::String) {
            StringValue value{declared.name, declared.stringDefaults};
            for (const StringValue &given : strings)
                if (given.name == declared.name)
                    value = given;
            value.value.resize(size_t(declared.arraySize));
            lowering.variables.declare(symbol, lowering.stringsAtRunTime.read(b, value));
            continue;
        }
        const bool isVariable =
            std::find(variables.begin(), variables.end(), declared.name) != variables.end();
        auto &slots = isVariable ? b.function().variables : b.function().parameters;
        const int first = int(slots.size());
        for (int c = 0; c < int(declared.defaults.size()); ++c) {
            slots.push_back({declared.name, c});
            initial.push_back(isVariable ? variable(b, first + c) : parameter(b, first + c));
        }
        if (declared.computed && !isVariable)
            initial = unlessGiven(lowering, shader.parameters[i], initial);
        lowering.variables.declare(symbol, initial);
    }
}

/// An output and the variable that holds it in the end.
struct KindOutput {
    OutputKind name;
    sl::PredefinedId variable;
};

/// What functions of the kind write.
std::vector<KindOutput> outputsOf(sl::ShaderKind kind) {
    switch (kind) {
#define SHADER_OUTPUT(name) {OutputKind::name, sl::PredefinedId::name},
#define SHADER_KIND(name, letter, text, light, runs, outputs)                                      \
    case sl::ShaderKind::name:                                                                     \
        return {outputs};
#include "language/syntax/kinds.def"
#undef SHADER_KIND
#undef SHADER_OUTPUT
    }
    return {};
}

bool sets(const sl::TypedShader &shader, sl::PredefinedId id) {
    return std::ranges::any_of(shader.symbols, [&](const auto &symbol) {
        return symbol->predefined && symbol->predefined->id == id && symbol->written;
    });
}

/// An output only where the text sets it.
bool isSetAtWill(const sl::TypedShader &shader, const sl::Symbol &predefined) {
    const bool isBound = predefined.name.size() > 1 && predefined.name[1] == 'C';
    if (isBound || shader.kind != sl::ShaderKind::Surface)
        return isBound;
    const bool isN = predefined.name == "N" && sets(shader, sl::PredefinedId::P);
    return predefined.name == "P" || isN;
}

void writeOutputs(Lowering &lowering, const LoweredShader &lowered) {
    const sl::TypedShader &shader = lowering.shader;
    Variables &variables = lowering.variables;
    const auto write = [&](const OutputName &name, const Components &value) {
        for (int c = 0; c < int(value.size()); ++c)
            output(lowering.b, name, c, value[c]);
    };
    for (const KindOutput &output : outputsOf(shader.kind))
        write(output.name, variables.load(output.variable));
    // The paper's bounds, and P of surfaces, with N, where the shader sets them.
    for (const auto &symbol : shader.symbols)
        if (symbol->predefined && symbol->written && isSetAtWill(shader, *symbol))
            write(symbol->name, variables.load(variables.storageOf(*symbol)));
    for (size_t i = 0; i < lowered.parameters.size(); ++i)
        if (lowered.parameters[i].output && lowered.parameters[i].type != "string")
            write(OutputName::ofParameter(lowered.parameters[i].name),
                  variables.load(variables.storageOf(*shader.parameters[i].symbol)));
}

/// Light shaders may read more of what they light than they are told.
void warnOfWhatLightsReadInVain(Lowering &lowering) {
    if (lowering.shader.kind != sl::ShaderKind::Light)
        return;
    for (const auto &symbol : lowering.shader.symbols)
        if (symbol->predefined && symbol->read && symbol->predefined->id == sl::PredefinedId::Cs)
            lowering.messages.warning(lowering.shader.where,
                                      "lights are not told Cs of what they light: it counts as 1");
}

/// Whether a light shader says L itself. (L = 0 is what an ambient light has anyway.)
bool saysL(Lowering &lowering) {
    if (lowering.shader.kind != sl::ShaderKind::Light ||
        !sets(lowering.shader, sl::PredefinedId::L))
        return false;
    const Components L = lowering.variables.load(sl::PredefinedId::L);
    return !std::ranges::all_of(L, [&](ValueId v) {
        const float *known = constantFloat(lowering.b, v);
        return known && *known == 0;
    });
}

/// Where a derivative stands in the text, else its line, else the shader.
Diagnostic diagnosticAt(const Lowering &lowering, const Function &function, Severity severity,
                        const SlopeNote &note) {
    const auto place = lowering.derivatives.find(note.line);
    if (place != lowering.derivatives.end())
        return sl::diagnosticAt(severity, place->second, note.text);
    Diagnostic diagnostic = sl::diagnosticAt(severity, lowering.shader.where, note.text);
    if (note.line > 0)
        diagnostic.where.line = note.line, diagnostic.where.column = 0;
    if (note.file >= 0)
        diagnostic.where.file =
            std::make_shared<const std::string>(function.files[size_t(note.file)]);
    if (note.line > 0 || note.file >= 0)
        diagnostic.sourceLine.clear();
    return diagnostic;
}

/// Tells of derivatives that are not to be had; false if one of them is an error. What a text does
/// not ask for itself it is not told of.
bool reportSlopes(const Lowering &lowering, const Function &function, const SlopeReport &report,
                  DiagnosticSink &sink) {
    if (!lowering.derivatives.empty())
        for (const SlopeNote &note : report.held)
            sink.report(diagnosticAt(lowering, function, Severity::Warning, note));
    if (report.fault)
        sink.report(diagnosticAt(lowering, function, Severity::Error, *report.fault));
    return !report.fault;
}

/// Local arrays are written out, element by element. Formals are the arrays of their callers.
bool arraysFit(const sl::TypedShader &shader, int colorSamples, DiagnosticSink &sink) {
    constexpr int mostNumbers = int(mostArrayNumbers);
    for (const auto &symbol : shader.symbols)
        if (symbol->kind != sl::Symbol::Kind::Formal &&
            symbol->type.length >
                mostNumbers / std::max(1, componentCount(symbol->type.base, colorSamples))) {
            sink.report(sl::diagnosticAt(Severity::Error, symbol->where,
                                         "the array \"" + symbol->name + "\" is too large; " +
                                             std::to_string(mostNumbers) +
                                             " numbers are the most"));
            return false;
        }
    return true;
}

/// All arrays in memory together.
bool memoryFits(const Lowering &lowering, const Function &function, DiagnosticSink &sink) {
    const size_t numbers = arrayNumbers(function);
    if (numbers <= mostArrayNumbers)
        return true;
    const sl::Symbol *largest = nullptr;
    for (const auto &symbol : lowering.shader.symbols)
        if (symbol->type.isArray() && (!largest || symbol->type.length > largest->type.length))
            largest = symbol.get();
    sink.report(sl::diagnosticAt(
        Severity::Error, largest ? largest->where : lowering.shader.where,
        fmt::format("the shader's arrays are too large together: {} numbers, with those of each "
                    "call of a function and two more for each derivative; {} are the most",
                    numbers, mostArrayNumbers)));
    return false;
}

/// Once; `needed` gets the parameters whose strings cannot be left to run time after all: then it
/// is of no use.
std::optional<LoweredShader> lowerOnce(const sl::TypedShader &shader,
                                       const std::vector<StringValue> &strings,
                                       const std::vector<std::string> &variables,
                                       std::set<std::string> &needed, DiagnosticSink &sink,
                                       const LoweringOptions &options) {
    if (!arraysFit(shader, options.colors.samples, sink))
        return std::nullopt;
    LoweredShader lowered;
    lowered.name = shader.name;
    lowered.kind = shader.kind;
    lowered.whole.name = shader.name;
    lowered.whole.mostTurns = options.mostTurns;
    lowered.whole.isEndless = sl::runsFor(shader.kind) == sl::RunsFor::Picture;
    lowered.whole.colors = options.colors;
    auto parameters = parametersOf(shader, strings, options.colors, needed, sink);
    if (!parameters || !needed.empty())
        return std::nullopt;
    lowered.parameters = std::move(*parameters);

    Lowering lowering(shader, options, strings, lowered.whole, sink);
    enter(lowering, nullptr);
    declareParameters(lowering, lowered, strings, variables);
    lower(lowering, shader.body);
    warnOfWhatLightsReadInVain(lowering);
    writeOutputs(lowering, lowered);
    const bool setsL = saysL(lowering);
    needed = lowering.stringsAtRunTime.needed();
    if (lowering.messages.failed() || !needed.empty())
        return std::nullopt;
    lowering.b.finish();
    const auto tell = [&](const char *pass) {
        if (options.listener)
            options.listener(pass, lowered.whole);
    };
    tell("lower");
    // A light that says L without illuminate() or solar() shines from a place of its own.
    lowered.lightClass = setsL && lowering.light.kind == LightClass::Ambient ? LightClass::Local
                                                                             : lowering.light.kind;
    if (const auto power = lowering.light.direction && !setsL
                               ? powerOfDistance(lowered.whole, *lowering.light.direction)
                               : std::nullopt) {
        lowered.inverseSquare = *power == (lowered.lightClass == LightClass::Local ? -2 : 0);
        lowered.directionOnly = *power == 0;
    }
    const SlopeReport slopes = expandSlopes(lowered.whole);
    if (slopes.fault && lowering.usesFootprints) { // Rather unfiltered textures than none.
        LoweringOptions less = options;
        less.footprints = false;
        return lowerOnce(shader, strings, variables, needed, sink, less);
    }
    if (!reportSlopes(lowering, lowered.whole, slopes, sink))
        return std::nullopt;
    tell("derivatives");
    removeUnused(lowered.whole, lowered.parameters);
    if (!memoryFits(lowering, lowered.whole, sink))
        return std::nullopt;
    markShortLoops(lowered.whole);
    tell("clean up");
    return lowered;
}

} // namespace

std::optional<LoweredShader> lower(const sl::TypedShader &shader, std::vector<StringValue> &strings,
                                   const std::vector<std::string> &variables, DiagnosticSink &sink,
                                   const LoweringOptions &options) {
    while (true) {
        DiagnosticList words;
        std::set<std::string> needed;
        std::optional<LoweredShader> lowered;
        onDeepStack(
            [&] { lowered = lowerOnce(shader, strings, variables, needed, words, options); });
        if (needed.empty()) {
            for (const Diagnostic &word : words.all())
                sink.report(word);
            return lowered;
        }
        for (StringValue &given : strings)
            if (needed.contains(given.name))
                given.leftToRunTime.clear();
    }
}

std::optional<LoweredShader> lower(const sl::TypedShader &shader,
                                   const std::vector<StringValue> &strings,
                                   const std::vector<std::string> &variables, DiagnosticSink &sink,
                                   const LoweringOptions &options) {
    std::vector<StringValue> left = strings;
    return lower(shader, left, variables, sink, options);
}

} // namespace candela::ir

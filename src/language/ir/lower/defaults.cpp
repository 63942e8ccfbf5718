// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/defaults.h"

#include "foundation/base/deep_stack.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/lower/cleanup.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/expression.h"
#include "language/semantics/typed_ast.h"

#include <algorithm>
#include <functional>
#include <set>

namespace candela::ir {
namespace {

/// A default with the space named around it set apart.
struct SpacedDefault {
    const sl::Expr *value;
    const sl::Expr *space = nullptr;
};

SpacedDefault splitSpace(const sl::Expr &expr) {
    const sl::Expr *inner = &expr;
    while (inner->kind == sl::ExprKind::Convert &&
           inner->operands[0]->type.base != sl::BaseType::Float)
        inner = inner->operands[0].get();
    if (inner->kind == sl::ExprKind::FromSpace && inner->type.base != sl::BaseType::Color)
        return {inner->operands[0].get(), inner->operands[1].get()};
    return {&expr};
}

bool needsRenderer(const Region &region) {
    return anyInstruction(region, [](const Instruction &i) {
        switch (info(i.op).kind) {
        case OpClass::Source:
        case OpClass::Random:
        case OpClass::Image:
        case OpClass::Light: return true;
        default: return i.op == Op::LightLoop || i.op == Op::ImageStore;
        }
    });
}

/// Runs a function without inputs; one float an output slot.
std::vector<float> runConstant(const Function &function) {
    std::vector<std::vector<float>> planes(function.outputs.size(), std::vector<float>(laneBlock));
    std::vector<float *> outputs;
    for (auto &plane : planes)
        outputs.push_back(plane.data());
    ShaderArgs args;
    args.count = 1;
    args.outputs = outputs.data();
    interpret(function, args);
    std::vector<float> result;
    for (const auto &plane : planes)
        result.push_back(plane[0]);
    return result;
}

/// The components of a value that is written in numbers alone.
std::optional<std::vector<float>> literal(const sl::Expr &expr, int samples) {
    std::vector<float> result;
    if (expr.kind == sl::ExprKind::Number)
        return std::vector{float(expr.number)};
    if (expr.kind != sl::ExprKind::Negate && expr.kind != sl::ExprKind::Tuple &&
        expr.kind != sl::ExprKind::Convert)
        return {};
    for (const sl::ExprPtr &operand : expr.operands) {
        const auto part = literal(*operand, samples);
        if (!part)
            return {};
        result.insert(result.end(), part->begin(), part->end());
    }
    const size_t count = size_t(componentCount(expr.type.base, samples));
    if (expr.kind == sl::ExprKind::Negate)
        std::transform(result.begin(), result.end(), result.begin(), std::negate<>());
    else if (result.size() == 1 && count == 3)
        result.assign(count, result[0]);
    return result.size() == count ? std::optional(result) : std::nullopt;
}

/// Adds the variables that the expression names; does it call a function of the source?
bool collectNamed(const sl::Expr &expr, std::set<const sl::Symbol *> &named) {
    bool calls = expr.kind == sl::ExprKind::Call;
    if (expr.symbol)
        named.insert(expr.symbol);
    for (const sl::ExprPtr &operand : expr.operands)
        calls = collectNamed(*operand, named) || calls;
    return calls;
}

/// Whether a default depends on the point, on other parameters or on spaces that are not around all
/// of it: then the shader computes it where it starts.
bool isComputed(const sl::Expr &expr) {
    if (const sl::Symbol *symbol = expr.symbol) {
        const bool isText = symbol->type.base == sl::BaseType::String;
        return symbol->kind == sl::Symbol::Kind::Predefined ||
               (symbol->kind == sl::Symbol::Kind::Parameter && !isText);
    }
    if (expr.kind == sl::ExprKind::FromSpace && expr.type.base != sl::BaseType::Color)
        return true;
    if (expr.kind == sl::ExprKind::Builtin) {
        const sl::Lowering means = expr.overload->function->lowering;
        if (expr.overload->function->id == sl::BuiltinId::random || means == sl::Lowering::Light ||
            means == sl::Lowering::Derive || means == sl::Lowering::Context)
            return true;
    }
    return std::ranges::any_of(expr.operands,
                               [](const sl::ExprPtr &operand) { return isComputed(*operand); });
}

class Defaults {
public:
    Defaults(const sl::TypedShader &shader, const std::vector<StringValue> &strings,
             const ColorBasis &colors, std::set<std::string> &needed, DiagnosticSink &sink)
        : shader_(shader), strings_(strings), colors_(colors), needed_(needed), sink_(sink) {
        for (StringValue &given : known_)
            given.leftToRunTime.clear();
    }

    bool add(const sl::Parameter &parameter) {
        const sl::Symbol &symbol = *parameter.symbol;
        ShaderParameter result;
        result.name = symbol.name;
        result.type = sl::nameOf(symbol.type.base);
        result.arraySize = std::max(1, symbol.type.length);
        result.output = symbol.output;
        result.varying = symbol.type.isVarying();
        const bool good = evaluateDefault(parameter, result);
        parameters.push_back(std::move(result));
        return good;
    }

    std::vector<ShaderParameter> parameters;

private:
    /// The space around all elements of a default. If there is none, "shader"; but a matrix leads
    /// from current space wherever it leads.
    std::optional<std::string> spaceOf(const sl::Parameter &parameter, Lowering &lowering) {
        const bool isMatrix = parameter.symbol->type.base == sl::BaseType::Matrix;
        std::optional<std::string> space;
        for (const sl::ExprPtr &element : parameter.defaults) {
            const SpacedDefault split = splitSpace(*element);
            const std::string name =
                split.space ? requiredText(lowering, evaluate(lowering, *split.space)[0],
                                           split.space->where, "the name of a space")
                : isMatrix  ? "current"
                            : "shader";
            if (space && *space != name)
                lowering.messages.error(element->where,
                                        "the elements of a default must be in one space; "
                                        "these are in \"" +
                                            *space + "\" and \"" + name + "\"");
            space = name;
        }
        return space;
    }

    /// Those that the default names: of thousands of parameters mostly none.
    void declareEarlier(const sl::Parameter &parameter, Lowering &lowering) {
        std::set<const sl::Symbol *> named;
        bool anyMay = false; // Functions may name some too.
        for (const sl::ExprPtr &element : parameter.defaults)
            anyMay = collectNamed(*element, named) || anyMay;
        for (size_t i = 0; i < parameters.size() && (anyMay || !named.empty()); ++i) {
            if (!anyMay && !named.contains(shader_.parameters[i].symbol))
                continue;
            const ShaderParameter &earlier = parameters[i];
            Components values;
            for (float value : earlier.defaults)
                values.push_back(number(lowering.b, value));
            std::vector<std::string> texts = earlier.stringDefaults;
            for (const StringValue &given : strings_)
                if (given.name == earlier.name && earlier.type == "string") {
                    texts = given.value;
                    if (given.isLeft())
                        needed_.insert(given.name);
                }
            if (earlier.type == "string")
                texts.resize(size_t(earlier.arraySize));
            for (const std::string &element : texts)
                values.push_back(text(lowering.b, element));
            lowering.variables.declare(*shader_.parameters[i].symbol, values);
        }
    }

    /// Strings that are written as such.
    static bool takeTexts(const sl::Parameter &parameter, ShaderParameter &result) {
        std::vector<std::string> texts;
        for (const sl::ExprPtr &element : parameter.defaults) {
            if (element->kind != sl::ExprKind::Text)
                return false;
            texts.push_back(element->text);
        }
        texts.resize(size_t(std::max(1, parameter.symbol->type.length)));
        result.stringDefaults = std::move(texts);
        return true;
    }

    /// What nearly all shaders have, and some have thousands of: numbers and strings. (What a
    /// matrix leads to depends on the space that is named with it, and other samples of colours on
    /// their uplift.)
    bool takeLiterals(const sl::Parameter &parameter, ShaderParameter &result) const {
        const sl::Type &type = parameter.symbol->type;
        if (type.base == sl::BaseType::String)
            return takeTexts(parameter, result);
        if (type.base == sl::BaseType::Matrix ||
            (type.base == sl::BaseType::Color && colors_.samples != 3))
            return false;
        std::vector<float> values;
        for (const sl::ExprPtr &element : parameter.defaults) {
            const auto value = literal(*element, colors_.samples);
            if (!value)
                return false;
            values.insert(values.end(), value->begin(), value->end());
        }
        values.resize(
            size_t(componentCount(type.base, colors_.samples) * std::max(1, type.length)));
        result.defaults = std::move(values);
        return true;
    }

    static void leaveToShader(int numbers, ShaderParameter &result) {
        result.computed = true;
        result.defaults.assign(size_t(numbers), 0);
    }

    bool evaluateDefault(const sl::Parameter &parameter, ShaderParameter &result) {
        if (takeLiterals(parameter, result))
            return true;
        const sl::Symbol &symbol = *parameter.symbol;
        const int numbers = componentCount(symbol.type.base, colors_.samples) * result.arraySize;
        const bool isText = symbol.type.base == sl::BaseType::String;
        if (!isText && std::ranges::any_of(parameter.defaults, [](const sl::ExprPtr &element) {
                return isComputed(*splitSpace(*element).value);
            })) {
            leaveToShader(numbers, result);
            return true;
        }
        Function function;
        function.name = shader_.name;
        function.colors = colors_;
        Lowering lowering(shader_, {}, known_, function, sink_);
        lowering.spaces.allowShaderOnly();
        declareEarlier(parameter, lowering);
        enter(lowering, nullptr);

        if (const auto space = spaceOf(parameter, lowering))
            result.defaultSpace = *space;
        Components values = zero(lowering.b, symbol.type.base, symbol.type.length);
        size_t next = 0;
        for (const sl::ExprPtr &element : parameter.defaults)
            for (ValueId value : evaluate(lowering, *splitSpace(*element).value))
                if (next < values.size())
                    values[next++] = value;
        if (symbol.type.base == sl::BaseType::String) {
            for (ValueId value : values)
                result.stringDefaults.push_back(
                    requiredText(lowering, value, symbol.where, "the default of a string"));
            return !lowering.messages.failed();
        }
        for (int i = 0; i < int(values.size()); ++i)
            output(lowering.b, "default", i, values[i]);
        lowering.b.finish();
        std::vector<ShaderParameter> none;
        removeUnused(function, none);
        if (lowering.messages.failed())
            return false;
        if (needsRenderer(function.body)) {
            leaveToShader(numbers, result);
            return true;
        }
        result.defaults = runConstant(function);
        return true;
    }

    const sl::TypedShader &shader_;
    const std::vector<StringValue> &strings_;
    std::vector<StringValue> known_ = strings_; ///< None left to run time.
    const ColorBasis &colors_;
    std::set<std::string> &needed_;
    DiagnosticSink &sink_;
};

} // namespace

std::optional<std::vector<ShaderParameter>>
parametersOf(const sl::TypedShader &shader, const std::vector<StringValue> &strings,
             const ColorBasis &colors, std::set<std::string> &needed, DiagnosticSink &sink) {
    Defaults defaults(shader, strings, colors, needed, sink);
    bool good = true;
    for (const sl::Parameter &parameter : shader.parameters)
        good = defaults.add(parameter) && good;
    if (!good)
        return std::nullopt;
    return std::move(defaults.parameters);
}

std::optional<std::vector<ShaderParameter>>
parametersOf(const sl::TypedShader &shader, const ColorBasis &colors, DiagnosticSink &sink) {
    std::optional<std::vector<ShaderParameter>> parameters;
    std::set<std::string> none;
    onDeepStack([&] { parameters = parametersOf(shader, {}, colors, none, sink); });
    return parameters;
}

} // namespace candela::ir

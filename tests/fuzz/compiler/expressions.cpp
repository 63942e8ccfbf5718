// SPDX-License-Identifier: Apache-2.0
#include "expressions.h"

#include "language/semantics/builtins.h"
#include "language/semantics/predefined.h"

#include <algorithm>
#include <array>
#include <vector>

namespace candela::fuzz {

namespace {

using sl::BaseType;
using TypeTable = std::array<std::vector<const sl::BuiltinOverload *>, sl::baseTypeCount>;

bool isUsable(const sl::BuiltinOverload &overload) {
    return overload.function->available == sl::Available::Now &&
           std::ranges::none_of(overload.parameters,
                                [](const auto &p) { return p.output || p.array; });
}

const std::vector<const sl::BuiltinOverload *> &functionsOf(BaseType result) {
    static const TypeTable table = [] {
        TypeTable made;
        for (const sl::Builtin &function : sl::builtins())
            for (const sl::BuiltinOverload &overload : function.overloads)
                if (isUsable(overload))
                    made[std::size_t(overload.result)].push_back(&overload);
        return made;
    }();
    return table[std::size_t(result)];
}

const std::vector<std::string> &variablesOf(BaseType type) {
    static const auto table = [] {
        std::array<std::vector<std::string>, sl::baseTypeCount> made;
        for (const sl::PredefinedVariable &variable : sl::predefinedVariables())
            if (variable.readableIn(sl::ShaderKind::Surface) &&
                variable.scope == sl::PredefinedScope::Shader)
                made[std::size_t(variable.type.base)].push_back(variable.name);
        return made;
    }();
    return table[std::size_t(type)];
}

/// The same at all points.
std::string constantOf(BaseType type, Chance &chance) {
    constexpr const char *numbers[] = {"0",     "1",   "-1",  ".5",   "2",    "3",
                                       "-0.25", "7.5", "100", "1e-3", "1e20", "PI"};
    constexpr const char *strings[] = {"\"world\"", "\"shader\"", "\"object\"", "\"current\"",
                                       "\"hsv\"",   "\"%f\"",     "\"\"",       "\"a.*b\""};
    const std::string number = chance.pick(numbers);
    switch (type) {
    case BaseType::String: return chance.pick(strings);
    case BaseType::Float: return number;
    case BaseType::Matrix: return "matrix " + number;
    default:
        return std::string(sl::nameOf(type)) + "(" + number + ", " + chance.pick(numbers) + ", " +
               chance.pick(numbers) + ")";
    }
}

std::string leafOf(BaseType type, Chance &chance) {
    const std::vector<std::string> &variables = variablesOf(type);
    return variables.empty() || chance.oneIn(3) ? constantOf(type, chance) : chance.pick(variables);
}

std::string callOf(const sl::BuiltinOverload &overload, int height, Chance &chance) {
    std::string arguments;
    const auto add = [&](const sl::BuiltinParameter &parameter) {
        const BaseType type = parameter.anyType ? BaseType::Float : parameter.type;
        arguments += (arguments.empty() ? "" : ", ") +
                     (parameter.uniform ? constantOf(type, chance)
                                        : randomExpression(type, height - 1, chance));
    };
    for (const sl::BuiltinParameter &parameter : overload.parameters)
        add(parameter);
    for (std::size_t n = overload.repeatsLast ? chance.below(5) : 0; n > 0; --n)
        add(overload.parameters.back());
    const std::string cast = sl::isTriple(overload.result) ? sl::nameOf(overload.result) : "";
    return cast + " " + overload.function->name + "(" + arguments + ")";
}

std::string operationOf(BaseType type, int height, Chance &chance) {
    constexpr const char *arithmetic[] = {" + ", " - ", " * ", " / "};
    constexpr const char *relations[] = {" < ", " <= ", " == ", " != "};
    const auto operand = [&](BaseType of) { return randomExpression(of, height - 1, chance); };
    if (chance.oneIn(4))
        return "(" + operand(BaseType::Float) + chance.pick(relations) + operand(BaseType::Float) +
               " ? " + operand(type) + " : " + operand(type) + ")";
    if (type == BaseType::Float && chance.oneIn(4))
        return "(" + operand(BaseType::Vector) + " . " + operand(BaseType::Normal) + ")";
    if (type == BaseType::Vector && chance.oneIn(3))
        return "(" + operand(BaseType::Vector) + " ^ " + operand(BaseType::Vector) + ")";
    return "(" + operand(type) + chance.pick(arithmetic) + operand(type) + ")";
}

} // namespace

std::string randomExpression(BaseType type, int height, Chance &chance) {
    if (height <= 0 || chance.oneIn(6))
        return leafOf(type, chance);
    const auto &functions = functionsOf(type);
    const bool calls = type == BaseType::String || chance.oneIn(2);
    if (calls && !functions.empty())
        return callOf(*chance.pick(functions), height, chance);
    return type == BaseType::String ? leafOf(type, chance) : operationOf(type, height, chance);
}

std::string randomStatement(Chance &chance) {
    constexpr BaseType types[] = {BaseType::Float,  BaseType::Color,  BaseType::Point,
                                  BaseType::Vector, BaseType::Normal, BaseType::Matrix};
    const BaseType type = chance.pick(types);
    const std::string value = randomExpression(type, 1 + int(chance.below(4)), chance);
    const std::string color =
        type == BaseType::Matrix ? "determinant(" + value + ")" : "color(" + value + ")";
    std::string condition;
    if (chance.oneIn(4))
        condition = "if (" + randomExpression(BaseType::Float, 2, chance) + " < u) ";
    constexpr const char *targets[] = {"Ci += ", "Ci = ", "Ci *= ", "Oi *= "};
    return condition + chance.pick(targets) + color + ";";
}

} // namespace candela::fuzz

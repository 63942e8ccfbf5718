// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"

#include <numbers>

namespace candela::ir {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// What a function does to floats, component by component; floats among the arguments stand for all
/// components.
template <Components (*ofFloats)(BuiltinCall &)> Components each(BuiltinCall &call) {
    size_t width = 1;
    for (const Components &argument : call.arguments)
        width = std::max(width, argument.size());
    Components result;
    for (size_t c = 0; c < width; ++c) {
        BuiltinCall one{call.lowering, call.b, call.expr, {}};
        for (const Components &argument : call.arguments)
            one.arguments.push_back({argument[argument.size() == 1 ? 0 : c]});
        result.push_back(ofFloats(one)[0]);
    }
    return result;
}

/// One operation on each component; scalars stand for all components.
template <class Operation>
Components map(const Components &x, const Components &y, Operation operation) {
    Components result;
    for (size_t i = 0; i < std::max(x.size(), y.size()); ++i)
        result.push_back(operation(x[x.size() == 1 ? 0 : i], y[y.size() == 1 ? 0 : i]));
    return result;
}

template <Op op> Components unary(BuiltinCall &call) { return {unary(call.b, op, call.number(0))}; }

Components radians(BuiltinCall &call) {
    return {mul(call.b, call.number(0), number(call.b, pi / 180))};
}

Components degrees(BuiltinCall &call) {
    return {mul(call.b, call.number(0), number(call.b, 180 / pi))};
}

Components atan(BuiltinCall &call) {
    if (call.count() == 1)
        return unary<Op::Atan>(call);
    return {binary(call.b, Op::Atan2, call.number(0), call.number(1))};
}

Components pow(BuiltinCall &call) { return {pow(call.b, call.number(0), call.number(1))}; }

Components inversesqrt(BuiltinCall &call) {
    return {div(call.b, number(call.b, 1), sqrt(call.b, call.number(0)))};
}

Components log(BuiltinCall &call) {
    const ValueId natural = unary(call.b, Op::Log, call.number(0));
    if (call.count() == 1)
        return {natural};
    return {div(call.b, natural, unary(call.b, Op::Log, call.number(1)))};
}

/// The quotient is rounded, so that x - period floor(x / period) may lie outside of [0, period), or
/// on its end: there the nearest number inside stands for it, and it changes as it would.
Components mod(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0), period = call.number(1), zero = number(b, 0);
    const ValueId rest = sub(b, x, mul(b, period, unary(b, Op::Floor, div(b, x, period))));
    // The number next to the period on the side of zero; exactly, as products are rounded.
    const ValueId last = mul(b, period, number(b, 1 - 0x1p-24f));
    const ValueId inside = min(b, max(b, zero, last), max(b, min(b, zero, last), rest));
    return {binary(b, Op::Sloped, inside, rest)};
}

Components sign(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0), zero = number(b, 0);
    return {
        select(b, less(b, x, zero), number(b, -1), unary(b, Op::FloatFromBool, less(b, zero, x)))};
}

/// Halves go away from zero.
Components round(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0);
    const ValueId size = unary(b, Op::Round, unary(b, Op::Abs, x));
    return {select(b, less(b, x, number(b, 0)), neg(b, size), size)};
}

template <Op op> Components extreme(BuiltinCall &call) {
    Components result = call.arguments[0];
    for (size_t i = 1; i < call.count(); ++i)
        result = map(result, call.arguments[i],
                     [&](ValueId x, ValueId y) { return binary(call.b, op, x, y); });
    return result;
}

/// The lower bound is tested first: it wins where it is above the upper one.
ValueId clamp(Builder &b, ValueId x, ValueId low, ValueId high) {
    const float *least = constantFloat(b, low), *most = constantFloat(b, high);
    if (least && most && *least <= *most) // The form that analyses know.
        return min(b, max(b, x, low), high);
    return select(b, less(b, x, low), low, min(b, x, high));
}

Components clamp(BuiltinCall &call) {
    Components result;
    for (size_t i = 0; i < call.arguments[0].size(); ++i)
        result.push_back(
            clamp(call.b, call.arguments[0][i], call.arguments[1][i], call.arguments[2][i]));
    return result;
}

Components step(BuiltinCall &call) {
    Builder &b = call.b;
    return {select(b, less(b, call.number(1), call.number(0)), number(b, 0), number(b, 1))};
}

Components smoothstep(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId low = call.number(0), high = call.number(1), x = call.number(2);
    const ValueId t = div(b, sub(b, x, low), sub(b, high, low));
    const ValueId cubic = mul(b, mul(b, t, t), sub(b, number(b, 3), mul(b, number(b, 2), t)));
    const ValueId upper = select(b, lessEqual(b, high, x), number(b, 1), cubic);
    return {select(b, less(b, x, low), number(b, 0), upper)};
}

Components mix(BuiltinCall &call) {
    Builder &b = call.b;
    const Components &alpha = call.arguments[2];
    const auto times = [&](ValueId x, ValueId y) { return mul(b, x, y); };
    const Components rest =
        map({number(b, 1)}, alpha, [&](ValueId one, ValueId a) { return sub(b, one, a); });
    return map(map(call.arguments[0], rest, times), map(call.arguments[1], alpha, times),
               [&](ValueId x, ValueId y) { return add(b, x, y); });
}

Components random(BuiltinCall &call) {
    Components result;
    for (int i = 0; i < componentCount(call.b, call.result()); ++i)
        result.push_back(random(call.b, call.lowering.variables.cells[call.lowering.turn]));
    return result;
}

} // namespace

BuiltinLowering mathsBuiltin(sl::BuiltinId id) {
    using Id = sl::BuiltinId;
    static const std::map<Id, BuiltinLowering> table{{Id::radians, radians},
                                                     {Id::degrees, degrees},
                                                     {Id::sin, unary<Op::Sin>},
                                                     {Id::asin, unary<Op::Asin>},
                                                     {Id::cos, unary<Op::Cos>},
                                                     {Id::acos, unary<Op::Acos>},
                                                     {Id::tan, unary<Op::Tan>},
                                                     {Id::atan, atan},
                                                     {Id::pow, each<pow>},
                                                     {Id::exp, each<unary<Op::Exp>>},
                                                     {Id::sqrt, each<unary<Op::Sqrt>>},
                                                     {Id::inversesqrt, each<inversesqrt>},
                                                     {Id::log, each<log>},
                                                     {Id::mod, each<mod>},
                                                     {Id::abs, each<unary<Op::Abs>>},
                                                     {Id::sign, each<sign>},
                                                     {Id::min, extreme<Op::Min>},
                                                     {Id::max, extreme<Op::Max>},
                                                     {Id::clamp, clamp},
                                                     {Id::floor, each<unary<Op::Floor>>},
                                                     {Id::ceil, each<unary<Op::Ceil>>},
                                                     {Id::round, each<round>},
                                                     {Id::step, each<step>},
                                                     {Id::smoothstep, each<smoothstep>},
                                                     {Id::mix, mix},
                                                     {Id::random, random}};
    const auto found = table.find(id);
    return found == table.end() ? nullptr : found->second;
}

} // namespace candela::ir

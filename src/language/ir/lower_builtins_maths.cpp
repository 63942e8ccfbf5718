// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower_internal.h"

#include <numbers>

namespace candela::ir {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// One operation on each component; scalars stand for all components.
template <class Operation>
Components map(const Components &x, const Components &y, Operation operation) {
    Components result;
    for (size_t i = 0; i < std::max(x.size(), y.size()); ++i)
        result.push_back(operation(x[x.size() == 1 ? 0 : i], y[y.size() == 1 ? 0 : i]));
    return result;
}

template <Op op> Components unary(BuiltinCall &call) { return {call.b.unary(op, call.number(0))}; }

Components radians(BuiltinCall &call) {
    return {call.b.mul(call.number(0), call.b.number(pi / 180))};
}

Components degrees(BuiltinCall &call) {
    return {call.b.mul(call.number(0), call.b.number(180 / pi))};
}

Components atan(BuiltinCall &call) {
    if (call.count() == 1)
        return unary<Op::Atan>(call);
    return {call.b.binary(Op::Atan2, call.number(0), call.number(1))};
}

Components pow(BuiltinCall &call) { return {call.b.pow(call.number(0), call.number(1))}; }

Components inversesqrt(BuiltinCall &call) {
    return {call.b.div(call.b.number(1), call.b.sqrt(call.number(0)))};
}

Components log(BuiltinCall &call) {
    const ValueId natural = call.b.unary(Op::Log, call.number(0));
    if (call.count() == 1)
        return {natural};
    return {call.b.div(natural, call.b.unary(Op::Log, call.number(1)))};
}

Components mod(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0), period = call.number(1);
    return {b.sub(x, b.mul(period, b.unary(Op::Floor, b.div(x, period))))};
}

Components sign(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0), zero = b.number(0);
    return {b.select(b.less(x, zero), b.number(-1), b.unary(Op::FloatFromBool, b.less(zero, x)))};
}

/// Halves go away from zero.
Components round(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId x = call.number(0);
    const ValueId size = b.unary(Op::Round, b.unary(Op::Abs, x));
    return {b.select(b.less(x, b.number(0)), b.neg(size), size)};
}

template <Op op> Components extreme(BuiltinCall &call) {
    Components result = call.arguments[0];
    for (size_t i = 1; i < call.count(); ++i)
        result = map(result, call.arguments[i],
                     [&](ValueId x, ValueId y) { return call.b.binary(op, x, y); });
    return result;
}

Components clamp(BuiltinCall &call) {
    Builder &b = call.b;
    const Components atLeast = map(call.arguments[0], call.arguments[1],
                                   [&](ValueId x, ValueId low) { return b.max(x, low); });
    return map(atLeast, call.arguments[2], [&](ValueId x, ValueId high) { return b.min(x, high); });
}

Components step(BuiltinCall &call) {
    Builder &b = call.b;
    return {b.select(b.less(call.number(1), call.number(0)), b.number(0), b.number(1))};
}

Components smoothstep(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId low = call.number(0), high = call.number(1), x = call.number(2);
    const ValueId t = b.div(b.sub(x, low), b.sub(high, low));
    const ValueId cubic = b.mul(b.mul(t, t), b.sub(b.number(3), b.mul(b.number(2), t)));
    const ValueId upper = b.select(b.lessEqual(high, x), b.number(1), cubic);
    return {b.select(b.less(x, low), b.number(0), upper)};
}

Components mix(BuiltinCall &call) {
    Builder &b = call.b;
    const Components &alpha = call.arguments[2];
    const auto times = [&](ValueId x, ValueId y) { return b.mul(x, y); };
    const Components rest =
        map({b.number(1)}, alpha, [&](ValueId one, ValueId a) { return b.sub(one, a); });
    return map(map(call.arguments[0], rest, times), map(call.arguments[1], alpha, times),
               [&](ValueId x, ValueId y) { return b.add(x, y); });
}

Components random(BuiltinCall &call) {
    Components result;
    for (int i = 0; i < componentCount(call.result()); ++i)
        result.push_back(call.b.random());
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
                                                     {Id::pow, pow},
                                                     {Id::exp, unary<Op::Exp>},
                                                     {Id::sqrt, unary<Op::Sqrt>},
                                                     {Id::inversesqrt, inversesqrt},
                                                     {Id::log, log},
                                                     {Id::mod, mod},
                                                     {Id::abs, unary<Op::Abs>},
                                                     {Id::sign, sign},
                                                     {Id::min, extreme<Op::Min>},
                                                     {Id::max, extreme<Op::Max>},
                                                     {Id::clamp, clamp},
                                                     {Id::floor, unary<Op::Floor>},
                                                     {Id::ceil, unary<Op::Ceil>},
                                                     {Id::round, round},
                                                     {Id::step, step},
                                                     {Id::smoothstep, smoothstep},
                                                     {Id::mix, mix},
                                                     {Id::random, random}};
    const auto found = table.find(id);
    return found == table.end() ? nullptr : found->second;
}

} // namespace candela::ir

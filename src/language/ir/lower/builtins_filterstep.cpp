// SPDX-License-Identifier: Apache-2.0
// filterstep(): the convolution of a step with a pixel filter, as wide as the extent of x.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/place_scope.h"

#include <numbers>

namespace candela::ir {
namespace {

/// The integral of a filter from its centre to `t` >= 0, in extents of x: 1/2 at its end.
using HalfIntegral = ValueId (*)(Builder &, ValueId t);

ValueId times(Builder &b, float factor, ValueId x) { return mul(b, number(b, factor), x); }

ValueId box(Builder &b, ValueId t) { return min(b, t, number(b, 0.5f)); }

/// Of two extents, falling linearly.
ValueId triangle(Builder &b, ValueId t) {
    const ValueId x = min(b, t, number(b, 1));
    return sub(b, x, times(b, 0.5f, mul(b, x, x)));
}

/// Of four extents: Keys' kernel with a = -1/2, piecewise cubic.
ValueId catmullRom(Builder &b, ValueId t) {
    const ValueId x = min(b, t, number(b, 2));
    const ValueId square = mul(b, x, x), cube = mul(b, square, x), fourth = mul(b, square, square);
    const ValueId inner = add(b, sub(b, x, times(b, 5.0f / 6, cube)), times(b, 3.0f / 8, fourth));
    const ValueId outer = sub(b, add(b, times(b, 2, sub(b, x, square)), times(b, 5.0f / 6, cube)),
                              times(b, 1.0f / 8, fourth));
    // 13/24 up to x = 1, from where the outer part begins at 17/24.
    return select(b, less(b, x, number(b, 1)), inner, add(b, outer, number(b, -1.0f / 6)));
}

/// Of two extents: exp(-2 x^2), as RI has it. Error function: Abramowitz and Stegun 7.1.26.
ValueId gaussian(Builder &b, ValueId t) {
    constexpr float root2 = std::numbers::sqrt2_v<float>, erfOfRoot2 = 0.9544997361f;
    constexpr float coefficients[] = {1.061405429f, -1.453152027f, 1.421413741f, -0.284496736f,
                                      0.254829592f};
    const ValueId x = times(b, root2, min(b, t, number(b, 1)));
    const ValueId one = number(b, 1);
    const ValueId k = div(b, one, add(b, one, times(b, 0.3275911f, x)));
    ValueId polynomial = number(b, 0);
    for (float c : coefficients)
        polynomial = mul(b, add(b, polynomial, number(b, c)), k);
    const ValueId tail = mul(b, polynomial, unary(b, Op::Exp, neg(b, mul(b, x, x))));
    return times(b, 0.5f / erfOfRoot2, sub(b, one, tail));
}

struct Filter {
    const char *name;
    HalfIntegral integral;
};
constexpr Filter filters[] = {
    {"catmull-rom", catmullRom}, {"box", box}, {"triangle", triangle}, {"gaussian", gaussian}};

HalfIntegral filterNamed(BuiltinCall &call, size_t argument) {
    const std::string name = call.text(argument, "the name of a filter");
    for (const Filter &filter : filters)
        if (name == filter.name)
            return filter.integral;
    call.lowering.messages.warning(call.expr.operands[argument]->where,
                                   "filterstep() has no filter \"" + name +
                                       "\": taking \"catmull-rom\"; known are box, triangle, "
                                       "catmull-rom and gaussian");
    return catmullRom;
}

/// How far x goes over the sampled region.
ValueId extentOf(Builder &b, ValueId x) {
    const auto along = [&](Direction direction, ShaderInput step) {
        return unary(b, Op::Abs, mul(b, slope(b, x, direction), input(b, step)));
    };
    return add(b, along(Direction::U, ShaderInput::du), along(Direction::V, ShaderInput::dv));
}

/// (edge, x) or (edge, x0, x1), and pairs of a name and a value.
Components filterstep(BuiltinCall &call) {
    Builder &b = call.b;
    const PlaceScope place(b, call.expr.where);
    const bool isSpan = call.count() > 2 && !call.isText(2);
    const ValueId first = call.number(1), last = isSpan ? call.number(2) : first;
    const ValueId x = isSpan ? times(b, 0.5f, add(b, first, last)) : first;
    ValueId extent = isSpan ? unary(b, Op::Abs, sub(b, last, first)) : extentOf(b, x);
    HalfIntegral integral = catmullRom;
    for (size_t i = isSpan ? 3 : 2; i + 1 < call.count(); i += 2) {
        const std::string name = call.text(i, "the name of an argument");
        if (name == "filter")
            integral = filterNamed(call, i + 1);
        else if (name == "width" && call.expr.operands[i + 1]->type.base == sl::BaseType::Float)
            extent = mul(b, extent, call.number(i + 1));
        else if (name == "width")
            call.lowering.messages.error(call.expr.operands[i + 1]->where,
                                         "\"width\" takes a float");
    }
    const ValueId zero = number(b, 0), half = number(b, 0.5f), one = number(b, 1);
    const ValueId beyond = sub(b, x, call.number(0));
    const ValueId part = integral(b, div(b, unary(b, Op::Abs, beyond), extent));
    const ValueId isBefore = less(b, beyond, zero);
    const ValueId filtered = add(b, half, select(b, isBefore, neg(b, part), part));
    return {select(b, less(b, zero, extent), filtered, select(b, isBefore, zero, one))};
}

} // namespace

BuiltinLowering filterstepBuiltin(sl::BuiltinId id) {
    return id == sl::BuiltinId::filterstep ? filterstep : nullptr;
}

} // namespace candela::ir

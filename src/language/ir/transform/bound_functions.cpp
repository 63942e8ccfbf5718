// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_functions.h"

#include "language/ir/core/builder_sources.h"

#include <limits>
#include <numbers>

namespace candela::ir {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float endless = std::numeric_limits<float>::infinity();

ValueId oneLess(Builder &b, ValueId x) { return sub(b, number(b, 1), x); }
ValueId squareOf(Builder &b, ValueId x) { return mul(b, x, x); }

/// Where f(x) - slope x has an extreme beside the middle, and f there.
struct Place {
    ValueId where, there;
};

FormParts chain(Builder &b, Op op, const BoundedValue &x, ValueId middle, ValueId slope,
                const Place &place) {
    const FormParts f = formOf(b, x);
    return callBound(
        b, RuntimeFunction::bound_chain, {x},
        {middle, slope, unary(b, op, f.least), unary(b, op, f.greatest), place.where, place.there});
}

/// The function is even or odd about 0, but for a constant: at -x it changes as at x.
Place mirrored(Builder &b, const BoundedValue &x, ValueId there) {
    return {neg(b, x.middle), there};
}

FormParts unlessOutside(Builder &b, const BoundedValue &x, float most, const FormParts &inside) {
    const FormParts f = formOf(b, x);
    const ValueId isInside =
        both(b, less(b, number(b, -most), f.least), less(b, f.greatest, number(b, most)));
    return select(b, isInside, inside, unknownForm(b));
}

/// asin and acos stand still outside of [-1, 1]: there nothing is said but the range.
ValueId slopeOfArc(Builder &b, const BoundedValue &x) {
    const FormParts f = formOf(b, x), one = formOf(b, {number(b, 1)});
    const ValueId isOutside =
        either(b, less(b, f.least, neg(b, one.least)), less(b, one.least, f.greatest));
    const ValueId slope = div(b, number(b, 1), sqrt(b, oneLess(b, squareOf(b, x.middle))));
    return select(b, isOutside, number(b, 0), slope);
}

} // namespace

FormParts boundOfStep(Builder &b, Op op, const BoundedValue &x, ValueId middle) {
    const FormParts f = formOf(b, x);
    return rangeForm(b, middle, unary(b, op, f.least), unary(b, op, f.greatest));
}

FormParts boundOfMonotone(Builder &b, Op op, const BoundedValue &x, ValueId middle) {
    const ValueId one = number(b, 1), zero = number(b, 0);
    const Place here{x.middle, middle};
    switch (op) {
    case Op::Sqrt: {
        const ValueId isCut = less(b, formOf(b, x).least, zero);
        const ValueId slope = div(b, number(b, 0.5f), middle);
        return chain(b, op, x, middle, select(b, isCut, zero, slope), here);
    }
    case Op::Exp: return chain(b, op, x, middle, middle, here);
    case Op::Log: return chain(b, op, x, middle, div(b, one, x.middle), here);
    case Op::Asin: return chain(b, op, x, middle, slopeOfArc(b, x), mirrored(b, x, neg(b, middle)));
    case Op::Acos:
        return chain(b, op, x, middle, neg(b, slopeOfArc(b, x)),
                     mirrored(b, x, sub(b, number(b, pi), middle)));
    case Op::Atan:
        return chain(b, op, x, middle, div(b, one, add(b, one, squareOf(b, x.middle))),
                     mirrored(b, x, neg(b, middle)));
    default: // Tan, as far as it has no pole.
        return unlessOutside(b, x, 1.57f,
                             chain(b, op, x, middle, add(b, one, squareOf(b, middle)),
                                   mirrored(b, x, neg(b, middle))));
    }
}

/// The second derivative is the function itself, turned round.
FormParts boundOfWave(Builder &b, Op op, const BoundedValue &x, ValueId middle) {
    const FormParts f = formOf(b, x);
    const ValueId one = number(b, 1), far = farthest(b, x);
    const ValueId slope =
        op == Op::Sin ? unary(b, Op::Cos, x.middle) : neg(b, unary(b, Op::Sin, x.middle));
    const ValueId bend = min(b, one, add(b, size(b, middle), far));
    const ValueId off = add(b, mul(b, size(b, slope), f.off),
                            mul(b, mul(b, number(b, 0.5f), squareOf(b, far)), bend));
    const FormParts wave{mul(b, slope, f.alongU), mul(b, slope, f.alongV), off, neg(b, one), one};
    return unlessOutside(b, x, endless, settle(b, middle, wave, add(b, one, far)));
}

/// Its second derivative is at most 1 / r^2 at the distance r.
FormParts boundOfAngle(Builder &b, const BoundedValue &y, const BoundedValue &x, ValueId middle) {
    const FormParts fy = formOf(b, y), fx = formOf(b, x);
    const ValueId zero = number(b, 0);
    const auto nearest = [&](const FormParts &f) {
        return max(b, max(b, f.least, neg(b, f.greatest)), zero);
    };
    const ValueId squared = add(b, squareOf(b, y.middle), squareOf(b, x.middle));
    const ValueId byY = div(b, x.middle, squared), byX = neg(b, div(b, y.middle, squared));
    const ValueId near = add(b, squareOf(b, nearest(fy)), squareOf(b, nearest(fx)));
    const ValueId far = add(b, squareOf(b, farthest(b, y)), squareOf(b, farthest(b, x)));
    const auto along = [&](ValueId p, ValueId q) { return add(b, mul(b, byY, p), mul(b, byX, q)); };
    const ValueId off = add(b, add(b, mul(b, size(b, byY), fy.off), mul(b, size(b, byX), fx.off)),
                            div(b, mul(b, number(b, 0.5f), far), near));
    const FormParts angle{along(fy.alongU, fx.alongU), along(fy.alongV, fx.alongV), off,
                          number(b, -pi), number(b, pi)};
    // Where y changes its sign at an x below 0, the angle jumps.
    const ValueId jumps =
        both(b, lessEqual(b, fx.least, zero),
             both(b, lessEqual(b, fy.least, zero), lessEqual(b, zero, fy.greatest)));
    const FormParts known = settle(
        b, middle, select(b, jumps, rangeForm(b, middle, number(b, -pi), number(b, pi)), angle),
        number(b, 4));
    return unlessOutside(b, x, endless, unlessOutside(b, y, endless, known));
}

namespace {

/// x^y, the same y all over: convex or concave where x is at least 0. Of an x that may be less the
/// size alone is known; even whole powers are not negative.
FormParts powerOf(Builder &b, const BoundedValue &x, ValueId y, ValueId middle) {
    const ValueId zero = number(b, 0);
    FormParts base = formOf(b, x);
    const ValueId isNegative = less(b, base.least, zero);
    const ValueId most = max(b, pow(b, size(b, base.least), y), pow(b, size(b, base.greatest), y));
    const ValueId half = mul(b, y, number(b, 0.5f));
    const ValueId isEven = equal(b, unary(b, Op::Floor, half), half);
    const FormParts ofAny =
        select(b, less(b, zero, y),
               rangeForm(b, middle, select(b, isEven, zero, neg(b, most)), most), unknownForm(b));
    base.least = max(b, base.least, zero);
    const ValueId slope =
        select(b, less(b, zero, x.middle), div(b, mul(b, y, middle), x.middle), zero);
    const FormParts ofPositive = callBound(
        b, RuntimeFunction::bound_chain, {{x.middle, base}},
        {middle, slope, pow(b, base.least, y), pow(b, base.greatest, y), x.middle, middle});
    return select(b, isNegative, ofAny, ofPositive);
}

} // namespace

/// x^y = e^(y log x) but for rounding, which grows with the exponent.
FormParts boundOfPower(Builder &b, const BoundedValue &x, const BoundedValue &y, ValueId middle) {
    if (!y.form)
        return powerOf(b, x, y.middle, middle);
    const ValueId zero = number(b, 0), one = number(b, 1);
    const FormParts base = formOf(b, x), exponent = formOf(b, y);
    BoundedValue logarithm{unary(b, Op::Log, x.middle)};
    if (x.form)
        logarithm.form = boundOfMonotone(b, Op::Log, x, logarithm.middle);
    BoundedValue product{mul(b, y.middle, logarithm.middle)};
    product.form = callBound(b, RuntimeFunction::bound_product, {y, logarithm});
    FormParts f = chain(b, Op::Exp, product, middle, middle, {product.middle, middle});
    const ValueId sizes =
        add(b, one, max(b, size(b, product.form->least), size(b, product.form->greatest)));
    const ValueId rounding = mul(b, mul(b, f.greatest, sizes), number(b, 0x1p-20f));
    f = {f.alongU, f.alongV, add(b, f.off, rounding), sub(b, f.least, rounding),
         add(b, f.greatest, rounding)};
    const ValueId isPositive = less(b, zero, base.least);
    const ValueId isNotNegative =
        both(b, lessEqual(b, zero, base.least), lessEqual(b, zero, exponent.least));
    const FormParts ofZero =
        rangeForm(b, middle, zero, pow(b, max(b, base.greatest, one), exponent.greatest));
    return select(b, isPositive, f, select(b, isNotNegative, ofZero, unknownForm(b)));
}

FormParts boundOfSmoothStep(Builder &b, const BoundedValue &t, ValueId middle) {
    const ValueId zero = number(b, 0), one = number(b, 1);
    const auto inside = [&](ValueId x) { return min(b, max(b, x, zero), one); };
    const auto cubic = [&](ValueId x) {
        const ValueId c = inside(x);
        return mul(b, mul(b, c, c), sub(b, number(b, 3), mul(b, number(b, 2), c)));
    };
    const FormParts f = formOf(b, t);
    const ValueId here = inside(t.middle);
    const ValueId slope = mul(b, number(b, 6), mul(b, here, oneLess(b, here)));
    // It rises at 1 - t as at t.
    const FormParts steps = callBound(b, RuntimeFunction::bound_chain, {t},
                                      {middle, slope, cubic(f.least), cubic(f.greatest),
                                       oneLess(b, here), oneLess(b, cubic(here))});
    // Where t is nothing known, it is one of the two ends or between.
    const FormParts any = rangeForm(b, middle, zero, one);
    return select(b, less(b, f.off, number(b, endless)), steps, any);
}

/// Of x / |x| the derivative is what is across x, over |x|; the second derivative along a way d is
/// at most root(4 / 3) d^2 / |x|^2.
FormParts boundOfUnit(Builder &b, const std::array<BoundedValue, 3> &x, std::size_t component,
                      ValueId length, ValueId middle) {
    const ValueId zero = number(b, 0), one = number(b, 1);
    const ValueId inverse = div(b, one, length);
    ValueId alongU = zero, alongV = zero, off = zero, way = zero;
    for (std::size_t k = 0; k < 3; ++k) {
        const FormParts f = formOf(b, x[k]);
        const ValueId across =
            sub(b, number(b, k == component ? 1 : 0), mul(b, middle, mul(b, x[k].middle, inverse)));
        const ValueId slope = mul(b, across, inverse);
        alongU = add(b, alongU, mul(b, slope, f.alongU));
        alongV = add(b, alongV, mul(b, slope, f.alongV));
        off = add(b, off, mul(b, size(b, slope), f.off));
        const ValueId far = add(b, add(b, size(b, f.alongU), size(b, f.alongV)), f.off);
        way = add(b, way, squareOf(b, far));
    }
    const ValueId least = max(b, sub(b, length, sqrt(b, way)), zero);
    const ValueId bent = div(b, mul(b, number(b, 0.57736f), way), squareOf(b, least));
    const FormParts unit{alongU, alongV, add(b, off, bent), number(b, -1.000001f),
                         number(b, 1.000001f)};
    // A vector so short that its square is not exact any more may become longer than 1.
    const ValueId isLong =
        both(b, less(b, number(b, 1e-15f), least), less(b, way, number(b, endless)));
    return select(b, isLong, settle(b, middle, unit, number(b, 2)), unknownForm(b));
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Arithmetic of affine forms for one instruction-set level. bound_v2.cpp, bound_v3.cpp and
// bound_v4.cpp include this file after naming their level; nobody else does.
//
// A form says of a shader's value f over a box, whose middle is the origin and whose sides are at
// -1 and 1 of (a, b):
//     |f(a, b) - middle - a alongU - b alongV| <= off     and     least <= f(a, b) <= greatest.
// Both hold of the floats that the shader computes, rounding included: each operation adds
// `roundings` of the size of its operands to `off` and to both ends. The plane and the range tell
// different things: a clamp's range is exact, whatever its plane.
//
// least = -infinity and greatest = infinity: nothing is known, and the value may be no number. If
// only one of them is infinite, it is one.
#pragma once

#include "language/runtime/level_code.h"
#include "language/runtime/register_form.h"

namespace {

template <typename Floats> struct Form { Floats middle, alongU, alongV, off, least, greatest; };
constexpr int formNumbers = 6;

/// The shader rounds here and in the middle, and so do we; each by 2^-24 of what it computes with.
constexpr float roundings = 0x1p-22f;
/// What may be lost to underflow.
constexpr float smallest = 1e-36f;
constexpr float endless = __builtin_inff();

template <typename Floats> CANDELA_INLINE Floats same(float x) { return Floats{} + x; }
template <typename Floats> CANDELA_INLINE Floats size(Floats x) { return x < 0.0f ? -x : x; }
template <typename Floats> CANDELA_INLINE Floats larger(Floats x, Floats y) {
    return x > y ? x : y;
}
template <typename Floats> CANDELA_INLINE Floats smaller(Floats x, Floats y) {
    return x < y ? x : y;
}

template <typename Floats> CANDELA_INLINE Floats largest(const Form<Floats> &f) {
    return larger<Floats>(size<Floats>(f.least), size<Floats>(f.greatest));
}
/// How far the plane goes from the middle.
template <typename Floats> CANDELA_INLINE Floats reach(const Form<Floats> &f) {
    return size<Floats>(f.alongU) + size<Floats>(f.alongV);
}
/// How far the value may be from that in the middle.
template <typename Floats> CANDELA_INLINE Floats farthest(const Form<Floats> &f) {
    const Floats ofRange = larger<Floats>(f.greatest - f.middle, f.middle - f.least);
    const Floats ofPlane = reach<Floats>(f) + f.off;
    return ofPlane < ofRange ? ofPlane : ofRange;
}

/// Adds what rounding does to numbers of this size, cuts plane and range by each other, and takes
/// the range for the plane where it alone says more.
template <typename Floats>
CANDELA_INLINE Form<Floats> settled(const Form<Floats> &given, Floats computedWith) {
    const Floats none = same<Floats>(0), all = same<Floats>(endless);
    Form<Floats> f = given;
    const Floats spread = reach<Floats>(f) + f.off;
    // Operands that are the same all over the box give the same bits all over it.
    const auto isSame = (spread == 0.0f) & (f.least == f.greatest) & (f.least == f.middle);
    f.off = f.off + (computedWith + spread + size<Floats>(f.middle)) * roundings + smallest;
    // No number is less than nothing known.
    f.least = f.least == f.least ? f.least - size<Floats>(f.least) * roundings - smallest : -all;
    f.greatest = f.greatest == f.greatest
                     ? f.greatest + size<Floats>(f.greatest) * roundings + smallest
                     : all;
    const Floats wide = (reach<Floats>(f) + f.off) * (1 + 4 * roundings);
    const Floats low = f.middle - wide, high = f.middle + wide;
    const Floats slack = size<Floats>(f.middle) * roundings;
    f.least = low - slack > f.least ? low - slack : f.least;
    f.greatest = high + slack < f.greatest ? high + slack : f.greatest;
    const auto isNumber = (f.least <= f.middle) & (f.middle <= f.greatest);
    f.least = isNumber ? f.least : -all;
    f.greatest = isNumber ? f.greatest : all;
    const Floats ofRange = larger<Floats>(f.greatest - f.middle, f.middle - f.least);
    const Floats rangeOff = ofRange + ofRange * roundings + slack;
    const auto isPlane = f.off <= rangeOff;
    f.alongU = isPlane ? f.alongU : none;
    f.alongV = isPlane ? f.alongV : none;
    f.off = isPlane ? f.off : rangeOff;
    const auto isFinite = f.off < all;
    f.alongU = isFinite ? f.alongU : none;
    f.alongV = isFinite ? f.alongV : none;
    f.off = isFinite ? f.off : all;
    f.off = isSame ? none : f.off;
    f.least = isSame ? f.middle : f.least;
    f.greatest = isSame ? f.middle : f.greatest;
    return f;
}

/// Something is known, at least that it is a number.
template <typename Floats> CANDELA_INLINE auto isKnown(const Form<Floats> &f) {
    return (f.least <= f.greatest) & ((f.least > -endless) | (f.greatest < endless));
}
template <typename Floats> CANDELA_INLINE Form<Floats> unknown(Floats middle) {
    const Floats none = same<Floats>(0), all = same<Floats>(endless);
    return {middle, none, none, all, -all, all};
}
/// The first where the mask holds, else the second.
template <typename Mask, typename Floats>
CANDELA_INLINE Form<Floats> chosen(Mask mask, const Form<Floats> &x, const Form<Floats> &y) {
    return {mask ? x.middle : y.middle, mask ? x.alongU : y.alongU, mask ? x.alongV : y.alongV,
            mask ? x.off : y.off,       mask ? x.least : y.least,   mask ? x.greatest : y.greatest};
}

template <typename Floats> CANDELA_INLINE Form<Floats> negative(const Form<Floats> &f) {
    return {-f.middle, -f.alongU, -f.alongV, f.off, -f.greatest, -f.least};
}

template <typename Floats>
CANDELA_INLINE Form<Floats> sumOf(const Form<Floats> &x, const Form<Floats> &y) {
    const Form<Floats> sum{x.middle + y.middle, x.alongU + y.alongU, x.alongV + y.alongV,
                           x.off + y.off,       x.least + y.least,   x.greatest + y.greatest};
    return settled<Floats>(sum, size<Floats>(x.middle) + farthest<Floats>(x) +
                                    size<Floats>(y.middle) + farthest<Floats>(y));
}

/// From the least to the greatest of four; everything, if one is no number.
template <typename Floats> CANDELA_INLINE void setRange(Form<Floats> &f, const Floats (&x)[4]) {
    const auto areNumbers = (x[0] == x[0]) & (x[1] == x[1]) & (x[2] == x[2]) & (x[3] == x[3]);
    f.least = smaller<Floats>(smaller<Floats>(x[0], x[1]), smaller<Floats>(x[2], x[3]));
    f.greatest = larger<Floats>(larger<Floats>(x[0], x[1]), larger<Floats>(x[2], x[3]));
    f.least = areNumbers ? f.least : same<Floats>(-endless);
    f.greatest = areNumbers ? f.greatest : same<Floats>(endless);
}

template <typename Floats>
CANDELA_INLINE Form<Floats> productOf(const Form<Floats> &x, const Form<Floats> &y) {
    Form<Floats> f{x.middle * y.middle,
                   x.middle * y.alongU + y.middle * x.alongU,
                   x.middle * y.alongV + y.middle * x.alongV,
                   {},
                   {},
                   {}};
    const Floats far = farthest<Floats>(x), yFar = farthest<Floats>(y);
    const Floats bent = far * yFar;
    f.off = size<Floats>(x.middle) * y.off + size<Floats>(y.middle) * x.off + bent;
    const Floats ends[4] = {x.least * y.least, x.least * y.greatest, x.greatest * y.least,
                            x.greatest * y.greatest};
    setRange<Floats>(f, ends);
    return settled<Floats>(f, size<Floats>(x.middle) * yFar + size<Floats>(y.middle) * far + bent);
}

template <typename Floats> CANDELA_INLINE Form<Floats> squareOf(const Form<Floats> &x) {
    const Floats none = same<Floats>(0), far = farthest<Floats>(x);
    Form<Floats> f{
        x.middle * x.middle, 2.0f * x.middle * x.alongU, 2.0f * x.middle * x.alongV, {}, {}, {}};
    f.off = 2.0f * size<Floats>(x.middle) * x.off + far * far;
    const Floats low = x.least * x.least, high = x.greatest * x.greatest;
    const auto crosses = (x.least < 0.0f) & (x.greatest > 0.0f);
    f.least = crosses ? none : smaller<Floats>(low, high);
    f.greatest = larger<Floats>(low, high);
    const Form<Floats> known = settled<Floats>(f, 2.0f * size<Floats>(x.middle) * far + far * far);
    return chosen(isKnown<Floats>(x), known, unknown<Floats>(f.middle));
}

/// With q = x / y in the middle, x / y - q = (x - q y) / y, whose numerator is 0 there.
template <typename Floats>
CANDELA_INLINE Form<Floats> quotientOf(const Form<Floats> &x, const Form<Floats> &y) {
    const Floats q = x.middle / y.middle, inverse = 1.0f / y.middle;
    const Floats low = 1.0f / y.greatest, high = 1.0f / y.least;
    const Floats turned = larger<Floats>(size<Floats>(low - inverse), size<Floats>(high - inverse));
    const Floats most = larger<Floats>(size<Floats>(low), size<Floats>(high));
    const Floats u = x.alongU - q * y.alongU, v = x.alongV - q * y.alongV;
    const Floats off = x.off + size<Floats>(q) * y.off;
    Form<Floats> f{q, u * inverse, v * inverse, {}, {}, {}};
    f.off = off * most + (size<Floats>(u) + size<Floats>(v)) * turned;
    const Floats ends[4] = {x.least / y.least, x.least / y.greatest, x.greatest / y.least,
                            x.greatest / y.greatest};
    setRange<Floats>(f, ends);
    const Floats sizes = (size<Floats>(x.middle) + farthest<Floats>(x) +
                          size<Floats>(q) * (size<Floats>(y.middle) + farthest<Floats>(y))) *
                         most;
    const auto isSafe = (y.least > 0.0f) | (y.greatest < 0.0f);
    return chosen(isSafe, settled<Floats>(f, sizes), unknown<Floats>(q));
}

/// x > y ? x : y, which is y + Max(x - y, 0): between the chord over the difference's range and
/// that chord less its greatest distance.
template <typename Floats>
CANDELA_INLINE Form<Floats> greatestOf(const Form<Floats> &x, const Form<Floats> &y) {
    const Form<Floats> d = sumOf<Floats>(x, negative<Floats>(y));
    const Floats share = d.greatest / (d.greatest - d.least), rest = 1.0f - share;
    Form<Floats> f{x.middle > y.middle ? x.middle : y.middle, {}, {}, {}, {}, {}};
    f.alongU = share * x.alongU + rest * y.alongU;
    f.alongV = share * x.alongV + rest * y.alongV;
    const Floats low = share * x.middle + rest * y.middle - f.middle;
    const Floats high = low - share * d.least;
    f.off = share * x.off + rest * y.off + larger<Floats>(size<Floats>(low), size<Floats>(high));
    f.least = larger<Floats>(x.least, y.least);
    f.greatest = larger<Floats>(x.greatest, y.greatest);
    const Floats sizes =
        size<Floats>(x.middle) + farthest<Floats>(x) + size<Floats>(y.middle) + farthest<Floats>(y);
    Form<Floats> result = settled<Floats>(f, sizes);
    result = chosen(d.least >= 0.0f, x, result);
    result = chosen(d.greatest <= 0.0f, y, result);
    result.middle = f.middle;
    // Where the second is no number, it is the result.
    return chosen(isKnown<Floats>(y), result, unknown<Floats>(f.middle));
}

template <typename Floats>
CANDELA_INLINE Form<Floats> unionOf(Floats middle, const Form<Floats> &x, const Form<Floats> &y) {
    Form<Floats> f{
        middle, (x.alongU + y.alongU) * 0.5f,      (x.alongV + y.alongV) * 0.5f,
        {},     smaller<Floats>(x.least, y.least), larger<Floats>(x.greatest, y.greatest)};
    const Floats apart =
        (size<Floats>(x.alongU - y.alongU) + size<Floats>(x.alongV - y.alongV)) * 0.5f;
    f.off = apart + larger<Floats>(x.off + size<Floats>(x.middle - middle),
                                   y.off + size<Floats>(y.middle - middle));
    const Form<Floats> known = settled<Floats>(f, size<Floats>(x.middle) + size<Floats>(y.middle) +
                                                      reach<Floats>(x) + reach<Floats>(y));
    return chosen(isKnown<Floats>(x) & isKnown<Floats>(y), known, unknown<Floats>(middle));
}

/// f(x) = value + slope (x - middle) + e(x); e has its extremes where functions.def says.
template <typename Floats>
CANDELA_INLINE Form<Floats> chainOf(const Form<Floats> &x, Floats value, Floats slope,
                                    Floats atLeast, Floats atGreatest, Floats place,
                                    Floats atPlace) {
    const auto error = [&](Floats where, Floats there) __attribute__((always_inline)) {
        return size<Floats>(there - value - slope * (where - x.middle));
    };
    const auto isWithin = (x.least < place) & (place < x.greatest);
    const Floats between = isWithin ? error(place, atPlace) : same<Floats>(0);
    const Floats ends = larger<Floats>(error(x.least, atLeast), error(x.greatest, atGreatest));
    Form<Floats> f{value, slope * x.alongU, slope * x.alongV, {}, {}, {}};
    f.off = size<Floats>(slope) * x.off + larger<Floats>(ends, between);
    f.least = smaller<Floats>(atLeast, atGreatest);
    f.greatest = larger<Floats>(atLeast, atGreatest);
    const Floats sizes =
        size<Floats>(atLeast) + size<Floats>(atGreatest) + size<Floats>(value) +
        2.0f * size<Floats>(slope) * (farthest<Floats>(x) + size<Floats>(x.middle));
    // A library's function rises and falls by an ulp where it should stand.
    const Floats wobble = (size<Floats>(atLeast) + size<Floats>(atGreatest)) * roundings;
    f.least = smaller<Floats>(f.least, value) - wobble;
    f.greatest = larger<Floats>(f.greatest, value) + wobble;
    const auto isSame = (farthest<Floats>(x) == 0.0f) & (value == value);
    const Form<Floats> constant{value,           same<Floats>(0), same<Floats>(0),
                                same<Floats>(0), value,           value};
    const auto areNumbers = (atLeast == atLeast) & (atGreatest == atGreatest);
    return chosen(isSame, constant,
                  chosen(areNumbers, settled<Floats>(f, sizes), unknown<Floats>(value)));
}

/// The functions, as InRegisters wants them.
template <typename Floats> CANDELA_INLINE Form<Floats> formAt(const Floats *x) {
    return {x[0], x[1], x[2], x[3], x[4], x[5]};
}
template <typename Floats> CANDELA_INLINE void put(const Form<Floats> &f, Floats *result) {
    result[0] = f.alongU, result[1] = f.alongV, result[2] = f.off;
    result[3] = f.least, result[4] = f.greatest;
}

template <int inputs_> struct OfForms {
    static constexpr int inputs = inputs_, outputs = formNumbers - 1;
};
struct Settle : OfForms<formNumbers + 1> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(settled<F>(formAt<F>(x), x[formNumbers]), result);
    }
};
struct Sum : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(sumOf<F>(formAt<F>(x), formAt<F>(x + formNumbers)), result);
    }
};
struct Difference : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(sumOf<F>(formAt<F>(x), negative<F>(formAt<F>(x + formNumbers))), result);
    }
};
struct Product : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(productOf<F>(formAt<F>(x), formAt<F>(x + formNumbers)), result);
    }
};
struct Square : OfForms<formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(squareOf<F>(formAt<F>(x)), result);
    }
};
struct Quotient : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(quotientOf<F>(formAt<F>(x), formAt<F>(x + formNumbers)), result);
    }
};
struct Greatest : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(greatestOf<F>(formAt<F>(x), formAt<F>(x + formNumbers)), result);
    }
};
struct Least : OfForms<2 * formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        const Form<F> one = negative<F>(formAt<F>(x)),
                      other = negative<F>(formAt<F>(x + formNumbers));
        put<F>(negative<F>(greatestOf<F>(one, other)), result);
    }
};
struct Magnitude : OfForms<formNumbers> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        const Form<F> f = formAt<F>(x);
        const Form<F> positive = greatestOf<F>(f, negative<F>(f));
        put<F>(chosen(isKnown<F>(f), positive, unknown<F>(positive.middle)), result);
    }
};
struct Union : OfForms<2 * formNumbers + 1> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        put<F>(unionOf<F>(x[0], formAt<F>(x + 1), formAt<F>(x + 1 + formNumbers)), result);
    }
};
struct Chain : OfForms<formNumbers + 6> {
    template <typename F> CANDELA_INLINE void evaluate(const F *x, F *result) {
        const F *of = x + formNumbers;
        put<F>(chainOf<F>(formAt<F>(x), of[0], of[1], of[2], of[3], of[4], of[5]), result);
    }
};

/// By RuntimeFunction from firstBound on.
template <typename Floats> candela::runtime::LevelCode boundCode(int function) {
#define CANDELA_BOUND(form)                                                                        \
    InRegisters<Floats, Settle>::form, InRegisters<Floats, Sum>::form,                             \
        InRegisters<Floats, Difference>::form, InRegisters<Floats, Product>::form,                 \
        InRegisters<Floats, Square>::form, InRegisters<Floats, Quotient>::form,                    \
        InRegisters<Floats, Greatest>::form, InRegisters<Floats, Least>::form,                     \
        InRegisters<Floats, Magnitude>::form, InRegisters<Floats, Union>::form,                    \
        InRegisters<Floats, Chain>::form
    static constexpr candela::runtime::RuntimeCode throughMemory[] = {CANDELA_BOUND(throughMemory)};
    static const void *const inRegisters[] = {CANDELA_BOUND(address())};
#undef CANDELA_BOUND
    constexpr int first = int(candela::runtime::firstBound);
    static_assert(sizeof throughMemory / sizeof *throughMemory ==
                  std::size_t(int(candela::runtime::RuntimeFunction::Count) - first));
    return {throughMemory[function - first], inRegisters[function - first]};
}

} // namespace

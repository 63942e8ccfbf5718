// SPDX-License-Identifier: Apache-2.0
// Gradient noise and cell noise for one instruction-set level. noise_v2.cpp, noise_v3.cpp and
// noise_v4.cpp include this file after naming their level; nobody else does.
//
// Gradient noise: a random gradient at each integer lattice point, from an integer hash; between
// them the linear functions those gradients stand for, blended by the quintic 6t^5-15t^4+10t^3,
// which makes the sum twice continuously differentiable (K. Perlin, "Improving Noise", 2002). Its
// own gradient comes from the same hashes: that of the blended functions, and the blend's.
#pragma once

#include "language/runtime/level_code.h"
#include "language/runtime/noise_gradients.h"
#include "language/runtime/noise_lanes.h"
#include "language/runtime/register_form.h"

namespace {

/// Longest period that integers can be told apart in.
constexpr float longestPeriod = 16777216.0f;

/// Odd numbers by which lattice coordinates are multiplied, and corners. Chosen by trial among
/// ninety combinations: joint distributions of neighbouring corners' gradients over a million
/// lattice points show nothing beyond chance, nor do spectra.
constexpr std::uint32_t axisFactors[4] = {0x6c8e9cf5u, 0xb5297a4du, 0x68e31da5u, 0x1b56c4e9u};
constexpr std::uint32_t cornerFactor = 0x846ca68bu;

/// The upper bits are the best mixed ones.
template <typename Bits> CANDELA_INLINE Bits mixCorner(Bits h) {
    return (h ^ (h >> 13)) * cornerFactor;
}
template <typename Bits> CANDELA_INLINE Bits mixAxis(Bits h) { return h ^ (h >> 15); }

template <typename Floats> CANDELA_INLINE Floats all(float x) { return Floats{} + x; }

template <typename Floats> CANDELA_INLINE Floats mixed(Floats low, Floats high, Floats t) {
    return Lanes<Floats>::multiplyAdd(t, high - low, low);
}

/// One coordinate: the two lattice lines about it, hashed, where it stands between them, and how
/// far the second one is blended in.
template <typename Floats> struct Axis {
    typename Lanes<Floats>::Bits line[2];
    Floats offset[2]; ///< From the first line, in [0,1]; from the second.
    Floats fade;
};

template <typename Floats> CANDELA_INLINE Floats quintic(Floats t) {
    using L = Lanes<Floats>;
    const Floats inner = L::multiplyAdd(t, all<Floats>(6), all<Floats>(-15));
    return t * t * t * L::multiplyAdd(t, inner, all<Floats>(10));
}

/// Its derivative, 30 t^2 (t - 1)^2.
template <typename Floats> CANDELA_INLINE Floats quinticSlope(Floats t) {
    const Floats parabola = t * (t - 1.0f);
    return parabola * parabola * 30.0f;
}

/// x modulo period for integers x: in [0, period).
template <typename Floats> CANDELA_INLINE Floats wrap(Floats x, Floats period) {
    const Floats r = x - Lanes<Floats>::floor(x / period) * period;
    const Floats notBelow = r < 0.0f ? r + period : r;
    const Floats wrapped = notBelow < period ? notBelow : notBelow - period;
    return wrapped >= 0.0f && wrapped < period ? wrapped : Floats{};
}

/// Periods are whole numbers from 1.
template <typename Floats> CANDELA_INLINE Floats wholePeriod(Floats period) {
    const Floats whole = Lanes<Floats>::floor(period);
    const Floats least = whole > 1.0f ? whole : all<Floats>(1);
    return least < longestPeriod ? least : all<Floats>(longestPeriod);
}

/// What is no number, or infinite, lies on a lattice line.
template <typename Floats, bool periodic>
CANDELA_INLINE Axis<Floats> makeAxis(Floats x, Floats period, std::uint32_t factor) {
    using L = Lanes<Floats>;
    const Floats cell = L::floor(x);
    Axis<Floats> axis;
    axis.offset[0] = L::positive(x - cell);
    axis.offset[1] = axis.offset[0] - 1.0f;
    axis.fade = quintic<Floats>(axis.offset[0]);
    if constexpr (periodic) {
        const Floats whole = wholePeriod<Floats>(period);
        const Floats low = wrap<Floats>(cell, whole), next = low + 1.0f;
        axis.line[0] = mixAxis(L::integerBits(low) * factor);
        axis.line[1] = mixAxis(L::integerBits(next < whole ? next : Floats{}) * factor);
    } else {
        const auto low = L::integerBits(cell) * factor;
        axis.line[0] = mixAxis(low);
        axis.line[1] = mixAxis(low + factor);
    }
    return axis;
}

/// The hashes of a cell's corners: bit k of a corner's number tells on which line of axis k it is.
template <typename Floats, int dimensions> struct Corners {
    typename Lanes<Floats>::Bits hash[1 << dimensions];
};

template <typename Floats, int dimensions>
CANDELA_INLINE Corners<Floats, dimensions> hashCorners(const Axis<Floats> *axes) {
    using Bits = typename Lanes<Floats>::Bits;
    Corners<Floats, dimensions> corners;
    const auto line = [&](int axis, int corner) __attribute__((always_inline)) {
        return axis < dimensions ? axes[axis].line[corner >> axis & 1] : Bits{};
    };
        // Sums of two axes each, joined by exclusive or: neither alone would do for all four.
#pragma GCC unroll 16
    for (int k = 0; k < 1 << dimensions; ++k)
        corners.hash[k] = mixCorner(Bits((line(0, k) + line(1, k)) ^ (line(2, k) + line(3, k))));
    return corners;
}

/// A component of noise less one half, and its gradient.
template <typename Floats, int dimensions> struct Lattice { Floats value, slope[dimensions]; };

/// Blends what the axes from `axis` on enclose, of the lines of other axes that `corner` tells.
/// Each component has bits of the hashes of its own.
template <typename Floats, int dimensions, int component, int axis, int corner>
CANDELA_INLINE Lattice<Floats, dimensions> blend(const Axis<Floats> *axes,
                                                 const Corners<Floats, dimensions> &corners) {
    using L = Lanes<Floats>;
    Lattice<Floats, dimensions> result;
    if constexpr (axis < 0) {
        const auto index = corners.hash[corner] >> (28 - 4 * component);
        for (int k = 0; k < dimensions; ++k) {
            const Floats offset = axes[k].offset[corner >> k & 1];
            result.slope[k] = L::lookUp(noiseGradients<dimensions>.axis[k], index);
            result.value = k == 0 ? result.slope[0] * offset
                                  : L::multiplyAdd(result.slope[k], offset, result.value);
        }
    } else {
        const Axis<Floats> &here = axes[axis];
        const auto low = blend<Floats, dimensions, component, axis - 1, corner>(axes, corners);
        const auto high =
            blend<Floats, dimensions, component, axis - 1, corner | 1 << axis>(axes, corners);
        result.value = mixed<Floats>(low.value, high.value, here.fade);
        for (int k = 0; k < dimensions; ++k)
            result.slope[k] = mixed<Floats>(low.slope[k], high.slope[k], here.fade);
        result.slope[axis] = L::multiplyAdd(quinticSlope<Floats>(here.offset[0]),
                                            high.value - low.value, result.slope[axis]);
    }
    return result;
}

/// noise() and its like at a point: coordinates and then periods in; values out, and behind them
/// the slopes, component by component.
template <int dimensions, int components, bool periodic, bool slopes> struct GradientNoise {
    static constexpr int inputs = dimensions * (periodic ? 2 : 1);
    static constexpr int outputs = components * (slopes ? 1 + dimensions : 1);

    template <typename Floats> CANDELA_INLINE void evaluate(const Floats *x, Floats *result) {
        Axis<Floats> axes[dimensions];
#pragma GCC unroll 4
        for (int k = 0; k < dimensions; ++k)
            axes[k] = makeAxis<Floats, periodic>(x[k], periodic ? x[inputs - dimensions + k] : x[k],
                                                 axisFactors[k]);
        const auto corners = hashCorners<Floats, dimensions>(axes);
        const auto put = [&]<int component>() __attribute__((always_inline)) {
            const auto noise =
                blend<Floats, dimensions, component, dimensions - 1, 0>(axes, corners);
            result[component] = noise.value + 0.5f;
            if constexpr (slopes)
                for (int k = 0; k < dimensions; ++k)
                    result[components + component * dimensions + k] = noise.slope[k];
        };
        put.template operator()<0>();
        if constexpr (components == 3)
            put.template operator()<1>(), put.template operator()<2>();
    }
};

template <typename Bits> CANDELA_INLINE Bits mixWhole(Bits h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    h ^= h >> 15;
    h *= cornerFactor;
    return h ^ (h >> 16);
}

template <int dimensions, int components> struct CellNoise {
    static constexpr int inputs = dimensions, outputs = components;

    template <typename Floats> CANDELA_INLINE void evaluate(const Floats *x, Floats *result) {
        using L = Lanes<Floats>;
        typename L::Bits hash{};
        for (int k = 0; k < dimensions; ++k)
            hash = mixWhole((hash ^ L::integerBits(L::floor(x[k]))) + axisFactors[k]);
        for (int component = 0; component < components; ++component) {
            result[component] = L::fromSmallInteger(hash >> 8) * (1.0f / 16777216.0f);
            hash = mixWhole(hash + 0x9e3779b9u);
        }
    }
};

/// By RuntimeFunction, in the order of functions.def up to firstBound: families of four dimensions each.
#define CANDELA_FAMILY(form, function, ...)                                                        \
    InRegisters<Floats, function<1, __VA_ARGS__>>::form,                                           \
        InRegisters<Floats, function<2, __VA_ARGS__>>::form,                                       \
        InRegisters<Floats, function<3, __VA_ARGS__>>::form,                                       \
        InRegisters<Floats, function<4, __VA_ARGS__>>::form
#define CANDELA_NOISE(form)                                                                        \
    CANDELA_FAMILY(form, GradientNoise, 1, false, false),                                          \
        CANDELA_FAMILY(form, GradientNoise, 3, false, false),                                      \
        CANDELA_FAMILY(form, GradientNoise, 1, true, false),                                       \
        CANDELA_FAMILY(form, GradientNoise, 3, true, false),                                       \
        CANDELA_FAMILY(form, GradientNoise, 1, false, true),                                       \
        CANDELA_FAMILY(form, GradientNoise, 3, false, true),                                       \
        CANDELA_FAMILY(form, GradientNoise, 1, true, true),                                        \
        CANDELA_FAMILY(form, GradientNoise, 3, true, true), CANDELA_FAMILY(form, CellNoise, 1),    \
        CANDELA_FAMILY(form, CellNoise, 3)

template <typename Floats> candela::runtime::LevelCode noiseCode(int function) {
    static constexpr candela::runtime::RuntimeCode throughMemory[] = {CANDELA_NOISE(throughMemory)};
    static const void *const inRegisters[] = {CANDELA_NOISE(address())};
    static_assert(sizeof throughMemory / sizeof *throughMemory ==
                  std::size_t(candela::runtime::firstBound));
    return {throughMemory[function], inRegisters[function]};
}

} // namespace

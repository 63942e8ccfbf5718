// SPDX-License-Identifier: Apache-2.0
// Gradient noise and cell noise for one instruction-set level. noise_v2.cpp, noise_v3.cpp and
// noise_v4.cpp include this file after naming their level; nobody else does.
//
// Gradient noise: a random gradient at each integer lattice point, from an integer hash; between
// them the linear functions those gradients stand for, blended by the quintic 6t^5-15t^4+10t^3,
// which makes the sum twice continuously differentiable (K. Perlin, "Improving Noise", 2002).
#pragma once

#include "language/runtime/noise_lanes.h"
#include "language/runtime/runtime_functions.h"

#include <cstddef>
#include <type_traits>

namespace {

/// Lattice coordinates beyond this have no fractions left in single precision by far; NaN goes
/// here too.
constexpr float farthest = 1e9f;
/// Longest period that integers can be told apart in.
constexpr float longestPeriod = 16777216.0f;

/// Gradient sets: 1-D 255 slopes in [-1,1]; 2-D (+-1, +-1/2) and its mirror; 3-D the 12 edges of
/// the cube (4 of them twice); 4-D the 32 of the tesseract. No sum exceeds these bounds, attained
/// in the middle of a cell or close to it; noise is divided by them to fill [0,1].
constexpr float largestSum[5] = {0, 0.5f, 0.7557f, 1.0365f, 1.5365f};

template <typename Bits> CANDELA_INLINE Bits mixOnce(Bits h) {
    h ^= h >> 16;
    h *= 0x7feb352du;
    return h ^ (h >> 15);
}

template <typename Bits> CANDELA_INLINE Bits mixTwice(Bits h) {
    h = mixOnce(h);
    h *= 0x846ca68bu;
    return h ^ (h >> 16);
}

template <typename Floats> CANDELA_INLINE Floats floorOf(Floats x) {
    const Floats towardZero = Lanes<Floats>::truncate(x);
    return towardZero > x ? towardZero - 1.0f : towardZero;
}

template <typename Floats> CANDELA_INLINE Floats tame(Floats x) {
    const Floats above = x > -farthest ? x : Floats{} - farthest; // NaN too
    return above < farthest ? above : Floats{} + farthest;
}

/// One coordinate: the two lattice lines about it, hashed, and where it stands between them.
template <typename Floats> struct Axis {
    typename Lanes<Floats>::Bits low, high;
    Floats offset, fade;
};

template <typename Floats> CANDELA_INLINE Floats quintic(Floats t) {
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

/// x modulo period for integers x: in [0, period).
template <typename Floats> CANDELA_INLINE Floats wrap(Floats x, Floats period) {
    const Floats r = x - floorOf<Floats>(x / period) * period;
    const Floats notBelow = r < 0.0f ? r + period : r;
    const Floats wrapped = notBelow < period ? notBelow : notBelow - period;
    return wrapped >= 0.0f && wrapped < period ? wrapped : Floats{};
}

/// Periods are whole numbers from 1.
template <typename Floats> CANDELA_INLINE Floats wholePeriod(Floats period) {
    const Floats whole = floorOf<Floats>(tame<Floats>(period));
    const Floats least = whole > 1.0f ? whole : Floats{} + 1.0f;
    return least < longestPeriod ? least : Floats{} + longestPeriod;
}

template <typename Floats, bool periodic>
CANDELA_INLINE Axis<Floats> makeAxis(Floats coordinate, Floats period, std::uint32_t seed) {
    using L = Lanes<Floats>;
    const Floats x = tame<Floats>(coordinate);
    const Floats cell = floorOf<Floats>(x);
    Axis<Floats> axis;
    axis.offset = x - cell;
    axis.fade = quintic<Floats>(axis.offset);
    if constexpr (periodic) {
        const Floats whole = wholePeriod<Floats>(period);
        const Floats low = wrap<Floats>(cell, whole);
        const Floats next = low + 1.0f;
        axis.low = mixTwice(L::integerBits(low) + seed);
        axis.high = mixTwice(L::integerBits(next < whole ? next : Floats{}) + seed);
    } else {
        const auto low = L::integerBits(cell) + seed;
        axis.low = mixTwice(low);
        axis.high = mixTwice(low + 1u);
    }
    return axis;
}

constexpr std::uint32_t axisSeeds[4] = {0x2545f491u, 0x9e3779b9u, 0x6c62272eu, 0x01b3d5c7u};

/// +a or -a as the bit says.
template <typename Floats, int bit, typename Bits>
CANDELA_INLINE Floats signedBy(Floats a, Bits hash) {
    return Lanes<Floats>::flipSign(a, (hash << (31 - bit)) & 0x80000000u);
}

/// Dot product of the offset with the gradient that bits shift .. shift+7 of the hash choose.
template <typename Floats, int dimensions, int shift, typename Bits>
CANDELA_INLINE Floats slope(Bits hash, const Floats *offset) {
    const auto bit = [&](int k) { return (hash & (1u << (shift + k))) != 0u; };
    if constexpr (dimensions == 1) {
        const Floats byte = Lanes<Floats>::fromSmallInteger((hash >> shift) & 255u);
        return (byte * (2.0f / 255.0f) - 1.0f) * offset[0];
    } else if constexpr (dimensions == 2) {
        const Floats large = bit(2) ? offset[0] : offset[1];
        const Floats small = bit(2) ? offset[1] : offset[0];
        return signedBy<Floats, shift>(large, hash) +
               signedBy<Floats, shift + 1>(small * 0.5f, hash);
    } else if constexpr (dimensions == 3) {
        const Floats first = bit(2) ? offset[0] : offset[1];
        const Floats other = bit(2) ? offset[1] : offset[0];
        const Floats second = bit(3) ? offset[2] : other;
        return signedBy<Floats, shift>(first, hash) + signedBy<Floats, shift + 1>(second, hash);
    } else {
        const Floats first = bit(3) && bit(4) ? offset[3] : offset[0];
        const Floats second = bit(3) && !bit(4) ? offset[3] : offset[1];
        const Floats third = !bit(3) && bit(4) ? offset[3] : offset[2];
        return signedBy<Floats, shift>(first, hash) + signedBy<Floats, shift + 1>(second, hash) +
               signedBy<Floats, shift + 2>(third, hash);
    }
}

/// The sum over the corners from axis `axis` on: `hashes` are those of the axes taken so far, in
/// two halves, so that a corner costs one mixing only.
template <typename Floats, int dimensions, int shift, int axis, typename Bits>
CANDELA_INLINE Floats blend(const Axis<Floats> *axes, Floats *offset, Bits firstHalf,
                            Bits secondHalf) {
    if constexpr (axis == dimensions) {
        const Bits joined = firstHalf ^ secondHalf;
        return slope<Floats, dimensions, shift>(dimensions == 1 ? joined : mixOnce(joined), offset);
    } else {
        const Bits none{};
        const Bits toFirst = axis < 2 ? axes[axis].low : none;
        const Bits toSecond = axis < 2 ? none : axes[axis].low;
        const Bits highFirst = axis < 2 ? axes[axis].high : none;
        const Bits highSecond = axis < 2 ? none : axes[axis].high;
        offset[axis] = axes[axis].offset;
        const Floats low = blend<Floats, dimensions, shift, axis + 1>(
            axes, offset, Bits(firstHalf + toFirst), Bits(secondHalf + toSecond));
        offset[axis] = axes[axis].offset - 1.0f;
        const Floats high = blend<Floats, dimensions, shift, axis + 1>(
            axes, offset, Bits(firstHalf + highFirst), Bits(secondHalf + highSecond));
        return low + axes[axis].fade * (high - low);
    }
}

template <typename Floats, int dimensions, int component>
CANDELA_INLINE Floats gradientComponent(const Axis<Floats> *axes) {
    using Bits = typename Lanes<Floats>::Bits;
    Floats offset[4];
    const Floats sum = blend<Floats, dimensions, 8 * component, 0>(axes, offset, Bits{}, Bits{});
    return sum * (0.4999f / largestSum[dimensions]) + 0.5f;
}

/// What a block of `width` lanes is worked through with.
template <int width> using FloatsOf = std::conditional_t<width == 1, Floats1, WideFloats>;

template <int width, int dimensions, int outputs, bool periodic>
void gradientNoise(const float *inputs, float *output) {
    using Floats = FloatsOf<width>;
    using L = Lanes<Floats>;
    for (int lane = 0; lane < width; lane += int(sizeof(Floats) / sizeof(float))) {
        Axis<Floats> axes[dimensions];
        for (int k = 0; k < dimensions; ++k) {
            const Floats period =
                periodic ? L::load(inputs + (dimensions + k) * width + lane) : Floats{};
            axes[k] = makeAxis<Floats, periodic>(L::load(inputs + k * width + lane), period,
                                                 axisSeeds[k]);
        }
        L::store(output + lane, gradientComponent<Floats, dimensions, 0>(axes));
        if constexpr (outputs == 3) {
            L::store(output + width + lane, gradientComponent<Floats, dimensions, 1>(axes));
            L::store(output + 2 * width + lane, gradientComponent<Floats, dimensions, 2>(axes));
        }
    }
}

template <int width, int dimensions, int outputs>
void cellNoise(const float *inputs, float *output) {
    using Floats = FloatsOf<width>;
    using L = Lanes<Floats>;
    for (int lane = 0; lane < width; lane += int(sizeof(Floats) / sizeof(float))) {
        typename L::Bits hash{};
        for (int k = 0; k < dimensions; ++k) {
            const Floats x = L::load(inputs + k * width + lane);
            const Floats cell = floorOf<Floats>(tame<Floats>(x));
            hash = mixTwice((hash ^ L::integerBits(cell)) + axisSeeds[k]);
        }
        for (int component = 0; component < outputs; ++component) {
            L::store(output + component * width + lane,
                     L::fromSmallInteger(hash >> 8) * (1.0f / 16777216.0f));
            hash = mixTwice(hash + 0x9e3779b9u);
        }
    }
}

/// Code by RuntimeFunction, in the order of functions.def: families of four dimensions each.
template <int width> struct NoiseTable {
    static constexpr candela::runtime::RuntimeCode code[] = {
        gradientNoise<width, 1, 1, false>,
        gradientNoise<width, 2, 1, false>,
        gradientNoise<width, 3, 1, false>,
        gradientNoise<width, 4, 1, false>,
        gradientNoise<width, 1, 3, false>,
        gradientNoise<width, 2, 3, false>,
        gradientNoise<width, 3, 3, false>,
        gradientNoise<width, 4, 3, false>,
        gradientNoise<width, 1, 1, true>,
        gradientNoise<width, 2, 1, true>,
        gradientNoise<width, 3, 1, true>,
        gradientNoise<width, 4, 1, true>,
        gradientNoise<width, 1, 3, true>,
        gradientNoise<width, 2, 3, true>,
        gradientNoise<width, 3, 3, true>,
        gradientNoise<width, 4, 3, true>,
        cellNoise<width, 1, 1>,
        cellNoise<width, 2, 1>,
        cellNoise<width, 3, 1>,
        cellNoise<width, 4, 1>,
        cellNoise<width, 1, 3>,
        cellNoise<width, 2, 3>,
        cellNoise<width, 3, 3>,
        cellNoise<width, 4, 3>,
    };
};

static_assert(sizeof(NoiseTable<1>::code) / sizeof(candela::runtime::RuntimeCode) ==
              std::size_t(candela::runtime::RuntimeFunction::Count));

} // namespace

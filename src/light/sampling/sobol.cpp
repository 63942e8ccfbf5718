// SPDX-License-Identifier: Apache-2.0
// Nested uniform (Owen) scrambling by hashing, after Laine & Karras 2011 and Burley 2020: a
// bijection of bit-reversed numbers in which every bit depends on the bits below it alone.
#include "light/sampling/sobol.h"

#include "foundation/base/hash.h"
#include "foundation/base/hot.h"

#include <array>

namespace candela {

namespace {

inline std::uint32_t mix(std::uint32_t x) {
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    return x ^ (x >> 16);
}

inline std::uint32_t reverseBits(std::uint32_t x) {
    x = __builtin_bswap32(x); // One shuffle of bytes for a whole vector.
    x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
    x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
    return ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
}

/// Multiplying by an even number and xoring moves information upwards only; so does adding and
/// multiplying by an odd one. Hence the result's low k bits depend on x's low k bits.
inline std::uint32_t scrambleReversed(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x5d2a94b6u;
    x *= (seed >> 16) | 1u;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0x2c9277a4u;
    return x * 0x9e3779b1u;
}

/// Second Sobol dimension, bit-reversed: column k of the Pascal matrix is x ^ (x << 1) applied k
/// times over; for the reversed result the powers of two of the column number do at once what
/// single steps would do (the matrix is its own Kronecker power).
inline std::uint32_t sobolSecondReversed(std::uint32_t i) {
    i ^= (i & 0xaaaaaaaau) >> 1;
    i ^= (i & 0xccccccccu) >> 2;
    i ^= (i & 0xf0f0f0f0u) >> 4;
    i ^= (i & 0xff00ff00u) >> 8;
    return i ^ ((i & 0xffff0000u) >> 16);
}

/// The sequence of the third and fourth dimensions begins anew after 2^16 points, scrambled
/// differently.
constexpr int columnsKept = 16;

/// The columns of a generator matrix, bit-reversed: of the dimension with the primitive polynomial
/// x^degree + ... + 1, whose inner coefficients are the bits of `inner`, and the initial direction
/// numbers m (Joe and Kuo 2008).
constexpr std::array<std::uint32_t, columnsKept>
reversedColumns(int degree, std::uint32_t inner, std::array<std::uint32_t, 3> initial) {
    std::array<std::uint32_t, columnsKept> m{}, columns{};
    for (int k = 0; k < columnsKept; ++k) {
        if (k < degree) {
            m[k] = initial[k];
            continue;
        }
        m[k] = m[k - degree] ^ m[k - degree] << degree;
        for (int j = 1; j < degree; ++j)
            if (inner >> (degree - 1 - j) & 1)
                m[k] ^= m[k - j] << j;
    }
    for (int k = 0; k < columnsKept; ++k)
        for (int bit = 0; bit <= k; ++bit)
            columns[k] |= (m[k] >> bit & 1) << (k - bit);
    return columns;
}

constexpr auto thirdDimension = reversedColumns(2, 1, {1, 3});
constexpr auto fourthDimension = reversedColumns(3, 1, {1, 3, 1});

inline std::uint32_t multiply(const std::array<std::uint32_t, columnsKept> &columns,
                              std::uint32_t index) {
    std::uint32_t product = 0;
    for (int k = 0; k < columnsKept; ++k)
        product ^= (0u - (index >> k & 1)) & columns[k];
    return product;
}

/// What tells the pairs of a pixel apart.
inline std::uint32_t shuffleSeed(std::uint32_t key, std::uint32_t pair) {
    return mix(key ^ (pair * 0x9e3779b9u + 0x85ebca6bu));
}

/// The sample's number as a pair shuffles them, bit-reversed: nested uniform scrambling, so this is
/// a scrambled first coordinate, too.
inline std::uint32_t shuffledReversed(std::uint32_t sample, std::uint32_t shuffle) {
    return scrambleReversed(reverseBits(sample), shuffle);
}

inline float unitFloat(std::uint32_t bits) { return float(std::int32_t(bits >> 8)) * 0x1p-24f; }

} // namespace

std::uint32_t pixelKey(int x, int y, std::uint32_t seed) {
    std::uint64_t position = std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y);
    return std::uint32_t(mixBits(mixBits(position) + seed) >> 32);
}

std::uint32_t keyOfOddHalf(std::uint32_t pixelKey) {
    return std::uint32_t(mixBits(std::uint64_t(1) << 32 | pixelKey) >> 32);
}

CANDELA_HOT void sobolPairs(int count, const std::uint32_t *__restrict key,
                            const std::uint32_t *__restrict sample, std::uint32_t pair,
                            float *__restrict x, float *__restrict y) {
    for (int i = 0; i < count; ++i) {
        std::uint32_t shuffle = shuffleSeed(key[i], pair);
        std::uint32_t reversed = shuffledReversed(sample[i], shuffle);
        std::uint32_t second = sobolSecondReversed(reverseBits(reversed));
        x[i] = unitFloat(reversed);
        y[i] = unitFloat(reverseBits(scrambleReversed(second, shuffle * 0x02e5be93u)));
    }
}

CANDELA_HOT void sobolFollowingPairs(int count, const std::uint32_t *__restrict key,
                                     const std::uint32_t *__restrict sample, std::uint32_t pair,
                                     float *__restrict x, float *__restrict y) {
    for (int i = 0; i < count; ++i) {
        std::uint32_t shuffle = shuffleSeed(key[i], pair);
        std::uint32_t index = reverseBits(shuffledReversed(sample[i], shuffle));
        std::uint32_t seed = shuffle + (index >> columnsKept) * 0x9e3779b9u;
        std::uint32_t xSeed = seed * 0x967a889bu, ySeed = seed * 0x5d1b1c4fu;
        x[i] = unitFloat(reverseBits(scrambleReversed(multiply(thirdDimension, index), xSeed)));
        y[i] = unitFloat(reverseBits(scrambleReversed(multiply(fourthDimension, index), ySeed)));
    }
}

CANDELA_HOT void randomBits(int count, const std::uint32_t *__restrict key,
                            const std::uint32_t *__restrict sample, std::uint32_t salt,
                            std::uint32_t *__restrict bits) {
    for (int i = 0; i < count; ++i)
        bits[i] = mix(mix(key[i] ^ (salt * 0x9e3779b9u)) + sample[i] * 0x2545f491u);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// A register of floats for the yardsticks, AVX2's or AVX-512's as the including file is compiled.
// Nothing here is shared with what Candela compiles.
#pragma once

#include "language/runtime/shader_abi.h"

#include <immintrin.h>
#include <sleef.h>

#include <cstdint>

namespace candela::bench {
namespace {

#if defined(__AVX512F__)
constexpr int lanes = 16;
#else
constexpr int lanes = 8;
#endif
using Floats = float __attribute__((vector_size(lanes * 4)));
using Bits = std::uint32_t __attribute__((vector_size(lanes * 4)));
using Integers = std::int32_t __attribute__((vector_size(lanes * 4)));

#if defined(__AVX512F__)
inline Floats load(const float *from) { return Floats(_mm512_loadu_ps(from)); }
inline void store(float *to, Floats x) { _mm512_storeu_ps(to, __m512(x)); }
inline Integers load(const std::int32_t *from) { return Integers(_mm512_loadu_si512(from)); }
inline Floats root(Floats x) { return Floats(_mm512_sqrt_ps(__m512(x))); }
inline Floats floor(Floats x) {
    return Floats(_mm512_roundscale_ps(__m512(x), _MM_FROUND_TO_NEG_INF));
}
inline Bits wholeBits(Floats x) { return Bits(_mm512_cvttps_epi32(__m512(x))); }
inline Floats greater(Floats a, Floats b) { return Floats(_mm512_max_ps(__m512(a), __m512(b))); }
inline Floats smaller(Floats a, Floats b) { return Floats(_mm512_min_ps(__m512(a), __m512(b))); }
/// a b + c, rounded once.
inline Floats fused(Floats a, Floats b, Floats c) {
    return Floats(_mm512_fmadd_ps(__m512(a), __m512(b), __m512(c)));
}
inline Floats power(Floats a, Floats b) {
    return Floats(Sleef_powf16_u10avx512f(__m512(a), __m512(b)));
}
inline bool allEqual(Integers a, std::int32_t b) {
    return _mm512_cmpneq_epi32_mask(__m512i(a), _mm512_set1_epi32(b)) == 0;
}
/// table[index] of sixteen floats.
inline Floats lookUp(const float *table, Bits index) {
    return Floats(_mm512_permutexvar_ps(__m512i(index), _mm512_loadu_ps(table)));
}
#else
inline Floats load(const float *from) { return Floats(_mm256_loadu_ps(from)); }
inline void store(float *to, Floats x) { _mm256_storeu_ps(to, __m256(x)); }
inline Integers load(const std::int32_t *from) {
    return Integers(_mm256_loadu_si256(reinterpret_cast<const __m256i *>(from)));
}
inline Floats root(Floats x) { return Floats(_mm256_sqrt_ps(__m256(x))); }
inline Floats floor(Floats x) { return Floats(_mm256_floor_ps(__m256(x))); }
inline Bits wholeBits(Floats x) { return Bits(_mm256_cvttps_epi32(__m256(x))); }
inline Floats greater(Floats a, Floats b) { return Floats(_mm256_max_ps(__m256(a), __m256(b))); }
inline Floats smaller(Floats a, Floats b) { return Floats(_mm256_min_ps(__m256(a), __m256(b))); }
inline Floats fused(Floats a, Floats b, Floats c) {
    return Floats(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
}
inline Floats power(Floats a, Floats b) {
    return Floats(Sleef_powf8_u10avx2(__m256(a), __m256(b)));
}
inline bool allEqual(Integers a, std::int32_t b) {
    const __m256i same = _mm256_cmpeq_epi32(__m256i(a), _mm256_set1_epi32(b));
    return _mm256_movemask_ps(_mm256_castsi256_ps(same)) == 0xff;
}
inline Floats lookUp(const float *table, Bits index) {
    const __m256 low = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), __m256i(index));
    const __m256 high = _mm256_permutevar8x32_ps(_mm256_loadu_ps(table + 8), __m256i(index));
    return Floats(_mm256_blendv_ps(low, high, __m256(index << 28)));
}
#endif

inline Floats all(float x) { return Floats{} + x; }
inline Floats mixed(Floats a, Floats b, Floats t) { return fused(t, b - a, a); }

/// x, with the sign turned where the bit of `signs` that stands `by` below the sign is set.
inline Floats signedBy(Floats x, Bits signs, int by) {
    return Floats(Bits(x) ^ ((signs << by) & 0x80000000u));
}

/// Points and colours.
struct Three {
    Floats c[3];
    Floats &operator[](int k) { return c[k]; }
    const Floats &operator[](int k) const { return c[k]; }
};

inline Three load(const float *const *planes, int at) {
    return {{load(planes[0] + at), load(planes[1] + at), load(planes[2] + at)}};
}
inline void store(float *const *planes, int at, const Three &value) {
    for (int k = 0; k < 3; ++k)
        store(planes[k] + at, value[k]);
}
inline Three operator+(const Three &a, const Three &b) {
    return {{a[0] + b[0], a[1] + b[1], a[2] + b[2]}};
}
inline Three operator*(const Three &a, const Three &b) {
    return {{a[0] * b[0], a[1] * b[1], a[2] * b[2]}};
}
inline Three operator*(const Three &a, Floats b) { return {{a[0] * b, a[1] * b, a[2] * b}}; }
inline Floats dot(const Three &a, const Three &b) {
    return fused(a[2], b[2], fused(a[1], b[1], a[0] * b[0]));
}
/// A zero vector stays zero.
inline Three normalize(const Three &a) {
    const Floats size = root(dot(a, a));
    return a * (1.0f / (size == 0.0f ? all(1) : size));
}

} // namespace
} // namespace candela::bench

// SPDX-License-Identifier: Apache-2.0
// The two vector types that noise is written over: one lane, and as many as the level's registers
// hold. Plain operators mean the same for both, and each lane rounds as the single one does.
//
// For noise_level.h alone, which is compiled once per instruction-set level: everything here is
// inlined, or the linker could pick one level's copy for all of them.
#pragma once

#include <cstdint>
#include <immintrin.h>

#define CANDELA_INLINE [[gnu::always_inline]] static inline

namespace {

using Floats1 = float;
using Bits1 = std::uint32_t;
#if defined(__AVX512F__)
constexpr int registerBytes = 64;
#elif defined(__AVX2__)
constexpr int registerBytes = 32;
#else
constexpr int registerBytes = 16;
#endif
using WideFloats = float __attribute__((vector_size(registerBytes)));
using WideBits = std::uint32_t __attribute__((vector_size(registerBytes)));
using WideIntegers = std::int32_t __attribute__((vector_size(registerBytes)));

template <typename Floats> struct Lanes;

template <> struct Lanes<Floats1> {
    using Bits = Bits1;
    CANDELA_INLINE Floats1 floor(Floats1 x) {
        return _mm_cvtss_f32(_mm_floor_ss(_mm_set_ss(x), _mm_set_ss(x)));
    }
    /// Of whole numbers; of others than 32 bits hold, always the same.
    CANDELA_INLINE Bits integerBits(Floats1 x) { return Bits(_mm_cvttss_si32(_mm_set_ss(x))); }
    CANDELA_INLINE Floats1 fromSmallInteger(Bits b) { return static_cast<float>(std::int32_t(b)); }
    /// x, or 0 where x is not above it or is no number.
    CANDELA_INLINE Floats1 positive(Floats1 x) { return x > 0 ? x : 0.0f; }
    /// a b + c, rounded once where the level can.
    CANDELA_INLINE Floats1 multiplyAdd(Floats1 a, Floats1 b, Floats1 c) {
#if defined(__FMA__)
        return __builtin_fmaf(a, b, c);
#else
        return a * b + c;
#endif
    }
    /// table[index of the four lowest bits].
    CANDELA_INLINE Floats1 lookUp(const float *table, Bits index) { return table[index & 15]; }
    CANDELA_INLINE Floats1 load(const float *from) { return *from; }
    CANDELA_INLINE void store(float *to, Floats1 x) { *to = x; }
};

template <> struct Lanes<WideFloats> {
    using Bits = WideBits;
    CANDELA_INLINE Bits integerBits(WideFloats x) {
        return WideBits(__builtin_convertvector(x, WideIntegers));
    }
    CANDELA_INLINE WideFloats fromSmallInteger(Bits b) {
        return __builtin_convertvector(WideIntegers(b), WideFloats);
    }
    CANDELA_INLINE WideFloats load(const float *from) {
        return *reinterpret_cast<const WideFloats *>(from);
    }
    CANDELA_INLINE void store(float *to, WideFloats x) { *reinterpret_cast<WideFloats *>(to) = x; }
#if defined(__AVX512F__)
    CANDELA_INLINE WideFloats floor(WideFloats x) {
        return WideFloats(_mm512_roundscale_ps(__m512(x), _MM_FROUND_TO_NEG_INF));
    }
    CANDELA_INLINE WideFloats positive(WideFloats x) {
        return WideFloats(_mm512_max_ps(__m512(x), _mm512_setzero_ps()));
    }
    CANDELA_INLINE WideFloats multiplyAdd(WideFloats a, WideFloats b, WideFloats c) {
        return WideFloats(_mm512_fmadd_ps(__m512(a), __m512(b), __m512(c)));
    }
    CANDELA_INLINE WideFloats lookUp(const float *table, Bits index) {
        return WideFloats(_mm512_permutexvar_ps(__m512i(index), _mm512_load_ps(table)));
    }
#elif defined(__AVX2__)
    CANDELA_INLINE WideFloats floor(WideFloats x) { return WideFloats(_mm256_floor_ps(__m256(x))); }
    CANDELA_INLINE WideFloats positive(WideFloats x) {
        return WideFloats(_mm256_max_ps(__m256(x), _mm256_setzero_ps()));
    }
    CANDELA_INLINE WideFloats multiplyAdd(WideFloats a, WideFloats b, WideFloats c) {
        return WideFloats(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
    }
    /// Of tables whose second half is the first with its signs turned: eight lanes look up eight.
    CANDELA_INLINE WideFloats lookUp(const float *table, Bits index) {
        const __m256 found = _mm256_permutevar8x32_ps(_mm256_load_ps(table), __m256i(index));
        return WideFloats(WideBits(found) ^ ((index << 28) & 0x80000000u));
    }
#else
    CANDELA_INLINE WideFloats floor(WideFloats x) { return WideFloats(_mm_floor_ps(__m128(x))); }
    CANDELA_INLINE WideFloats positive(WideFloats x) {
        return WideFloats(_mm_max_ps(__m128(x), _mm_setzero_ps()));
    }
    CANDELA_INLINE WideFloats multiplyAdd(WideFloats a, WideFloats b, WideFloats c) {
        return a * b + c;
    }
    CANDELA_INLINE WideFloats lookUp(const float *table, Bits index) {
        return WideFloats{table[index[0] & 15], table[index[1] & 15], table[index[2] & 15],
                          table[index[3] & 15]};
    }
#endif
};

} // namespace

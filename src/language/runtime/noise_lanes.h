// SPDX-License-Identifier: Apache-2.0
// The two vector types that noise is written over: one lane, and as many as the level's registers
// hold. Plain operators mean the same for both, and each lane rounds as the single one does.
//
// For noise_level.h alone, which is compiled once per instruction-set level: everything here is
// inlined, or the linker could pick one level's copy for all of them.
#pragma once

#include <cstdint>

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
    CANDELA_INLINE Floats1 truncate(Floats1 x) { return static_cast<float>(std::int32_t(x)); }
    CANDELA_INLINE Bits integerBits(Floats1 x) { return Bits(std::int32_t(x)); }
    CANDELA_INLINE Floats1 fromSmallInteger(Bits b) { return static_cast<float>(std::int32_t(b)); }
    CANDELA_INLINE Floats1 flipSign(Floats1 x, Bits sign) {
        return __builtin_bit_cast(float, __builtin_bit_cast(Bits, x) ^ sign);
    }
    CANDELA_INLINE Floats1 load(const float *from) { return *from; }
    CANDELA_INLINE void store(float *to, Floats1 x) { *to = x; }
};

template <> struct Lanes<WideFloats> {
    using Bits = WideBits;
    CANDELA_INLINE WideFloats truncate(WideFloats x) {
        return __builtin_convertvector(__builtin_convertvector(x, WideIntegers), WideFloats);
    }
    CANDELA_INLINE Bits integerBits(WideFloats x) {
        return WideBits(__builtin_convertvector(x, WideIntegers));
    }
    CANDELA_INLINE WideFloats fromSmallInteger(Bits b) {
        return __builtin_convertvector(WideIntegers(b), WideFloats);
    }
    CANDELA_INLINE WideFloats flipSign(WideFloats x, Bits sign) {
        return WideFloats(WideBits(x) ^ sign);
    }
    CANDELA_INLINE WideFloats load(const float *from) {
        return *reinterpret_cast<const WideFloats *>(from);
    }
    CANDELA_INLINE void store(float *to, WideFloats x) { *reinterpret_cast<WideFloats *>(to) = x; }
};

} // namespace

// SPDX-License-Identifier: Apache-2.0
// The two vector types that noise is written over: one lane, and sixteen. Plain operators mean
// the same for both, and each lane rounds as the single one does.
//
// For noise_level.h alone, which is compiled once per instruction-set level: everything here is
// inlined, or the linker could pick one level's copy for all of them.
#pragma once

#include <cstdint>

#define CANDELA_INLINE [[gnu::always_inline]] static inline

namespace {

using Floats1 = float;
using Bits1 = std::uint32_t;
using Floats16 = float __attribute__((vector_size(64)));
using Bits16 = std::uint32_t __attribute__((vector_size(64)));
using Integers16 = std::int32_t __attribute__((vector_size(64)));

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

template <> struct Lanes<Floats16> {
    using Bits = Bits16;
    CANDELA_INLINE Floats16 truncate(Floats16 x) {
        return __builtin_convertvector(__builtin_convertvector(x, Integers16), Floats16);
    }
    CANDELA_INLINE Bits integerBits(Floats16 x) {
        return Bits16(__builtin_convertvector(x, Integers16));
    }
    CANDELA_INLINE Floats16 fromSmallInteger(Bits b) {
        return __builtin_convertvector(Integers16(b), Floats16);
    }
    CANDELA_INLINE Floats16 flipSign(Floats16 x, Bits sign) { return Floats16(Bits16(x) ^ sign); }
    CANDELA_INLINE Floats16 load(const float *from) {
        return *reinterpret_cast<const Floats16 *>(from);
    }
    CANDELA_INLINE void store(float *to, Floats16 x) { *reinterpret_cast<Floats16 *>(to) = x; }
};

} // namespace

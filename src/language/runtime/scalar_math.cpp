// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/scalar_math.h"

#include "foundation/base/instruction_set.h"
#include "language/runtime/isa_level.h"

#include <cmath>

namespace candela::runtime {

// SLEEF's "finz" and "cinz" families are the ones whose scalar and vector members agree bit by
// bit; the plain scalar functions differ from the vector ones in about one argument in a hundred.
// (sleef.h declares the half of them that the including file's own flags allow.)
#define CHOOSE(name)                                                                               \
    (hostIsaLevel() == IsaLevel::V2 ? Sleef_cinz_##name##f1_u10purec                               \
                                    : Sleef_finz_##name##f1_u10purecfma)
#define UNARY(name)                                                                                \
    extern "C" float Sleef_cinz_##name##f1_u10purec(float);                                        \
    extern "C" float Sleef_finz_##name##f1_u10purecfma(float);                                     \
    static float raw_##name(float x) {                                                             \
        static const auto function = CHOOSE(name);                                                 \
        return function(x);                                                                        \
    }
#define BINARY(name)                                                                               \
    extern "C" float Sleef_cinz_##name##f1_u10purec(float, float);                                 \
    extern "C" float Sleef_finz_##name##f1_u10purecfma(float, float);                              \
    static float raw_##name(float x, float y) {                                                    \
        static const auto function = CHOOSE(name);                                                 \
        return function(x, y);                                                                     \
    }
UNARY(sin)
UNARY(cos)
UNARY(tan)
UNARY(asin)
UNARY(acos)
UNARY(atan)
UNARY(exp)
UNARY(log)
BINARY(atan2)
BINARY(pow)
#undef CHOOSE
#undef UNARY
#undef BINARY

static float clampToUnit(float x) {
    const float atLeast = x > -1.0f ? x : -1.0f;
    return atLeast < 1.0f ? atLeast : 1.0f;
}

IsaLevel hostIsaLevel() {
    static_assert(int(IsaLevel::V2) == int(InstructionSet::V2) &&
                  int(IsaLevel::V4) == int(InstructionSet::V4));
    return IsaLevel(instructionSet());
}

float sin(float radians) { return raw_sin(radians); }
float cos(float radians) { return raw_cos(radians); }
float tan(float radians) { return raw_tan(radians); }
float asin(float x) { return raw_asin(clampToUnit(x)); }
float acos(float x) { return raw_acos(clampToUnit(x)); }
float atan(float x) { return raw_atan(x); }
float atan2(float y, float x) { return raw_atan2(y, x); }
float exp(float x) { return raw_exp(x); }
float log(float x) { return raw_log(x); }

float pow(float base, float exponent) {
    if (base < 0.0f && exponent != std::floor(exponent))
        return 0.0f;
    return raw_pow(base, exponent);
}

} // namespace candela::runtime

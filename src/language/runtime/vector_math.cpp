// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/vector_math.h"

namespace candela::runtime {

// Only addresses are taken here, so the functions are declared without their vector types, which
// the baseline instruction set doesn't have.
#define MATH_FUNCTIONS(each)                                                                       \
    each(sin) each(cos) each(tan) each(asin) each(acos) each(atan) each(atan2) each(exp) each(log) \
        each(pow)
#define DECLARE(name)                                                                              \
    extern "C" void Sleef_cinz_##name##f1_u10purec();                                              \
    extern "C" void Sleef_finz_##name##f1_u10purecfma();                                           \
    extern "C" void Sleef_cinz_##name##f4_u10sse4();                                               \
    extern "C" void Sleef_finz_##name##f8_u10avx2();                                               \
    extern "C" void Sleef_finz_##name##f16_u10avx512f();
MATH_FUNCTIONS(DECLARE)
#undef DECLARE

#define CODE(symbol, width) {#symbol, reinterpret_cast<void *>(symbol), width},
#define SCALAR(name) CODE(Sleef_cinz_##name##f1_u10purec, 1)
#define SCALAR_FMA(name) CODE(Sleef_finz_##name##f1_u10purecfma, 1)
#define SSE4(name) CODE(Sleef_cinz_##name##f4_u10sse4, 4)
#define AVX2(name) CODE(Sleef_finz_##name##f8_u10avx2, 8)
#define AVX512(name) CODE(Sleef_finz_##name##f16_u10avx512f, 16)

MathCode scalarMath(MathFunction function, IsaLevel level) {
    static const MathCode plain[] = {MATH_FUNCTIONS(SCALAR)};
    static const MathCode fused[] = {MATH_FUNCTIONS(SCALAR_FMA)};
    return level == IsaLevel::V2 ? plain[int(function)] : fused[int(function)];
}

MathCode vectorMath(MathFunction function, IsaLevel level) {
    static const MathCode v2[] = {MATH_FUNCTIONS(SSE4)};
    static const MathCode v3[] = {MATH_FUNCTIONS(AVX2)};
    static const MathCode v4[] = {MATH_FUNCTIONS(AVX512)};
    static const MathCode *const tables[] = {v2, v3, v4};
    return tables[int(level)][int(function)];
}

} // namespace candela::runtime

// SPDX-License-Identifier: Apache-2.0
// Noise, compiled for x86-64-v4 (flags in CMakeLists.txt).
#include "language/runtime/noise_level.h"

namespace candela::runtime {

LevelCode noiseV4(RuntimeFunction function, bool wide) {
    return wide ? noiseCode<WideFloats>(int(function)) : noiseCode<Floats1>(int(function));
}

} // namespace candela::runtime

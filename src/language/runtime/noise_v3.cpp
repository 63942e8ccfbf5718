// SPDX-License-Identifier: Apache-2.0
// Noise, compiled for x86-64-v3 (flags in CMakeLists.txt).
#include "language/runtime/noise_level.h"

namespace candela::runtime {

RuntimeCode noiseV3(RuntimeFunction function, int width) {
    const int index = int(function);
    return width == 1 ? NoiseTable<1>::code[index] : NoiseTable<16>::code[index];
}

} // namespace candela::runtime

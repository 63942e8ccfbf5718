// SPDX-License-Identifier: Apache-2.0
// Bounds, compiled for x86-64-v3 (flags in CMakeLists.txt).
#include "language/runtime/bound_level.h"

namespace candela::runtime {

LevelCode boundV3(RuntimeFunction function, bool wide) {
    return wide ? boundCode<WideFloats>(int(function)) : boundCode<Floats1>(int(function));
}

} // namespace candela::runtime

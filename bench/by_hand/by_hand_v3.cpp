// SPDX-License-Identifier: Apache-2.0
// The yardsticks, compiled for x86-64-v3.
#include "shaders.h"

namespace candela::bench {

HandShader handShaderV3(int number) { return table[number]; }

} // namespace candela::bench

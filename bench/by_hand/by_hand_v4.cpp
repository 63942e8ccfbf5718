// SPDX-License-Identifier: Apache-2.0
// The yardsticks, compiled for x86-64-v4.
#include "shaders.h"

namespace candela::bench {

HandShader handShaderV4(int number) { return table[number]; }

} // namespace candela::bench

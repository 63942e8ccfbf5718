// SPDX-License-Identifier: Apache-2.0
// Shaders written by hand, in the order of shading_cases.h.
#pragma once

#include "language/runtime/isa_level.h"
#include "language/runtime/shader_abi.h"

namespace candela::bench {

/// Wants a multiple of sixteen points.
using HandShader = void (*)(const ShaderArgs *);

HandShader handShaderV3(int number);
HandShader handShaderV4(int number);

} // namespace candela::bench

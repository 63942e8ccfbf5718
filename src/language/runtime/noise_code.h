// SPDX-License-Identifier: Apache-2.0
// Where the code of noise is: between noise_v*.cpp, each compiled for a level, and
// runtime_functions.cpp.
#pragma once

#include "language/runtime/register_code.h"

namespace candela::runtime {

struct NoiseCode {
    RuntimeCode throughMemory;
    const void *inRegisters; ///< As registerCode() has it.
};

/// At width 1, or as wide as the level's registers.
NoiseCode noiseV2(RuntimeFunction, bool wide);
NoiseCode noiseV3(RuntimeFunction, bool wide);
NoiseCode noiseV4(RuntimeFunction, bool wide);

} // namespace candela::runtime

// SPDX-License-Identifier: Apache-2.0
// Where the code of runtime functions is: between noise_v*.cpp and bound_v*.cpp, each compiled for
// a level, and runtime_functions.cpp.
#pragma once

#include "language/runtime/register_code.h"

namespace candela::runtime {

struct LevelCode {
    RuntimeCode throughMemory;
    const void *inRegisters; ///< As registerCode() has it.
};

/// The rows of functions.def before this one are noise, it and those behind it are of bounds.
inline constexpr RuntimeFunction firstBound = RuntimeFunction::bound_settle;

/// At width 1, or as wide as the level's registers.
LevelCode noiseV2(RuntimeFunction, bool wide);
LevelCode noiseV3(RuntimeFunction, bool wide);
LevelCode noiseV4(RuntimeFunction, bool wide);
LevelCode boundV2(RuntimeFunction, bool wide);
LevelCode boundV3(RuntimeFunction, bool wide);
LevelCode boundV4(RuntimeFunction, bool wide);

} // namespace candela::runtime

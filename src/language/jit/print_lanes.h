// SPDX-License-Identifier: Apache-2.0
// What compiled code calls to speak: printf(), indices outside arrays, loops that do not end.
#pragma once

#include "language/runtime/shader_abi.h"

namespace candela {

/// Prints operand 0, a format, with the other operands, once per active lane. `types` has a letter
/// an operand: f float, i integer or bool, s string (as an offset into `strings`); operand k of
/// lane j is cells[k * width + j].
void printLanes(const ShaderArgs *, const char *strings, const char *types,
                std::int32_t operandCount, const std::int32_t *cells, std::int32_t width,
                std::uint32_t activeLanes);

/// Passes the place of an index outside its array on to ShaderCallbacks::indexOutside, if any.
void reportIndexOutside(const ShaderArgs *, const char *file, std::int32_t line);
/// The same of a loop that has been ended: ShaderCallbacks::loopEnded.
void reportLoopEnded(const ShaderArgs *, const char *file, std::int32_t line);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The x86-64 level (of the psABI) whose instructions are used: by functions marked CANDELA_HOT or
// CANDELA_WIDE, by Embree and by compiled shaders alike.
#pragma once

#include <optional>
#include <string_view>

namespace candela {

/// V2 has SSE4.2, V3 AVX2 and FMA, V4 AVX-512 (F, BW, CD, DQ, VL).
enum class InstructionSet { V2, V3, V4 };

/// The best that this machine has.
InstructionSet hostInstructionSet();

/// The one in force, the same for the whole life of the process: the host's best, or a lower one
/// that the option --cpu or else the environment variable CANDELA_CPU names.
InstructionSet instructionSet();

/// "v2", "v3" or "v4"
const char *nameOf(InstructionSet);
std::optional<InstructionSet> instructionSetOf(std::string_view name);

} // namespace candela

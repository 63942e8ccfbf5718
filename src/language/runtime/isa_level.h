// SPDX-License-Identifier: Apache-2.0
// The instruction-set levels that the runtime is compiled for.
#pragma once

namespace candela::runtime {

/// The x86-64 psABI levels. From V3 on there is FMA, and transcendentals use it: results of
/// transcendental functions agree between V3 and V4 and between all widths of one level.
enum class IsaLevel { V2, V3, V4 };

/// The level in force (foundation/base/instruction_set.h).
IsaLevel hostIsaLevel();

} // namespace candela::runtime

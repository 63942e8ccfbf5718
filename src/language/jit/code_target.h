// SPDX-License-Identifier: Apache-2.0
// What code is generated for.
#pragma once

#include "language/runtime/image_map.h"
#include "language/runtime/register_code.h"

#include <algorithm>
#include <string>

namespace candela {

struct CodeTarget {
    int width = 16;
    std::string cpu;      ///< LLVM's name.
    std::string features; ///< LLVM's "+a,-b" beyond what the name implies.
    runtime::IsaLevel level = runtime::IsaLevel::V2;

    /// Operations of the IR that a machine function holds at most, or about; a longer one is
    /// compiled in pieces.
    int longestFunction = 2000;

    int registersTogether = 1; ///< As ir::Function has it.

    /// Points that code takes at a time: at width 16 mostly as many as a register holds. Twice as
    /// many would be twice the instructions to select and half the registers to hold values in.
    int lanes() const {
        const int together = runtime::registerLanes(level) * registersTogether;
        return width == 1 ? 1 : std::min(together, mostPixelsTogether);
    }
    /// Bits of the widest vector register.
    int registerBits() const { return 32 * runtime::registerLanes(level); }
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What code is generated for.
#pragma once

#include "language/runtime/isa_level.h"

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

    /// Bits of the widest vector register.
    int registerBits() const {
        return level == runtime::IsaLevel::V4 ? 512 : level == runtime::IsaLevel::V3 ? 256 : 128;
    }
};

} // namespace candela

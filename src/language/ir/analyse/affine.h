// SPDX-License-Identifier: Apache-2.0
// Is what a surface sends on affine in the light it receives, channel by channel?
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Affine: Ci is Ce plus, over all light samples, what each sample alone adds, in proportion to
/// its Cl; and each channel of Ci takes only the same channel of Cl.
struct AffineProof {
    bool affine = true;
    int line = 0; ///< Where it breaks; 0 if it holds.
};
AffineProof proveAffine(const Function &whole);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Is what a surface sends on affine in the light it receives, channel by channel? Is what a volume
// makes of a segment affine in what there is at its end?
#pragma once

#include "language/ir/core/ir.h"

#include <optional>
#include <vector>

namespace candela::ir {

/// Affine: Ci is Ce plus, over all light samples, what each sample alone adds, in proportion to
/// its Cl; and each channel of Ci takes only the same channel of Cl.
struct AffineProof {
    bool affine = true;
    int line = 0; ///< Where it breaks; 0 if it holds.
};
AffineProof proveAffine(const Function &whole);

/// Affine: a volume's Ci is a multiple of Ci at the segment's end, and one of Oi there, channel by
/// channel, and something besides; its Oi likewise, but Ci has no part in it.
struct ArrivalProof : AffineProof {
    struct Changes {
        bool withCi = false, withOi = false;
    };
    std::vector<Changes> ofValue, ofArray; ///< By ValueId, and by array.
};
ArrivalProof proveAffineInArrival(const Function &whole);

/// The channel that an input plane is of what a volume is given: those of Ci, and then those of Oi.
std::optional<int> arrivalChannel(const Function &, int input);

} // namespace candela::ir

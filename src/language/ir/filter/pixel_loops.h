// SPDX-License-Identifier: Apache-2.0
// A filter's loops over pixels whose turns do not see each other, as functions of their own that
// run on all cores and lanes.
#pragma once

#include "language/ir/core/ir.h"

namespace candela::ir {

/// Puts a PixelLoop in the place of each loop over columns within one over rows (or the other way
/// round, or of a single one) whose turns may run in any order, or at once: see
/// docs/filters/language.md for the rules. All others stay as they are. `filter` is a whole text in
/// which all values are uniform.
Function extractPixelLoops(Function filter);

/// What changes nothing where it is reduced with other values.
float neutralOf(Reduction);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Reads what falsecolor has written beside its scale.
#pragma once

#include "tests/filter_library/support/picture.h"

#include <string>
#include <vector>

namespace candela::filters {

struct Label {
    double place = 0; ///< of its line, 0 at the scale's bottom and 1 at its top
    std::string text;
};

struct Legend {
    std::string unit;          ///< "^" stands for a raised 2
    std::vector<Label> labels; ///< From the bottom.
};

/// `columns`: of the picture without what may stand beside it; the legend's are the last ones.
Legend readLegend(const Picture &, int columns);

} // namespace candela::filters

// SPDX-License-Identifier: Apache-2.0
// Filters written by hand, on all cores.
#pragma once

#include "image/filter/image_maps.h"

namespace candela::bench {

using HandFilter = void (*)(const ImageMap &from, const ImageMap &to);

struct HandFilters {
    HandFilter ward94; ///< L_dmax 100, adapted to the mean.
    HandFilter box21;  ///< The mean of 21 x 21 pixels, borders as image() has them.
};
const HandFilters &handFiltersV3();
const HandFilters &handFiltersV4();

} // namespace candela::bench

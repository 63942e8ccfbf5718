// SPDX-License-Identifier: Apache-2.0
// Filters by hand, compiled for x86-64-v4.
#include "by_hand/filter_loops.h"

namespace candela::bench {

const HandFilters &handFiltersV4() { return filters; }

} // namespace candela::bench

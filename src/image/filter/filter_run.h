// SPDX-License-Identifier: Apache-2.0
// One filter at work: its maps, its pixel loops, what it asks while it runs.
#pragma once

#include "image/filter/filter_watch.h"

namespace candela {

/// Runs the filter: "Cs" is what `maps` has as "Ci", which becomes what the filter makes of it.
/// Places and maps that it cannot have are reported, and the maps then stay as they are.
void runFilter(const FilterCode &, ImageMaps &maps, FilterWatch &, DiagnosticSink &);

} // namespace candela

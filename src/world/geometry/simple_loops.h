// SPDX-License-Identifier: Apache-2.0
// Whether segments in the plane leave each other alone.
#pragma once

#include "world/geometry/segment_crossings.h"

namespace candela {

/// Do any two of them have a point in common that is no end of both? Takes n log n (Shamos and Hoey
/// 1976).
bool meetWithin(std::span<const FlatSegment>);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What records of the interface are made into.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

using SurfaceList = std::vector<std::shared_ptr<const Surface>>;

} // namespace candela

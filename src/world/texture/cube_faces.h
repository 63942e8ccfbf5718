// SPDX-License-Identifier: Apache-2.0
// Six views around a point as one latitude-longitude picture.
#pragma once

#include "world/texture/picture_library.h"

#include <array>

namespace candela {

/// px, nx, py, ny, pz, nz, with the axes that RI 3.2, 7.1.2 gives them, each of `fieldOfView`
/// degrees across, from 90 on; what of them lies beyond 90 degrees is left. The result shows a
/// direction as finely as the faces do at their middles. Nothing, and `problem` says why, if
/// they do not have the same size and channels.
std::optional<PictureData> latLongOfFaces(const std::array<PictureData, 6> &, float fieldOfView,
                                          std::string &problem);

} // namespace candela

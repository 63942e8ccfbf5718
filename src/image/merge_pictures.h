// SPDX-License-Identifier: Apache-2.0
// Pictures of one scene by different seeds as the picture of all their samples.
#pragma once

#include "image/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

struct NamedPicture {
    std::string name; ///< For messages: its file.
    Picture picture;
};

/// Means by the numbers of samples ("spp"), variances as those of such means, Z the nearest, id
/// that of the first. Nothing, and `problem` says why, if two are of one seed, if they are not of
/// one frame, channels and integrator, or if their values are no longer means of samples: exposed,
/// quantised, filtered. At least one picture.
std::optional<Picture> mergePictures(const std::vector<NamedPicture> &, std::string &problem);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Stored pictures as the maps that filters read, and back.
#pragma once

#include "image/filter/image_maps.h"
#include "image/picture.h"

#include <span>
#include <string>

namespace candela {

/// "Ci" from R, G, B (or Y; without these from the layer "radiance"), and of the maps `names` those
/// that the picture has: "Oi" from the layer "Oi" or from A (1 without either), "Z" from Z, others
/// from the channel or the layer of their name ("id"; "N.X", "N.Y", "N.Z"). As in a film's maps,
/// what is not finite is 0, but for Ci. Without channels for Ci there are no maps, and `problem`
/// says so.
ImageMaps mapsOf(const Picture &, std::span<const std::string> names, std::string &problem);

/// Puts Ci, as filters have left it, into the channels R, G, B, and each of the maps `set` into its
/// own. If their size is another one, the picture takes it, and channels that have it not are taken
/// out: their names are returned.
std::vector<std::string> putMaps(const ImageMaps &, std::span<const std::string> set, Picture &);

} // namespace candela

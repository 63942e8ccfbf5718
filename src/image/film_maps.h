// SPDX-License-Identifier: Apache-2.0
// The film's channels as the maps that filters read. Only what is asked for is kept and made.
#pragma once

#include "image/film.h"
#include "image/filter/image_maps.h"

#include <span>
#include <string>
#include <vector>

namespace candela {

/// Adds to `film` what it has to keep for maps of these names: channels of those that are
/// `available`, halves. Names that no film gives are left to the filters.
void wantMaps(std::span<const std::string> names, std::span<const ChannelInfo> available,
              Film::Settings &film);

/// The maps that every film has, and their components: "Ci", "Oi", "Z", "variance" ...
std::vector<ChannelInfo> mapsOfEveryFilm();

/// Makes "Ci", and those of `names` that the film has and that are not there yet: "Oi", "Z",
/// "variance" (of the pixel mean of Ci), "half0" and "half1" (Ci of the even and of the odd
/// samples), "radiance" (Ci), and its channels by their names. What is not finite (the variance of
/// a single sample) is 0.
void addMaps(const Film &, std::span<const std::string> names, ImageMaps &);

/// What maps of these names take, with Ci twice: what a filter reads and what it writes.
double bytesOfMaps(std::span<const std::string> names, const Film::Settings &film);

} // namespace candela

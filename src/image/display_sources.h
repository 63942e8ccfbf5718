// SPDX-License-Identifier: Apache-2.0
// Where displays take their planes from: the film, what filters have made of it, and what an imager
// has made of that.
#pragma once

#include "image/display_planes.h"
#include "image/film.h"
#include "image/filter/image_maps.h"

#include <optional>
#include <string>
#include <vector>

namespace candela {

/// In pixels.
struct PlaneSize {
    int width = 0, height = 0;
    friend bool operator==(const PlaneSize &, const PlaneSize &) = default;
};

/// What a stack of filters leaves behind.
struct FilteredPicture {
    ImageMaps maps;
    std::vector<std::string> set; ///< Which of them filters have set, beside "Ci".
    std::string filters;          ///< Which filters ran, as files name them.
};

/// Ci after exposure and imager, and the alpha that goes with it; rows without gaps.
struct ImagedPicture {
    PlaneSize size;
    std::vector<std::vector<float>> color; ///< Of each colour sample.
    std::vector<float> alpha;
};

struct DisplaySources {
    DisplaySources(const Film &film, const FilteredPicture *filtered = nullptr,
                   const ImagedPicture *imaged = nullptr)
        : film(film), filtered(filtered), imaged(imaged) {}
    const Film &film;
    const FilteredPicture *filtered; ///< Null = no filters.
    const ImagedPicture *imaged;     ///< Null = no imager.
};

/// A plane before quantisation, rows without gaps.
struct SourcePlane {
    std::vector<float> values;
    bool exposed = false; ///< Exposure and imager have been there.
};

/// Colour is Ci as the filters have left it, alpha and colour what an imager has made of it.
/// All else is the film's, but for what a filter has set itself. Halves are the film's. Nothing if
/// nobody has such a plane.
std::optional<SourcePlane> sourcePlane(const DisplaySources &, const DisplayPlane &,
                                       FilmHalf = FilmHalf::Both);
/// Likewise, of the whole picture.
std::optional<PlaneSize> sizeOfPlane(const DisplaySources &, const DisplayPlane &);
/// True if it comes from the filters.
bool isFiltered(const DisplaySources &, const DisplayPlane &);

} // namespace candela

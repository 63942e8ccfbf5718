// SPDX-License-Identifier: Apache-2.0
// From the numbers of a file to light.
#pragma once

#include "world/texture/picture_library.h"

#include <OpenImageIO/imageio.h>

namespace candela {

/// What stands between a file's numbers and linear light.
struct ColorCurve {
    bool srgb = false;
    float gamma = 1; ///< Used unless `srgb`.

    bool isLinear() const { return !srgb && gamma == 1; }
    float light(float value) const;
};

/// Of an open picture. Files of one or two channels hold heights, masks and the like
/// and are taken as they are unless they are said to be sRGB; so are floats.
ColorCurve curveOf(const OIIO::ImageInput &, const std::string &path, PictureCurve told);

/// Puts light in the place of a row's numbers: colours, not alpha, by which they are multiplied
/// then if the file has not done so.
void makeLinear(const ColorCurve &, const OIIO::ImageSpec &, int pixels, float *values);

} // namespace candela

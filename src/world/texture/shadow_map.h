// SPDX-License-Identifier: Apache-2.0
// Depth as a light sees it, and what it hides (OpenImageIO's own shadow lookups do not work).
#pragma once

#include "foundation/base/vec3.h"
#include "world/texture/picture_library.h"

#include <optional>

namespace candela {

/// A point and its changes along the axes of its footprint, in the space that the map starts from.
struct PointReach {
    Vec3 P, x, y;
};

class ShadowMap {
public:
    /// Of depths in the first channel of a picture that knows its camera; nothing, and `problem`
    /// says why, if it does not.
    static std::optional<ShadowMap> of(PictureData, std::string &problem);

    /// The share of the footprint that is hidden, in [0,1]: comparisons are averaged, not depths
    /// (percentage closer filtering). `sBlur` and `tBlur` are shares of the whole map that are
    /// averaged besides; `samples` places are compared, with the four pixels around each. A point
    /// is hidden by what lies nearer than its own depth less `bias` (in the world's units); a bias
    /// below 0 stands for what a surface that slants by 45 degrees needs over the area that is
    /// averaged. Outside the map and behind its camera nothing is hidden.
    float hidden(const PointReach &worldPoint, float sBlur, float tBlur, float bias,
                 int samples) const;

private:
    explicit ShadowMap(PictureData picture) : picture_(std::move(picture)) {}

    /// On the map, in pixels.
    struct Place {
        double x, y;
    };
    Place placeOf(const Vec3 &worldPoint) const;
    bool isHiddenAt(int column, int row, double depth) const;
    double hiddenAround(const Place &, double depth) const;

    PictureData picture_;
    double unitsAcross_ = 0; ///< Width of a pixel at depth 1 (perspective) or any (parallel).
    bool perspective_ = false;
};

} // namespace candela

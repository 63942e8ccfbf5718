// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/level_of_detail.h"

#include "interface/ri/raster_detail.h"

#include <limits>

namespace candela {

static float sizeOf(const Attributes &attributes, const Matrix4 &currentFromOuter,
                    const Options &options) {
    if (options.relativeDetail == 0)
        return 0;
    if (!attributes.detail)
        return std::numeric_limits<float>::infinity();
    const auto &[bound, outerFromBound, ofObject] = *attributes.detail;
    return options.relativeDetail *
           rasterDetail(bound,
                        ofObject ? outerFromBound * inDouble(currentFromOuter) : outerFromBound,
                        options);
}

/// How far it is from low to high, which may be infinite, in [0,1].
static float share(float size, float low, float high) {
    return high < std::numeric_limits<float>::infinity() ? (size - low) / (high - low) : 0;
}

Presence presenceOf(const Attributes &attributes, const Matrix4 &currentFromOuter,
                    const Options &options) {
    const auto [least, lower, upper, most] = attributes.detailRange;
    if (least <= 0 && lower <= 0 && upper == std::numeric_limits<float>::infinity())
        return {};
    const float size = sizeOf(attributes, currentFromOuter, options);
    if (size < least || size > most)
        return {0, 0};
    if (size < lower)
        return {0, share(size, least, lower)};
    if (size > upper)
        return {share(size, upper, most), 1};
    return {};
}

} // namespace candela

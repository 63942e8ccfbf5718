// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/options.h"

#include <algorithm>
#include <cmath>

namespace candela {

static float aspectRatioOf(const FrameFormat &format) {
    return float(format.xResolution) * format.pixelAspectRatio / float(format.yResolution);
}

std::array<float, 4> FrameFormat::effectiveScreenWindow() const {
    if (screenWindow)
        return *screenWindow;
    float aspect = frameAspectRatio.value_or(aspectRatioOf(*this));
    if (aspect >= 1)
        return {-aspect, aspect, -1, 1};
    return {-1, 1, -1 / aspect, 1 / aspect};
}

std::array<int, 2> FrameFormat::effectiveResolution() const {
    if (!frameAspectRatio)
        return {xResolution, yResolution};
    float whole = aspectRatioOf(*this);
    // The frame lies inside the format: a wider one loses rows, a narrower one columns.
    if (*frameAspectRatio >= whole) {
        float rows = float(xResolution) * pixelAspectRatio / *frameAspectRatio;
        return {xResolution, std::clamp(int(std::lround(rows)), 1, yResolution)};
    }
    float columns = float(yResolution) * *frameAspectRatio / pixelAspectRatio;
    return {std::clamp(int(std::lround(columns)), 1, xResolution), yResolution};
}

/// Tiles that share an edge of the window share this number, so they join without overlap. In
/// single precision on purpose: there 0.1 * 640 is 64, as the user means it.
static int firstPixelFrom(float edge, int resolution) {
    float pixel = std::ceil(edge * float(resolution));
    return int(std::clamp(pixel, 0.0f, float(resolution)));
}

std::array<int, 4> FrameFormat::cropPixels() const {
    auto [width, height] = effectiveResolution();
    return {firstPixelFrom(cropWindow[0], width), firstPixelFrom(cropWindow[1], width),
            firstPixelFrom(cropWindow[2], height), firstPixelFrom(cropWindow[3], height)};
}

} // namespace candela

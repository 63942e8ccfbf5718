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

/// Tiles that share an edge of the window share this number, so they join without overlap. What the
/// edge lost as a float counts for nothing: 0.1 * 640 is 64 and 0.6 * 100 is 60, as the user means
/// it.
static int firstPixelFrom(float edge, int resolution) {
    constexpr double withoutRounding = 1 - 1.0 / (1 << 23);
    const double pixel = std::ceil(double(edge) * resolution * withoutRounding);
    return int(std::clamp(pixel, 0.0, double(resolution)));
}

std::array<int, 4> FrameFormat::cropPixels() const {
    auto [width, height] = effectiveResolution();
    return {firstPixelFrom(cropWindow[0], width), firstPixelFrom(cropWindow[1], width),
            firstPixelFrom(cropWindow[2], height), firstPixelFrom(cropWindow[3], height)};
}

} // namespace candela

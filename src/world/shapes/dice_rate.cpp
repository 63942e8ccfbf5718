// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/dice_rate.h"

#include <algorithm>
#include <cmath>

namespace candela {

Box3 transformBox(const Matrix4 &matrix, const Box3 &box) {
    Box3 result;
    for (int corner = 0; corner < 8; ++corner)
        result.add(transformPoint(matrix, {corner & 1 ? box.high.x : box.low.x,
                                           corner & 2 ? box.high.y : box.low.y,
                                           corner & 4 ? box.high.z : box.low.z}));
    return result;
}

float largestStretch(const Matrix4 &matrix) {
    // Power iteration on M M^T, from a direction that is no axis. Norms grow until they are the
    // largest there is: at once where all directions are stretched alike, as most instances are.
    double v[3] = {0.7, 0.5, 0.6}, stretch = 0;
    for (int step = 0; step < 24; ++step) {
        double w[3] = {}, next[3] = {}, norm = 0;
        for (int column = 0; column < 3; ++column)
            for (int row = 0; row < 3; ++row)
                w[column] += v[row] * matrix.at(row, column);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column)
                next[row] += w[column] * matrix.at(row, column);
            norm += next[row] * next[row];
        }
        norm = std::sqrt(norm);
        if (!(norm > 0))
            return 0;
        constexpr double rounding = 1e-15;
        if (norm <= stretch * (1 + rounding))
            break;
        stretch = norm;
        for (int row = 0; row < 3; ++row)
            v[row] = next[row] / norm;
    }
    return float(std::sqrt(stretch));
}

float viewingDepth(const Box3 &box) {
    Vec3 extent = box.extent();
    float size = std::max({extent.x, extent.y, extent.z});
    constexpr float around = 0.1f;
    if (box.low.z > 0)
        return std::max(box.low.z, 1e-3f * size);
    if (box.high.z > 0)
        return around * size;
    Vec3 outside;
    for (int axis = 0; axis < 3; ++axis)
        outside[axis] = std::max({box.low[axis], -box.high[axis], 0.0f});
    return std::max(length(outside), size);
}

float unseenPixel(const Box3 &box) {
    constexpr float pixelsAcross = 1000;
    const Vec3 extent = box.extent();
    return std::max({extent.x, extent.y, extent.z}) / pixelsAcross;
}

static float stillPixel(const Camera &camera, const Box3 &box) {
    const std::optional<float> shown = camera.shownDepth(box);
    const float pixel = camera.pixelSize(std::max(viewingDepth(box), shown.value_or(0)));
    return shown ? pixel : std::max(pixel, unseenPixel(box));
}

float viewingPixel(const Camera &camera, const Box3 &box) {
    float least = stillPixel(camera, box);
    for (const Matrix4 &step : camera.cameraFromCurrent())
        least = std::min(least, stillPixel(camera, transformBox(step, box)));
    return least;
}

} // namespace candela

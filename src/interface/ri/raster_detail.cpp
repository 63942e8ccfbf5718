// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/raster_detail.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

float rasterDetail(const std::array<float, 6> &bound, const Matrix4d &currentFromObject,
                   const Options &options) {
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const CameraRecord &camera = options.camera;
    const Matrix4 cameraFromObject = currentFromObject.rounded();
    const float tangent = std::tan(camera.fieldOfView * float(M_PI) / 360);
    float low[2] = {infinite, infinite}, high[2] = {-infinite, -infinite};
    for (int corner = 0; corner < 8; ++corner) {
        Vec3 point = transformPoint(cameraFromObject, {bound[std::size_t(corner & 1)],
                                                       bound[std::size_t(2 + (corner >> 1 & 1))],
                                                       bound[std::size_t(4 + (corner >> 2))]});
        if (camera.perspective) {
            if (!(point.z > 0))
                return infinite;
            point.x /= point.z * tangent, point.y /= point.z * tangent;
        }
        const Vec3 screen = transformPoint(camera.screenFromProjected, {point.x, point.y, 0});
        const float at[2] = {screen.x, screen.y};
        for (int axis = 0; axis < 2; ++axis) {
            low[axis] = std::min(low[axis], at[axis]);
            high[axis] = std::max(high[axis], at[axis]);
        }
    }
    const auto window = options.format.effectiveScreenWindow();
    const auto resolution = options.format.effectiveResolution();
    const float width = (high[0] - low[0]) / std::fabs(window[1] - window[0]);
    const float height = (high[1] - low[1]) / std::fabs(window[3] - window[2]);
    const float area = width * float(resolution[0]) * height * float(resolution[1]);
    return std::isfinite(area) ? area : infinite;
}

} // namespace candela

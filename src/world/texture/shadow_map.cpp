// SPDX-License-Identifier: Apache-2.0
#include "world/texture/shadow_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

namespace {

/// The point's homogeneous place, in double: maps are looked up far from the origin, too.
std::array<double, 4> placed(const Matrix4 &matrix, const Vec3 &p) {
    std::array<double, 4> to{};
    for (int column = 0; column < 4; ++column)
        to[std::size_t(column)] = double(p.x) * matrix.at(0, column) +
                                  double(p.y) * matrix.at(1, column) +
                                  double(p.z) * matrix.at(2, column) + matrix.at(3, column);
    return to;
}

double sizeOf(double x, double y) { return std::hypot(x, y); }

} // namespace

std::optional<ShadowMap> ShadowMap::of(PictureData picture, std::string &problem) {
    const PictureFacts &facts = picture.facts;
    if (!facts.cameraFromWorld || !facts.frameFromWorld) {
        problem = "it is no shadow map: it does not say what camera has taken it";
        return std::nullopt;
    }
    ShadowMap map(std::move(picture));
    const auto cameraToWorld = inverse(*map.picture_.facts.cameraFromWorld);
    if (!cameraToWorld) {
        problem = "it is no shadow map: its camera's matrix is singular";
        return std::nullopt;
    }
    // A step to the side at depth 1 and 2, in pixels.
    const auto columnAt = [&](float x, float z) {
        return map.placeOf(transformPoint(*cameraToWorld, {x, 0, z})).x;
    };
    const double near = std::abs(columnAt(1, 1) - columnAt(0, 1));
    const double far = std::abs(columnAt(1, 2) - columnAt(0, 2));
    map.perspective_ = far < 0.75 * near;
    map.unitsAcross_ = near > 0 ? 1 / near : 0;
    return map;
}

ShadowMap::Place ShadowMap::placeOf(const Vec3 &point) const {
    const PictureFacts &facts = picture_.facts;
    const auto on = placed(*facts.frameFromWorld, point);
    return {on[0] / on[3] * facts.frameWidth - facts.left,
            on[1] / on[3] * facts.frameHeight - facts.top};
}

bool ShadowMap::isHiddenAt(int column, int row, double depth) const {
    const PictureFacts &facts = picture_.facts;
    if (column < 0 || row < 0 || column >= facts.width || row >= facts.height)
        return false;
    const std::size_t pixel = std::size_t(row) * std::size_t(facts.width) + std::size_t(column);
    return picture_.values[pixel * std::size_t(facts.channels)] < depth;
}

/// Of the four pixels around the place, by how near they are.
double ShadowMap::hiddenAround(const Place &place, double depth) const {
    const double x = place.x - 0.5, y = place.y - 0.5;
    const double left = std::floor(x), top = std::floor(y), right = x - left, below = y - top;
    const int column = int(left), row = int(top);
    const auto at = [&](int dx, int dy) {
        return double(isHiddenAt(column + dx, row + dy, depth));
    };
    return (at(0, 0) * (1 - right) + at(1, 0) * right) * (1 - below) +
           (at(0, 1) * (1 - right) + at(1, 1) * right) * below;
}

float ShadowMap::hidden(const PointReach &point, float sBlur, float tBlur, float bias,
                        int samples) const {
    const double depth = placed(*picture_.facts.cameraFromWorld, point.P)[2];
    const Place centre = placeOf(point.P);
    const double width = picture_.facts.width, height = picture_.facts.height;
    const bool isSeen = std::isfinite(centre.x) && std::isfinite(centre.y) && centre.x > -width &&
                        centre.x < 2 * width && centre.y > -height && centre.y < 2 * height;
    if (!isSeen || !std::isfinite(depth) || (perspective_ && !(depth > 0)))
        return 0;
    const Place alongX = placeOf(point.P + point.x), alongY = placeOf(point.P + point.y);
    const auto extent = [](double a, double b, double blur, double limit) {
        const double all = sizeOf(a, b) + std::max(0.0, blur);
        return std::isfinite(all) ? std::min(all, limit) : limit;
    };
    const double wide = extent(alongX.x - centre.x, alongY.x - centre.x, sBlur * width, width);
    const double high = extent(alongX.y - centre.y, alongY.y - centre.y, tBlur * height, height);
    const double pixel = unitsAcross_ * (perspective_ ? depth : 1);
    const double threshold =
        depth - (bias >= 0 ? double(bias) : pixel * (1 + std::max(wide, high) / 2));
    const int across = std::clamp(int(std::lround(std::sqrt(double(samples)))), 1, 32);
    double sum = 0;
    for (int row = 0; row < across; ++row)
        for (int column = 0; column < across; ++column)
            sum += hiddenAround({centre.x + ((column + 0.5) / across - 0.5) * wide,
                                 centre.y + ((row + 0.5) / across - 0.5) * high},
                                threshold);
    return float(sum / (across * across));
}

} // namespace candela

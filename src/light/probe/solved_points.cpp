// SPDX-License-Identifier: Apache-2.0
#include "light/probe/solved_points.h"

#include <cmath>

namespace candela {

namespace {

/// Sensors that are tilted against their surface by more take other light: 0.25 degrees.
constexpr float leastCosine = 1 - 1e-5f;
/// A sensor that stands farther off its point, in shares of the scene's diagonal, is not on it.
constexpr float mostOffset = 1e-3f;

float diagonalOf(const Scene &scene) {
    const Box3 &bound = scene.bound();
    return length(bound.high - bound.low);
}

/// A ray back from where the sensor stands to its point, and as far beyond. `tMax` is 0 where that
/// is too far for a sensor that lies on something.
void aimBack(const PlacedPoint &point, float most, int at, RayBatch &rays) {
    const float offset = length(point.origin - point.P);
    for (int c = 0; c < 3; ++c) {
        rays.origin[c][at] = point.origin[c];
        rays.direction[c][at] = -point.aim[c];
    }
    rays.tMax[at] = offset < most ? 2 * offset : 0.0f;
}

} // namespace

SolvedPoints::SolvedPoints(const Scene &scene, const radiosity::Solution &solution, bool direct,
                           int most)
    : scene_(scene), solution_(solution), direct_(direct), rays_(most), hits_(most),
      bins_(scene, most), vertices_(most), light_(2 * colorSamples, most) {}

void SolvedPoints::lookUp(std::span<const PlacedPoint> points) {
    found_.assign(points.size(), std::nullopt);
    const float most = mostOffset * diagonalOf(scene_);
    rays_.count = int(points.size());
    for (int i = 0; i < rays_.count; ++i) {
        rays_.time[i] = scene_.options().camera.shutterOpen;
        aimBack(points[std::size_t(i)], most, i, rays_);
    }
    scene_.intersect(rays_, hits_, Coherence::Secondary);
    bins_.sort(rays_.count, hits_);
    for (int bin = 0; bin < bins_.count(); ++bin)
        if (bin != scene_.escapedBin() && !bins_.rays(bin).empty())
            takeFrom(points, scene_.codeOfBin(bin), bins_.rays(bin));
}

/// What the solution says where those rays have met surfaces of one code.
void SolvedPoints::takeFrom(std::span<const PlacedPoint> points, int code,
                            std::span<const int> rays) {
    vertices_.meet(scene_, code, rays_, hits_, rays.data(), int(rays.size()));
    radiosity::Solution::Answer answer;
    for (std::size_t c = 0; c < colorSamples; ++c) {
        answer.indirect[c] = light_[int(c)];
        if (direct_)
            answer.direct[c] = light_[colorSamples + int(c)];
    }
    solution_.irradiance(vertices_, answer);
    const ConstVec3Planes facing = vertices_.facingPlanes();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Vec3 normal{facing[0][i], facing[1][i], facing[2][i]};
        const std::size_t point = std::size_t(rays[i]);
        if (!(dot(normal, points[point].aim) >= leastCosine))
            continue;
        Color irradiance;
        for (int c = 0; c < colorSamples; ++c)
            irradiance[c] = light_[c][i] + (direct_ ? light_[colorSamples + c][i] : 0);
        found_[point] = irradiance;
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/rays/sealed_triangles.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// The tips of needles would move far: no corner moves by more than this many margins.
constexpr float farthest = 8;

float largestCoordinate(const std::vector<Vec3> &positions) {
    float largest = 0;
    for (Vec3 p : positions)
        largest = std::max({largest, std::fabs(p.x), std::fabs(p.y), std::fabs(p.z)});
    return largest;
}

/// Enlarging a triangle about its incentre moves all three edges by the same distance.
void grow(std::array<Vec3, 3> &corner, float margin) {
    Vec3 toB = corner[1] - corner[0], toC = corner[2] - corner[0];
    float a = length(corner[2] - corner[1]), b = length(toC), c = length(toB);
    float twiceArea = length(cross(toB, toC)), perimeter = a + b + c;
    if (!(twiceArea > 0))
        return;
    Vec3 centre = (toB * b + toC * c) * (1 / perimeter); // From corner 0.
    float enlargement = margin * perimeter / twiceArea;
    const Vec3 fromCentre[3] = {-centre, toB - centre, toC - centre};
    for (int k = 0; k < 3; ++k) {
        float distance = length(fromCentre[k]);
        float most = distance > 0 ? farthest * margin / distance : 0;
        corner[k] = corner[k] + fromCentre[k] * std::min(enlargement, most);
    }
}

} // namespace

void sealTriangles(const std::vector<Vec3> &positions,
                   const std::vector<std::array<std::uint32_t, 3>> &triangles, Vec3 *corners) {
    const float margin = sealShare * largestCoordinate(positions);
    for (const auto &triangle : triangles) {
        std::array<Vec3, 3> corner{positions[triangle[0]], positions[triangle[1]],
                                   positions[triangle[2]]};
        grow(corner, margin);
        corners = std::copy(corner.begin(), corner.end(), corners);
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Triangles of curves, for ribbons and where rays cannot meet tubes as they are.
#include "world/geometry/curves_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// Derivatives are taken at so many places of a segment, and what lies between them is allowed for.
constexpr int places = 16;
constexpr double allowance = 1.3;

constexpr double roundingError = 2e-6;

/// Corners stand so much farther from the axis than the tube does that the prism is as wide as it
/// on the mean of all sides: by Cauchy, as long around. An odd number keeps near that from each.
double cornerScale(int around) {
    const double half = std::numbers::pi / around;
    return half / std::sin(half);
}

} // namespace

const DerivativeBounds &CurvesSurface::steepest() const {
    std::call_once(bounded_, [this] {
        DerivativeBounds &all = steepest_;
        all.skew = true;
        forSegments([&](std::uint32_t i, const CurveSegment &segment) {
            for (float u : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
                SectionPoint last = pointOn(segment, i, u, 0);
                for (int place = 1; place <= places; ++place) {
                    const SectionPoint point = pointOn(segment, i, u, float(place) / places);
                    auto enlarge = [](double &bound, double value) {
                        bound = std::max(bound, allowance * value);
                    };
                    enlarge(all.du, length(point.dPdu)), enlarge(all.dv, length(point.dPdv));
                    enlarge(all.duv, places * length(point.dPdu - last.dPdu));
                    enlarge(all.dvv, places * length(point.dPdv - last.dPdv));
                    last = point;
                }
            }
        });
        // Around circles; ribbons are straight across.
        all.duu = normal_ ? 0 : 2 * std::numbers::pi * all.du;
    });
    return steepest_;
}

DiceCounts CurvesSurface::countsAt(const DiceRate &rate) const {
    const double cells = std::max(1.0, maximalCells / layout_.segments());
    DiceCounts counts = chooseCounts(steepest(), rate, {normal_ ? 1 : 5, 1}, std::max(cells, 5.0));
    if (!normal_)
        counts.u |= 1;
    return counts;
}

double CurvesSurface::triangleCount(const DiceRate &rate) const {
    const DiceCounts counts = countsAt(rate);
    return 2.0 * layout_.segments() * counts.u * counts.v;
}

DicedMesh CurvesSurface::dice(const DiceRate &rate) const {
    const DiceCounts counts = countsAt(rate);
    const std::uint32_t row = std::uint32_t(counts.u + 1);
    const float scale = normal_ ? 1 : float(cornerScale(counts.u));
    DicedMesh mesh;
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        const CurveSegment segment = segmentOf(i, 0);
        const auto first = std::uint32_t(mesh.positions.size());
        for (int v = 0; v <= counts.v; ++v)
            for (int u = 0; u <= counts.u; ++u) {
                const float across = float(u) / counts.u, along = float(v) / counts.v;
                // The seam is one line.
                const float met = normal_ || u < counts.u ? across : 0;
                const Vec3 axis = segment.at(along);
                mesh.positions.push_back(axis + (pointOn(segment, i, met, along).P - axis) * scale);
                mesh.vertexUv.push_back({across, along});
            }
        for (std::uint32_t v = 0; v < std::uint32_t(counts.v); ++v)
            for (std::uint32_t u = 0; u < std::uint32_t(counts.u); ++u) {
                const std::uint32_t corner = first + v * row + u;
                mesh.triangles.push_back({corner, corner + 1, corner + row});
                mesh.triangles.push_back({corner + 1, corner + row + 1, corner + row});
            }
        mesh.pieces.insert(mesh.pieces.end(), 2 * std::size_t(counts.u) * counts.v, i);
    }
    const Vec3 extent = bound_.extent();
    const double radius = steepest().du / (2 * std::numbers::pi);
    mesh.chordError = float(cellError(steepest(), counts) + (scale - 1) * radius +
                            roundingError * std::max({extent.x, extent.y, extent.z}));
    return mesh;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/moved_surface.h"

#include "world/geometry/slopes_between.h"

#include <algorithm>

namespace candela {

void MovedSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    SurfaceAnswer unchanged = answer, changed;
    changed.N = answer.N;
    unchanged.N = unchanged.dNdu = unchanged.dNdv = {};
    std::vector<float> own;
    if (displacement_->movesPoints()) {
        unchanged.P = unchanged.Ng = unchanged.dPdu = unchanged.dPdv = {};
        changed.P = answer.P, changed.dPdu = answer.dPdu, changed.dPdv = answer.dPdv;
        if (answer.Ng.x) {
            own.resize(6 * std::size_t(query.count));
            for (int k : {0, 1}) {
                Vec3Planes &slope = k == 0 ? changed.dPdu : changed.dPdv;
                float *x = own.data() + 3 * std::size_t(k) * query.count;
                if (!slope.x)
                    slope = {x, x + query.count, x + 2 * std::size_t(query.count)};
            }
        }
        // Where slopes are not known they are those of the surface behind.
        unchanged.dPdu = changed.dPdu, unchanged.dPdv = changed.dPdv;
    }
    behind().evaluate(query, unchanged);
    if (changed.P.x || changed.N.x || changed.dPdu.x || changed.dPdv.x)
        displacement_->displace(query, changed);
    for (int k = 0; displacement_->movesPoints() && answer.Ng.x && k < query.count; ++k)
        answer.Ng.set(k, cross(changed.dPdu.get(k), changed.dPdv.get(k)));
    if (answer.dNdu.x || answer.dNdv.x)
        evaluateSlopes(query, answer);
}

/// Differences over the width of a sample, within the parameters' range.
void MovedSurface::evaluateSlopes(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    const int n = query.count;
    std::vector<float> own(25 * std::size_t(n));
    auto plane = [&](int k) { return own.data() + std::size_t(k) * n; };
    auto planes = [&](int k) { return Vec3Planes{plane(k), plane(k + 1), plane(k + 2)}; };
    float *stepA = plane(0), *stepB = plane(1);
    Neighbours points{query, {n, query.piece, stepA, query.v}, {n, query.piece, query.u, stepB}};
    constexpr float probe = 1e-3f;
    auto step = [&](float from, float by) { return from < 0.5f ? from + by : from - by; };
    for (int k = 0; k < n; ++k)
        stepA[k] = step(query.u[k], probe), stepB[k] = step(query.v[k], probe);
    const Vec3Planes P = planes(2), PA = planes(5), PB = planes(8);
    for (auto [where, to] : {std::pair{&points.here, P}, std::pair{&points.besideA, PA},
                             std::pair{&points.besideB, PB}}) {
        SurfaceAnswer position;
        position.P = to;
        behind().evaluate(*where, position);
    }
    for (int k = 0; k < n; ++k) {
        const float width = displacement_->width(P.get(k));
        auto sized = [&](Vec3 beside) {
            const float far = length(beside - P.get(k));
            return far > 0 ? std::clamp(probe * width / far, 1e-5f, 0.1f) : probe;
        };
        stepA[k] = step(query.u[k], sized(PA.get(k)));
        stepB[k] = step(query.v[k], sized(PB.get(k)));
    }
    const Vec3Planes normals[3] = {planes(11), planes(14), planes(17)};
    const SurfaceQuery *where[3] = {&points.here, &points.besideA, &points.besideB};
    for (int side = 0; side < 3; ++side) {
        SurfaceAnswer normal;
        normal.N = normals[side];
        displacement_->displace(*where[side], normal);
        for (int k = 0; k < n; ++k)
            normals[side].set(k, normalize(normals[side].get(k)));
    }
    const Vec3Planes spareU = planes(20); // Of dNdu alone, or of dNdv, nobody asks as a rule.
    slopesBetween(behind(), points, normals, answer.dNdu.x ? answer.dNdu : spareU,
                  answer.dNdv.x ? answer.dNdv : spareU);
}

} // namespace candela

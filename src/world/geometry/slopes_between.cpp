// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/slopes_between.h"

#include <cmath>
#include <vector>

namespace candela {

namespace {

/// How far u and v change along a step, which dPdu and dPdv make of it.
struct Change {
    double u = 0, v = 0;
};

/// The normal equations of step = u dPdu + v dPdv.
Change changeAlong(Vec3 step, Vec3 dPdu, Vec3 dPdv) {
    const double uu = dot(dPdu, dPdu), uv = dot(dPdu, dPdv), vv = dot(dPdv, dPdv);
    const double su = dot(step, dPdu), sv = dot(step, dPdv);
    const double determinant = uu * vv - uv * uv;
    if (!(determinant > 1e-12 * uu * vv))
        return {};
    return {(su * vv - sv * uv) / determinant, (sv * uu - su * uv) / determinant};
}

} // namespace

void slopesBetween(const Surface &surface, const Neighbours &points, const Vec3Planes values[3],
                   Vec3Planes byU, Vec3Planes byV) {
    const int count = points.here.count;
    std::vector<float> own(15 * std::size_t(count));
    auto planes = [&](int first) {
        float *x = own.data() + std::size_t(first) * count;
        return Vec3Planes{x, x + count, x + 2 * std::size_t(count)};
    };
    const Vec3Planes P = planes(0), PA = planes(3), PB = planes(6);
    const Vec3Planes dPdu = planes(9), dPdv = planes(12);
    SurfaceAnswer here, besideA, besideB;
    here.P = P, here.dPdu = dPdu, here.dPdv = dPdv, besideA.P = PA, besideB.P = PB;
    surface.evaluate(points.here, here);
    surface.evaluate(points.besideA, besideA);
    surface.evaluate(points.besideB, besideB);
    for (int k = 0; k < count; ++k) {
        const Change a = changeAlong(PA.get(k) - P.get(k), dPdu.get(k), dPdv.get(k));
        const Change b = changeAlong(PB.get(k) - P.get(k), dPdu.get(k), dPdv.get(k));
        const Vec3 alongA = values[1].get(k) - values[0].get(k);
        const Vec3 alongB = values[2].get(k) - values[0].get(k);
        const double determinant = a.u * b.v - a.v * b.u;
        const double size = std::hypot(a.u, a.v) * std::hypot(b.u, b.v);
        const bool tells = std::abs(determinant) > 1e-9 * size;
        const double scale = tells ? 1 / determinant : 0;
        byU.set(k, alongA * float(b.v * scale) - alongB * float(a.v * scale));
        byV.set(k, alongB * float(a.u * scale) - alongA * float(b.u * scale));
    }
}

} // namespace candela

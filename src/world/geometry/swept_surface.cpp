// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/swept_surface.h"

#include "world/geometry/swept_dicing.h"

#include <numbers>

namespace candela {

/// Rounding of evaluate() in floats, relative to the extent: mostly that of the angles.
static constexpr double roundingError = 2e-6;

template <class Profile>
SweptSurface<Profile>::SweptSurface(Profile profile, double thetaSweep, GridVariables variables)
    : profile_(profile), limits_(profile.limits()), thetaSweep_(thetaSweep),
      variables_(std::move(variables)) {}

template <class Profile> Box3 SweptSurface<Profile>::bound() const {
    using std::numbers::pi;
    double low[2] = {1e300, 1e300}, high[2] = {-1e300, -1e300};
    for (auto [x, y] : limits_.extremes) {
        auto add = [&](double angle) {
            double turned[2] = {x * std::cos(angle) - y * std::sin(angle),
                                x * std::sin(angle) + y * std::cos(angle)};
            for (int axis = 0; axis < 2; ++axis) {
                low[axis] = std::min(low[axis], turned[axis]);
                high[axis] = std::max(high[axis], turned[axis]);
            }
        };
        add(0), add(thetaSweep_);
        // Where the circle crosses the axes within the sweep.
        double from = std::min(0.0, thetaSweep_), to = std::max(0.0, thetaSweep_);
        double phase = std::atan2(y, x);
        for (double n = std::ceil((from + phase) / (pi / 2)); n * pi / 2 - phase < to; ++n)
            add(n * pi / 2 - phase);
    }
    float margin = float(limits_.extent() * roundingError);
    return {{float(low[0]) - margin, float(low[1]) - margin, float(limits_.zLow) - margin},
            {float(high[0]) + margin, float(high[1]) + margin, float(limits_.zHigh) + margin}};
}

template <class Profile> float SweptSurface<Profile>::area() const {
    return float(limits_.areaPerRadian * std::abs(thetaSweep_));
}

template <class Profile> DicedMesh SweptSurface<Profile>::dice(const DiceRate &rate) const {
    DerivativeBounds bounds = limits_.derivatives;
    double sweep = std::abs(thetaSweep_);
    bounds.du *= sweep, bounds.duu *= sweep * sweep, bounds.duv *= sweep;
    // Never so coarse that a closed shape loses its inside.
    DiceCounts least{int(std::ceil(sweep * 3 / std::numbers::pi)), limits_.leastRows};
    DiceCounts counts = chooseCounts(bounds, rate, least, maximalCells);
    SweptGrid grid{counts,
                   std::abs(sweep - 2 * std::numbers::pi) < 1e-6,
                   limits_.closed,
                   profile_.at(0).position,
                   profile_.at(1).position,
                   float(limits_.derivatives.du) * leastArmFraction};
    DicedMesh mesh = diceSwept(grid, *this);
    mesh.chordError = float(cellError(bounds, counts) + roundingError * limits_.extent());
    return mesh;
}

template <class Profile>
inline void SweptSurface<Profile>::evaluateOne(int k, float u, float t,
                                               const SurfaceAnswer &answer) const {
    ProfilePoint p = profile_.at(t);
    float sweep = float(thetaSweep_), theta = sweep * u;
    float c = std::cos(theta), s = std::sin(theta);
    auto turn = [c, s](float x, float y, float z) { return Vec3{x * c - y * s, x * s + y * c, z}; };
    if (answer.P.x)
        answer.P.set(k, turn(p.position.x, p.position.y, p.position.z));
    if (answer.dPdu.x)
        answer.dPdu.set(k, turn(-sweep * p.armY, sweep * p.armX, 0));
    if (answer.dPdv.x)
        answer.dPdv.set(k, turn(p.dv.x, p.dv.y, p.dv.z));
    if (answer.Ng.x || answer.N.x) {
        float outX = sweep * p.armX * p.dv.z, outY = sweep * p.armY * p.dv.z;
        float up = -sweep * (p.armX * p.dv.x + p.armY * p.dv.y);
        // A flat profile at its closest to the axis, where the surface turns back over itself.
        if (outX == 0 && outY == 0 && up == 0)
            up = sweep * profile_.leastArm * length(p.dv);
        Vec3 normal = turn(outX, outY, up);
        if (answer.Ng.x)
            answer.Ng.set(k, normal);
        if (answer.N.x)
            answer.N.set(k, normal);
    }
    if (answer.u)
        answer.u[k] = u;
    if (answer.v)
        answer.v[k] = p.v;
}

template <class Profile>
void SweptSurface<Profile>::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    for (int k = 0; k < query.count; ++k)
        evaluateOne(k, query.u[k], query.v[k], answer);
    if (!answer.N.x)
        return;
    std::array<float, PatchPoints::capacity> v;
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        int count = std::min(query.count - start, PatchPoints::capacity);
        for (int k = 0; k < count; ++k)
            v[k] = profile_.riV(query.v[start + k]);
        Vec3Planes N{answer.N.x + start, answer.N.y + start, answer.N.z + start};
        variables_.overrideNormals(count, query.u + start, v.data(), N);
    }
}

template <class Profile>
void SweptSurface<Profile>::evaluateVariable(int index, const SurfaceQuery &query,
                                             float *const *value, float *const *valueDu,
                                             float *const *valueDv) const {
    std::array<float, PatchPoints::capacity> v;
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        int count = std::min(query.count - start, PatchPoints::capacity);
        for (int k = 0; k < count; ++k)
            v[k] = profile_.riV(query.v[start + k]);
        variables_.evaluate(index, start, count, query.u + start, v.data(), value, valueDu,
                            valueDv);
    }
}

template class SweptSurface<StraightProfile>;
template class SweptSurface<CircularProfile>;
template class SweptSurface<ParabolicProfile>;

} // namespace candela

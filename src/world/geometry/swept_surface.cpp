// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/swept_surface.h"

#include <numbers>

namespace candela {

/// Rounding of evaluate() in floats, relative to the extent: mostly that of the angles.
static constexpr double roundingError = 2e-6;

static bool isFullTurn(double sweep) {
    return std::abs(std::abs(sweep) - 2 * std::numbers::pi) < 1e-6;
}

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

template <class Profile> bool SweptSurface<Profile>::isPole(double t) const {
    Vec3 end = profile_.onGrid(t);
    return std::hypot(end.x, end.y) <= poleRadius();
}

template <class Profile> SweptCounts SweptSurface<Profile>::countsAt(const DiceRate &rate) const {
    return chooseSweptCounts(limits_, thetaSweep_, isPole(0) + isPole(1), rate);
}

template <class Profile> double SweptSurface<Profile>::triangleCount(const DiceRate &rate) const {
    return countsAt(rate).triangles();
}

template <class Profile> DicedMesh SweptSurface<Profile>::dice(const DiceRate &rate) const {
    SweptCounts counts = countsAt(rate);
    std::vector<Vec3> row;
    for (int i = 0; i <= counts.rows; ++i)
        row.push_back(profile_.onGrid(double(i) / counts.rows));
    DicedMesh mesh = diceSwept({counts, thetaSweep_, limits_.closed, row, poleRadius()});
    mesh.chordError = float(sweptError(limits_, counts) + roundingError * limits_.extent());
    return mesh;
}

template <class Profile> bool SweptSurface<Profile>::isRound() const {
    if constexpr (std::is_same_v<Profile, CircularProfile>)
        return profile_.isWholeMeridian() && isFullTurn(thetaSweep_);
    return false;
}

template <class Profile> RoundElements SweptSurface<Profile>::roundElements() const {
    if constexpr (std::is_same_v<Profile, CircularProfile>)
        return {{{0, 0, 0, std::abs(profile_.minor)}}, {}};
    return {};
}

template <class Profile>
void SweptSurface<Profile>::nameRound(int count, const Vec3Planes &P, const float *,
                                      std::uint32_t *, float *u, float *v) const {
    if constexpr (std::is_same_v<Profile, CircularProfile>) {
        // A negative radius puts u = 0 and v = 0 on the other sides.
        float side = std::copysign(1.0f, profile_.minor);
        float perTurn = 1 / float(thetaSweep_), perSweep = 1 / profile_.phiSweep;
        for (int k = 0; k < count; ++k) {
            float x = side * P.x[k], y = side * P.y[k], z = side * P.z[k];
            float turns = std::atan2(y, x) * perTurn;
            float phi = std::atan2(z, std::sqrt(x * x + y * y));
            u[k] = std::min(turns < 0 ? turns + 1 : turns, 1.0f);
            v[k] = std::clamp((phi - profile_.phiStart) * perSweep, 0.0f, 1.0f);
        }
    }
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
    if (answer.areaScale) {
        Vec3 along = profile_.byT(t);
        float x = p.position.x, y = p.position.y;
        float radial = x * along.x + y * along.y, upright = along.z * std::sqrt(x * x + y * y);
        answer.areaScale[k] = std::abs(sweep) * std::sqrt(radial * radial + upright * upright);
    }
    if (answer.Ng.x || answer.N.x || answer.dNdu.x || answer.dNdv.x || answer.dNgdu.x ||
        answer.dNgdv.x) {
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
        float largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
        Vec3 unit = normalize(normal * (1 / largest));
        for (const Vec3Planes &byU : {answer.dNdu, answer.dNgdu})
            if (byU.x)
                byU.set(k, Vec3{-unit.y, unit.x, 0} * sweep);
        for (const Vec3Planes &byV : {answer.dNdv, answer.dNgdv})
            if (byV.x) {
                Vec3 bend = profile_.normalDv(t) * std::copysign(1.0f, sweep);
                byV.set(k, turn(bend.x, bend.y, bend.z));
            }
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
    if (!answer.N.x && !answer.dNdu.x && !answer.dNdv.x)
        return;
    std::array<float, PatchPoints::capacity> v;
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        int count = std::min(query.count - start, PatchPoints::capacity);
        for (int k = 0; k < count; ++k)
            v[k] = profile_.riV(query.v[start + k]);
        variables_.overrideNormals(count, query.u + start, v.data(), from(answer.N, start),
                                   from(answer.dNdu, start), from(answer.dNdv, start));
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

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/profile.h"

#include <algorithm>
#include <numbers>
#include <vector>

namespace candela {

using std::numbers::pi;

Turn turnBy(double angle) {
    Turn turn{std::cos(angle), std::sin(angle)};
    constexpr double rounding = 1e-14; // Of some turns in radians.
    if (std::abs(turn.cosine) < rounding)
        return {0, std::copysign(1.0, turn.sine)};
    if (std::abs(turn.sine) < rounding)
        return {std::copysign(1.0, turn.cosine), 0};
    return turn;
}

StraightProfile::StraightProfile(Vec3 from, Vec3 to) : start(from), along(to - from), end(to) {
    leastArm = leastArmFraction * std::max(std::hypot(from.x, from.y), std::hypot(to.x, to.y));
}

Vec3 StraightProfile::onGrid(double t) const {
    if (t <= 0 || t >= 1)
        return t <= 0 ? start : end;
    auto mix = [t](float from, float to) { return float(from + (double(to) - from) * t); };
    return {mix(start.x, end.x), mix(start.y, end.y), mix(start.z, end.z)};
}

/// Integral over [0,1] of the square root of a (x + m)^2 + a n^2.
static double integralOfRoot(double a, double m, double nSquared) {
    auto primitive = [&](double x) {
        double root = std::sqrt(x * x + nSquared);
        double tail = nSquared > 0 ? nSquared * std::asinh(x / std::sqrt(nSquared)) : 0;
        return (x * root + tail) / 2;
    };
    return std::sqrt(a) * (primitive(1 + m) - primitive(m));
}

/// |dPdu x dPdv|^2 per radian of a swept segment p + v d is dz^2 |p.xy + v d.xy|^2 +
/// (p.xy . d.xy + v |d.xy|^2)^2: a parabola in v with its lowest point at -(p.d)/|d|^2.
static double straightArea(Vec3 p, Vec3 d) {
    double dd = double(d.x) * d.x + double(d.y) * d.y, pd = double(p.x) * d.x + double(p.y) * d.y;
    double pp = double(p.x) * p.x + double(p.y) * p.y, dz2 = double(d.z) * d.z;
    if (dd <= 1e-14 * pp)
        return std::sqrt(dz2 * pp + pd * pd);
    double closest = std::max(0.0, pp - pd * pd / dd); // Squared distance of the line to the axis.
    return integralOfRoot(dd * (dz2 + dd), pd / dd, dz2 * closest / (dd * (dz2 + dd)));
}

ProfileLimits StraightProfile::limits() const {
    Vec3 end = start + along;
    double radius = std::max(std::hypot(start.x, start.y), std::hypot(end.x, end.y));
    double radial = std::hypot(double(along.x), double(along.y));
    ProfileLimits limits;
    limits.derivatives = {radius, std::hypot(radial, double(along.z)),   radius, radial,
                          0,      start.x * along.y != start.y * along.x};
    limits.extremes = {{{start.x, start.y}, {end.x, end.y}}};
    limits.zLow = std::min(start.z, end.z);
    limits.zHigh = std::max(start.z, end.z);
    limits.areaPerRadian = straightArea(start, along);
    return limits;
}

CircularProfile CircularProfile::sphere(float radius, double phiFrom, double phiTo) {
    return {0, radius, float(phiFrom), float(phiTo - phiFrom), 0, phiFrom, phiTo};
}

CircularProfile CircularProfile::torus(float major, float minor, double phiFrom, double phiTo) {
    return {major, minor, float(phiFrom), float(phiTo - phiFrom), -1, phiFrom, phiTo};
}

Vec3 CircularProfile::onGrid(double t) const {
    double phi = t >= 1 ? phiTo : phiFrom + (phiTo - phiFrom) * t;
    Turn turn = turnBy(phi);
    return {float(major + minor * std::max(turn.cosine, double(leastCosine))), 0,
            float(minor * turn.sine)};
}

bool CircularProfile::isWholeMeridian() const {
    return leastCosine == 0 && phiFrom <= -pi / 2 && phiTo >= pi / 2;
}

/// Lowest and highest of offset + factor * f(phi), f with its crests at `crest` + n pi.
static std::array<double, 2> waveRange(double from, double to, double crest, double offset,
                                       double factor) {
    if (from > to)
        std::swap(from, to);
    std::array<double, 2> range{1e300, -1e300};
    auto add = [&](double phi) {
        double value = offset + factor * std::cos(phi - crest);
        range = {std::min(range[0], value), std::max(range[1], value)};
    };
    add(from), add(to);
    for (double n = std::ceil((from - crest) / pi); crest + n * pi < to && n < 1e3; ++n)
        add(crest + n * pi);
    return range;
}

/// Integral of |major + minor cos(phi)|, in pieces between the zeros of the integrand.
static double circularArea(double major, double minor, double from, double to) {
    if (from > to)
        std::swap(from, to);
    std::vector<double> cuts{from, to};
    if (std::abs(major) < std::abs(minor)) {
        double zero = std::acos(-major / minor);
        for (double turn = std::floor(from / (2 * pi)) - 1; turn * 2 * pi <= to + 2 * pi; ++turn)
            for (double cut : {turn * 2 * pi + zero, turn * 2 * pi - zero})
                if (cut > from && cut < to)
                    cuts.push_back(cut);
    }
    std::ranges::sort(cuts);
    double area = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
        area += std::abs(major * (cuts[i] - cuts[i - 1]) +
                         minor * (std::sin(cuts[i]) - std::sin(cuts[i - 1])));
    return area * std::abs(minor);
}

ProfileLimits CircularProfile::limits() const {
    double from = phiStart, to = double(phiStart) + phiSweep;
    auto x = waveRange(from, to, 0, major, minor);
    if (leastCosine == 0)
        (minor > 0 ? x[0] : x[1]) = minor > 0 ? std::max(x[0], 0.0) : std::min(x[1], 0.0);
    auto z = waveRange(from, to, pi / 2, 0, minor);
    double radius = std::max(std::abs(x[0]), std::abs(x[1]));
    double speed = std::abs(double(minor) * phiSweep);
    ProfileLimits limits;
    limits.derivatives = {radius, speed, radius, speed, speed * std::abs(phiSweep), false};
    limits.extremes = {{{x[0], 0}, {x[1], 0}}};
    limits.zLow = z[0];
    limits.zHigh = z[1];
    limits.areaPerRadian = circularArea(major, minor, from, to);
    limits.closed = std::abs(std::abs(phiSweep) - 2 * pi) < 1e-6;
    limits.leastRows = std::max(2, int(std::ceil(std::abs(phiSweep) * 3 / pi)));
    return limits;
}

ParabolicProfile::ParabolicProfile(float maximalRadius, float zFrom, float zTo)
    : rMax(maximalRadius), zMin(zFrom), zMax(zTo), zSweep(zTo - zFrom),
      radiusStart(maximalRadius * std::sqrt(zFrom / zTo)),
      radiusSweep(maximalRadius - radiusStart) {
    leastArm = leastArmFraction * std::max(std::abs(radiusStart), std::abs(rMax));
}

Vec3 ParabolicProfile::onGrid(double t) const {
    double apart = std::sqrt(double(zMin) / zMax);
    if (t <= 0 || t >= 1)
        return t <= 0 ? Vec3{float(rMax * apart), 0, zMin} : Vec3{rMax, 0, zMax};
    double ratio = apart + (1 - apart) * t;
    return {float(rMax * ratio), 0, float(zMax * ratio * ratio)};
}

ProfileLimits ParabolicProfile::limits() const {
    double end = double(radiusStart) + radiusSweep;
    double radius = std::max(std::abs(double(radiusStart)), std::abs(end));
    double sweep = std::abs(double(radiusSweep)), bend = std::abs(zMax / (double(rMax) * rMax));
    ProfileLimits limits;
    limits.derivatives = {radius,
                          std::hypot(sweep, 2 * bend * radius * sweep),
                          radius,
                          sweep,
                          2 * bend * sweep * sweep,
                          false};
    limits.extremes = {{{radiusStart, 0}, {end, 0}}};
    limits.zLow = std::min(zMin, zMax);
    limits.zHigh = std::max(zMin, zMax);
    // r ds = sqrt(k z + k^2/4) dz with r^2 = k z.
    double k = 1 / bend;
    auto primitive = [k](double z) { return 2 / (3 * k) * std::pow(k * z + k * k / 4, 1.5); };
    limits.areaPerRadian = std::abs(primitive(std::abs(zMax)) - primitive(std::abs(zMin)));
    return limits;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_quadric.h"

#include "world/geometry/swept_surface.h"

#include <algorithm>
#include <initializer_list>
#include <numbers>

namespace candela {

static double radians(double degrees) { return degrees * std::numbers::pi / 180; }

/// Extents beyond which squares and products of lengths leave the range of floats.
static constexpr double smallestExtent = 1e-12, largestExtent = 1e12;

static bool allFinite(std::initializer_list<float> values) {
    return std::ranges::all_of(values, [](float x) { return std::isfinite(x); });
}

static SurfaceList refuse(const char *shape, const char *why, const PrimitiveRecord &record,
                          DiagnosticSink &diagnostics) {
    diagnostics.error(record.where, std::string("the ") + shape + " " + why + "; it is dropped");
    return {};
}

template <class Profile>
static SurfaceList sweep(const char *shape, Profile profile, float thetaMax,
                         const PrimitiveRecord &record, const Attributes &attributes,
                         DiagnosticSink &diagnostics) {
    ProfileLimits limits = profile.limits();
    double extent = limits.extent();
    // Negated comparisons, so that NaN is refused too.
    if (!(extent <= largestExtent))
        return refuse(shape, "is larger than can be computed with", record, diagnostics);
    double theta = std::clamp(radians(thetaMax), -2 * std::numbers::pi, 2 * std::numbers::pi);
    double area = limits.areaPerRadian * std::abs(theta);
    if (!(extent >= smallestExtent) || !(area > 1e-9 * extent * extent))
        return refuse(shape, "has no area", record, diagnostics);
    GridVariables variables(record, attributes, PatchGrid{}, nullptr, diagnostics);
    return {std::make_shared<SweptSurface<Profile>>(profile, theta, std::move(variables))};
}

SurfaceList makeQuadric(const SphereRecord &s, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    if (!allFinite({s.radius, s.zMin, s.zMax, s.thetaMax}) || s.radius == 0)
        return refuse("sphere", "has a radius of zero or a value that is not finite", record,
                      diagnostics);
    auto angle = [&](float z) { return std::asin(std::clamp(double(z) / s.radius, -1.0, 1.0)); };
    // RI's conditions: zMin <= -radius is the whole lower half, also where the radius is negative.
    double from = s.zMin > -s.radius ? angle(s.zMin) : -std::numbers::pi / 2;
    double to = s.zMax < s.radius ? angle(s.zMax) : std::numbers::pi / 2;
    return sweep("sphere", CircularProfile::sphere(s.radius, from, to), s.thetaMax, record,
                 attributes, diagnostics);
}

static SurfaceList sweepSegment(const char *shape, Vec3 from, Vec3 to, float thetaMax,
                                const PrimitiveRecord &record, const Attributes &attributes,
                                DiagnosticSink &diagnostics) {
    if (!isFinite(from) || !isFinite(to) || !std::isfinite(thetaMax))
        return refuse(shape, "has a value that is not finite", record, diagnostics);
    return sweep(shape, StraightProfile(from, to), thetaMax, record, attributes, diagnostics);
}

SurfaceList makeQuadric(const ConeRecord &c, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    return sweepSegment("cone", {c.radius, 0, 0}, {0, 0, c.height}, c.thetaMax, record, attributes,
                        diagnostics);
}

SurfaceList makeQuadric(const CylinderRecord &c, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    return sweepSegment("cylinder", {c.radius, 0, c.zMin}, {c.radius, 0, c.zMax}, c.thetaMax,
                        record, attributes, diagnostics);
}

SurfaceList makeQuadric(const HyperboloidRecord &h, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    return sweepSegment("hyperboloid", h.point1, h.point2, h.thetaMax, record, attributes,
                        diagnostics);
}

SurfaceList makeQuadric(const DiskRecord &d, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    return sweepSegment("disk", {d.radius, 0, d.height}, {0, 0, d.height}, d.thetaMax, record,
                        attributes, diagnostics);
}

SurfaceList makeQuadric(const ParaboloidRecord &p, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    if (!allFinite({p.rMax, p.zMin, p.zMax, p.thetaMax}) || p.rMax == 0 || p.zMax == 0)
        return refuse("paraboloid", "has rmax or zmax of zero or a value that is not finite",
                      record, diagnostics);
    if (p.zMin / p.zMax < 0)
        return refuse("paraboloid", "has zmin and zmax on two sides of its apex", record,
                      diagnostics);
    if (p.zMin == p.zMax)
        return refuse("paraboloid", "has no area", record, diagnostics);
    return sweep("paraboloid", ParabolicProfile(p.rMax, p.zMin, p.zMax), p.thetaMax, record,
                 attributes, diagnostics);
}

SurfaceList makeQuadric(const TorusRecord &t, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    if (!allFinite({t.majorRadius, t.minorRadius, t.phiMin, t.phiMax, t.thetaMax}))
        return refuse("torus", "has a value that is not finite", record, diagnostics);
    if (std::abs(t.phiMax - t.phiMin) > 360.01f || std::abs(t.phiMin) > 3600)
        return refuse("torus", "has phimin and phimax more than a full turn apart", record,
                      diagnostics);
    return sweep(
        "torus",
        CircularProfile::torus(t.majorRadius, t.minorRadius, radians(t.phiMin), radians(t.phiMax)),
        t.thetaMax, record, attributes, diagnostics);
}

} // namespace candela

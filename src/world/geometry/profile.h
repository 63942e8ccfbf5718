// SPDX-License-Identifier: Apache-2.0
// The curves that the quadrics of RI 3.2, 5.4 sweep about the z axis: straight (cone, cylinder,
// disk, hyperboloid), circular (sphere, torus) and parabolic. Each maps the dicing parameter
// t in [0,1] to a point and to RI's v. Lengths are in object units.
//
// onGrid(t) is the profile for dicing, in double precision and rounded once: at t = 0 and 1 it is
// the very point that the record names, so that primitives which share a rim agree about it.
#pragma once

#include "foundation/base/vec3.h"
#include "world/geometry/dice_counts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

struct ProfilePoint {
    Vec3 position;
    Vec3 dv;                  ///< Derivative by RI's v.
    float armX = 0, armY = 0; ///< position.xy, but never shorter than ProfileLimits::leastArm.
    float v = 0;              ///< RI's v.
};

/// Cosine and sine of an angle in radians, exact where it is meant to be a multiple of a quarter.
struct Turn {
    double cosine = 1, sine = 0;
};
Turn turnBy(double angle);

/// What is known of a whole profile.
struct ProfileLimits {
    DerivativeBounds derivatives; ///< By t in dv and dvv; by the angle in radians in du, duu, duv.
    /// Points (x,y) whose circles contain all others of the surface between them.
    std::array<std::array<double, 2>, 2> extremes;
    double zLow = 0, zHigh = 0;
    double areaPerRadian = 0;
    bool closed = false; ///< t = 1 comes back to t = 0.
    int leastRows = 1;   ///< Dicing with fewer would lose the shape.

    double extent() const { return std::max({derivatives.du, std::abs(zLow), std::abs(zHigh)}); }
};

/// At a pole the surface stands as if it were this fraction of its radius away from the axis, so
/// that dPdu and the normal keep the directions that they have beside the pole.
inline constexpr float leastArmFraction = 1e-6f;

struct StraightProfile {
    Vec3 start, along;
    float leastArm;

    Vec3 end;

    StraightProfile(Vec3 from, Vec3 to);
    ProfileLimits limits() const;
    Vec3 onGrid(double t) const;
    float riV(float t) const { return t; }
    /// Derivative by t, and that of the unit normal (of a positive sweep) by RI's v.
    Vec3 byT(float) const { return along; }
    Vec3 normalDv(float t) const {
        ProfilePoint p = at(t);
        // r x r' is a multiple of the profile's direction, r being the normal before it has length
        // one: how the profile turns about the axis. A profile in one plane with it has none.
        double turning = double(start.x) * along.y - double(start.y) * along.x;
        Vec3 r{p.armX * along.z, p.armY * along.z, -(p.armX * along.x + p.armY * along.y)};
        float size = length(r);
        if (turning == 0 || !(size > 0))
            return {};
        return cross(along / size, r / size) * (float(turning) * along.z / size);
    }
    ProfilePoint at(float t) const {
        Vec3 p = start + along * t;
        ProfilePoint point{p, along, p.x, p.y, t};
        if (p.x * p.x + p.y * p.y < leastArm * leastArm) {
            // The direction that the profile leaves the axis in, towards its own middle.
            float scale = (t < 0.5f ? leastArm : -leastArm) / std::hypot(along.x, along.y);
            point.armX = along.x * scale;
            point.armY = along.y * scale;
        }
        return point;
    }
};

struct CircularProfile {
    float major, minor;       ///< Torus radii; major = 0 is the sphere.
    float phiStart, phiSweep; ///< Radians.
    float leastCosine;        ///< 0 on a sphere: floats beside a quarter turn give less.
    double phiFrom, phiTo;    ///< Radians, before they are rounded.
    float leastArm = leastArmFraction * (std::abs(major) + std::abs(minor));

    static CircularProfile sphere(float radius, double phiFrom, double phiTo);
    static CircularProfile torus(float major, float minor, double phiFrom, double phiTo);
    ProfileLimits limits() const;
    Vec3 onGrid(double t) const;
    bool isWholeMeridian() const; ///< A sphere's, from pole to pole.
    float riV(float t) const { return t; }
    Vec3 byT(float t) const { return at(t).dv; }
    Vec3 normalDv(float t) const {
        float phi = phiStart + phiSweep * t;
        float sine = std::sin(phi), cosine = std::max(std::cos(phi), leastCosine);
        float side = std::copysign(std::abs(phiSweep), at(t).armX * minor);
        return {-side * sine, 0, side * cosine};
    }
    ProfilePoint at(float t) const {
        float phi = phiStart + phiSweep * t;
        float sine = std::sin(phi), cosine = std::max(std::cos(phi), leastCosine);
        float x = major + minor * cosine;
        Vec3 derivative{-minor * phiSweep * sine, 0, minor * phiSweep * cosine};
        float arm = std::copysign(std::max(std::abs(x), leastArm), x);
        return {{x, 0, minor * sine}, derivative, arm, 0, t};
    }
};

/// z = zMax (r/rMax)^2. Its t runs linearly in the radius: RI's v does not, and has an infinite
/// derivative at the apex.
struct ParabolicProfile {
    float rMax, zMin, zMax, zSweep;
    float radiusStart, radiusSweep;
    float leastArm;

    ParabolicProfile(float maximalRadius, float zFrom, float zTo);
    ProfileLimits limits() const;
    Vec3 onGrid(double t) const;
    Vec3 byT(float t) const {
        float ratio = (radiusStart + radiusSweep * t) / rMax;
        return {radiusSweep, 0, 2 * zMax * ratio * radiusSweep / rMax};
    }
    Vec3 normalDv(float t) const {
        float arm = at(t).armX, slope = 2 * (zMax / rMax) * (arm / rMax);
        float root = std::sqrt(1 + slope * slope);
        float speed = std::copysign(zSweep, zMax) / (arm * root * root * root);
        return {speed, 0, speed * slope};
    }
    float riV(float t) const {
        float ratio = (radiusStart + radiusSweep * t) / rMax;
        return std::clamp((zMax * ratio * ratio - zMin) / zSweep, 0.0f, 1.0f);
    }
    ProfilePoint at(float t) const {
        float radius = radiusStart + radiusSweep * t, ratio = radius / rMax;
        float arm = std::copysign(std::max(std::abs(radius), leastArm), rMax);
        Vec3 derivative{rMax * rMax * zSweep / (2 * zMax * arm), 0, zSweep};
        return {{radius, 0, zMax * ratio * ratio}, derivative, arm, 0, riV(t)};
    }
};

} // namespace candela

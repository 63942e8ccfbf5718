// SPDX-License-Identifier: Apache-2.0
// All arithmetic is in doubles: differences of floats are exact in them.
#include "world/lights/shape_sampling.h"

#include "foundation/base/hot.h"
#include "world/lights/angles.h"
#include "world/lights/shape_arithmetic.h"

#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

/// A sphere as seen from P. `height` is 1 less the cosine of the half angle of its cone; 2 from
/// within, where the cone is the whole sphere of directions.
struct SeenSphere {
    double d2, height;
    bool outside;
    float density;
};

[[gnu::always_inline]] inline SeenSphere seen(Double3 toCentre, double radius, float far) {
    SeenSphere s;
    s.d2 = dot(toCentre, toCentre);
    double r2 = radius * radius;
    s.outside = s.d2 > r2;
    double sine2 = r2 / s.d2, cosine2 = (s.d2 - r2) / s.d2;
    s.height = s.outside ? sine2 / (1 + std::sqrt(s.outside ? cosine2 : 0.0)) : 2.0;
    const bool twoWalls = s.outside & (far > 0) & (far < 1);
    float density = rounded((twoWalls ? 0.5 : 1.0) / (2 * pi * s.height));
    bool sound = radius > 0 && s.d2 - s.d2 == 0 && r2 - r2 == 0;
    s.density = sound ? density : 0.0f;
    return s;
}

/// The unit square onto the unit disc (Shirley and Chiu 1997): cosine and sine of the azimuth, and
/// the radius, which may be negative.
[[gnu::always_inline]] inline void disc(double u, double v, double &cosine, double &sine,
                                        double &radius) {
    double a = 2 * u - 1, b = 2 * v - 1;
    bool wide = std::fabs(a) > std::fabs(b);
    radius = wide ? a : b;
    double share = (wide ? b : a) / (radius != 0 ? radius : 1.0), s, c;
    sinCosEighth(pi / 4 * share, s, c);
    cosine = wide ? c : s, sine = wide ? s : c;
}

/// The point that P sees on the sphere, on its `far` wall if it is outside, at `across` (unit, at
/// right angles to the unit vector `towards` the centre) and the share `rho2` of the cone's solid
/// angle within.
[[gnu::always_inline]] inline Double3 pointOnSphere(Double3 P, Double3 centre, double radius,
                                                    const SeenSphere &s, bool far, Double3 towards,
                                                    Double3 across, double rho, double rho2) {
    double d = std::sqrt(s.d2), r2 = radius * radius;
    double height = s.height * rho2, cosine = 1 - height;
    double sine = rho * std::sqrt(s.height * (2 - height)); // The sign of rho is part of azimuth.
    // Half the chord: d2 (sin2 of the cone - sin2), factored where it would cancel.
    double gap = s.outside ? s.d2 * s.height * (1 - rho2) * (2 - s.height * (1 + rho2))
                           : r2 - s.d2 + s.d2 * cosine * cosine;
    double chord = std::sqrt(gap > 0 ? gap : 0.0), along = d * cosine;
    // First and second root of the quadratic, each in the form that doesn't cancel.
    bool sum = s.outside ? far : along > 0;
    double whole = s.outside ? along + chord : chord - along;
    double product = s.outside ? s.d2 - r2 : r2 - s.d2;
    double t = sum ? along + chord : product / (whole > 0 ? whole : 1.0);
    // From P or from the centre, whichever is nearer: the smaller of the two errors.
    bool fromP = t < radius;
    double ofChord = far ? chord * cosine : -chord * cosine;
    double inDepth = s.outside ? ofChord - d * sine * sine : t * cosine - d;
    Double3 origin{fromP ? P.x : centre.x, fromP ? P.y : centre.y, fromP ? P.z : centre.z};
    return origin + towards * (fromP ? t * cosine : inDepth) + across * (t * sine);
}

/// d^2 / (area cosine), the cosine taken from P's height alone, whatever the point's rounding.
[[gnu::always_inline]] inline double areaDensity(Double3 fromP, double height, double area) {
    double d2 = dot(fromP, fromP);
    return d2 * std::sqrt(d2) / (area * height);
}

[[gnu::always_inline]] inline float triangleDensity(Double3 P, Double3 corner, Double3 edgeA,
                                                    Double3 edgeB, double area, Double3 point) {
    Double3 normal = cross(edgeA, edgeB);
    double twice = std::sqrt(dot(normal, normal));
    double height = heightOver(corner - P, normal * (1 / twice));
    float density = rounded(areaDensity(point - P, height, area));
    return height > 0 ? density : 0.0f;
}

} // namespace

CANDELA_HOT void sampleSpheres(int count, const float *const P[3], const float *const centre[3],
                               const float *radius, const float *far, const float *u,
                               const float *v, float *const point[3], float *pdf) {
    const Columns<Double3> ps(P), centres(centre);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i], c = centres[i], toCentre = c - p;
        SeenSphere s = seen(toCentre, radius[i], far[i]);
        // What is left of u when it has chosen the wall is uniform again.
        const double share = far[i], drawn = s.outside ? u[i] : 1.0;
        const bool isFar = drawn < share;
        const double rest = isFar ? drawn / share : (drawn - share) / (1 - share);
        const double place = s.outside ? rest : u[i];
        double d = std::sqrt(s.d2), perD = 1 / (d > 0 ? d : 1.0);
        Double3 w{toCentre.x * perD, toCentre.y * perD, d > 0 ? toCentre.z * perD : 1.0};
        // A frame about w (Duff et al. 2017).
        double sign = std::copysign(1.0, w.z), a = -1 / (sign + w.z), b = w.x * w.y * a;
        Double3 e{1 + sign * w.x * w.x * a, sign * b, -sign * w.x},
            f{b, sign + w.y * w.y * a, -w.y};
        double cosine, sine, rho;
        disc(place, v[i], cosine, sine, rho);
        Double3 across = e * cosine + f * sine;
        store(point, i,
              narrow(pointOnSphere(p, c, radius[i], s, isFar, w, across, rho, rho * rho)));
        pdf[i] = s.density;
    }
}

CANDELA_HOT void sphereDensities(int count, const float *const P[3], const float *const centre[3],
                                 const float *radius, const float *far, float *pdf) {
    const Columns<Double3> ps(P), centres(centre);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
        pdf[i] = seen(centres[i] - ps[i], radius[i], far[i]).density;
}

CANDELA_HOT void sampleTriangles(int count, const float *const P[3], const float *const corner[3],
                                 const float *const edgeA[3], const float *const edgeB[3],
                                 const float *area, const float *u, const float *v,
                                 float *const point[3], float *pdf) {
    const Columns<Double3> ps(P), corners(corner), as(edgeA), bs(edgeB);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i], o = corners[i], a = as[i], b = bs[i];
        // The square folded along a diagonal, so that neighbours stay neighbours (Heitz 2019).
        double x = u[i], y = v[i];
        bool lower = x > y;
        double s = lower ? x - y / 2 : x / 2, t = lower ? y / 2 : y - x / 2;
        Vec3 at = narrow(o + a * s + b * t);
        store(point, i, at);
        pdf[i] = triangleDensity(p, o, a, b, area[i], wide(at));
    }
}

CANDELA_HOT void triangleDensities(int count, const float *const P[3], const float *const corner[3],
                                   const float *const edgeA[3], const float *const edgeB[3],
                                   const float *area, const float *const point[3], float *pdf) {
    const Columns<Double3> ps(P), corners(corner), as(edgeA), bs(edgeB), points(point);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
        pdf[i] = triangleDensity(ps[i], corners[i], as[i], bs[i], area[i], points[i]);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// All arithmetic is in doubles: differences of floats are exact in them, and solid angles keep
// their digits down to the sizes at which area serves as well.
#include "world/lights/shape_sampling.h"

#include "foundation/base/hot.h"
#include "world/lights/angles.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

struct Double3 {
    double x, y, z;
};

inline Double3 operator+(Double3 a, Double3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Double3 operator-(Double3 a, Double3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Double3 operator*(Double3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(Double3 a, Double3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Double3 cross(Double3 a, Double3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Three planes, their pointers read ahead of the loop.
struct Columns {
    explicit Columns(const float *const planes[3]) : x(planes[0]), y(planes[1]), z(planes[2]) {}
    Double3 operator[](int i) const { return {x[i], y[i], z[i]}; }
    const float *x, *y, *z;
};

inline void store(float *const planes[3], int i, Double3 p) {
    planes[0][i] = float(p.x), planes[1][i] = float(p.y), planes[2][i] = float(p.z);
}

/// A density as callers get it; false comparisons turn NaN to 0.
inline float rounded(double density) {
    return density <= double(std::numeric_limits<float>::max()) ? float(density) : 0.0f;
}

/// A sphere as seen from P. `height` is 1 less the cosine of the half angle of its cone; 2 from
/// within, where the cone is the whole sphere of directions.
struct SeenSphere {
    double d2, height;
    bool outside;
    float density;
};

[[gnu::always_inline]] inline SeenSphere seen(Double3 toCentre, double radius) {
    SeenSphere s;
    s.d2 = dot(toCentre, toCentre);
    double r2 = radius * radius;
    s.outside = s.d2 > r2;
    double sine2 = r2 / s.d2, cosine2 = (s.d2 - r2) / s.d2;
    s.height = s.outside ? sine2 / (1 + std::sqrt(s.outside ? cosine2 : 0.0)) : 2.0;
    float density = rounded(1 / (2 * pi * s.height));
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

/// The point that P sees on the sphere at `across` (unit, at right angles to the unit vector
/// `towards` the centre) and the share `rho2` of the cone's solid angle within.
[[gnu::always_inline]] inline Double3 pointOnSphere(Double3 P, Double3 centre, double radius,
                                                    const SeenSphere &s, Double3 towards,
                                                    Double3 across, double rho, double rho2) {
    double d = std::sqrt(s.d2), r2 = radius * radius;
    double height = s.height * rho2, cosine = 1 - height;
    double sine = rho * std::sqrt(s.height * (2 - height)); // The sign of rho is part of azimuth.
    // Half the chord: d2 (sin2 of the cone - sin2), factored where it would cancel.
    double gap = s.outside ? s.d2 * s.height * (1 - rho2) * (2 - s.height * (1 + rho2))
                           : r2 - s.d2 + s.d2 * cosine * cosine;
    double chord = std::sqrt(gap > 0 ? gap : 0.0), along = d * cosine;
    // First and second root of the quadratic, each in the form that doesn't cancel.
    bool sum = !s.outside && along > 0;
    double whole = s.outside ? along + chord : chord - along;
    double product = s.outside ? s.d2 - r2 : r2 - s.d2;
    double t = sum ? along + chord : product / (whole > 0 ? whole : 1.0);
    // From P or from the centre, whichever is nearer: the smaller of the two errors.
    bool fromP = t < radius;
    double inDepth = s.outside ? -(d * sine * sine + chord * cosine) : t * cosine - d;
    Double3 origin{fromP ? P.x : centre.x, fromP ? P.y : centre.y, fromP ? P.z : centre.z};
    return origin + towards * (fromP ? t * cosine : inDepth) + across * (t * sine);
}

/// A rectangle in the frame of its edges with P in the origin, and the angles at its corners as
/// seen from there (figure and names of the paper, section 4).
struct SeenRectangle {
    double perA, perB;   ///< 1 over the lengths of the edges.
    double area, height; ///< Height of P above the plane; 0 = there's nothing to see.
    double x0, x1, y0, y1;
    double solidAngle;     ///< 0 where that would lose digits.
    double cosineK, sineK; ///< Of the paper's k.
};

/// An angle in [0, 2 pi) as a number of its direction; products add angles.
struct Turn {
    double x, y;
};

inline double smaller(double a, double b) { return a < b ? a : b; }

inline Turn operator*(Turn a, Turn b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

/// Below this many steradians by area: the density hardly varies there, and angles lose digits.
constexpr double leastSolidAngle = 1e-4;

/// Distance of P from a plane through `corner`, 0 if it's but rounding.
[[gnu::always_inline]] inline double heightOver(Double3 toCorner, Double3 unitNormal) {
    double height = std::fabs(dot(toCorner, unitNormal));
    double scale = std::fabs(toCorner.x) + std::fabs(toCorner.y) + std::fabs(toCorner.z);
    return height > 4e-15 * scale ? height : 0.0;
}

[[gnu::always_inline]] inline SeenRectangle seen(Double3 toCorner, Double3 edgeA, Double3 edgeB) {
    SeenRectangle r;
    double lengthA = std::sqrt(dot(edgeA, edgeA)), lengthB = std::sqrt(dot(edgeB, edgeB));
    r.area = lengthA * lengthB, r.perA = 1 / lengthA, r.perB = 1 / lengthB;
    r.height = heightOver(toCorner, cross(edgeA, edgeB) * (r.perA * r.perB));
    double h = r.height, h2 = h * h;
    double x0 = dot(toCorner, edgeA) * r.perA, y0 = dot(toCorner, edgeB) * r.perB;
    double x1 = x0 + lengthA, y1 = y0 + lengthB;
    r.x0 = x0, r.x1 = x1, r.y0 = y0, r.y1 = y1;
    double xx0 = x0 * x0 + h2, xx1 = x1 * x1 + h2, yy0 = y0 * y0, yy1 = y1 * y1;
    // The corners' angles g0 to g3; k = 2 pi - g2 - g3, the solid angle is their sum - 2 pi.
    Turn g0{x1 * y0, h * std::sqrt(xx1 + yy0)}, g1{-(x1 * y1), h * std::sqrt(xx1 + yy1)};
    Turn g2{x0 * y1, h * std::sqrt(xx0 + yy1)}, g3{-(x0 * y0), h * std::sqrt(xx0 + yy0)};
    Turn last = g2 * g3, sum = g0 * g1 * last;
    double perLength = 1 / std::sqrt(last.x * last.x + last.y * last.y);
    r.cosineK = last.x * perLength, r.sineK = -last.y * perLength;
    double angle = angleOf(std::fabs(sum.y), sum.x);
    // More than 3/2 pi only close above the middle; elsewhere it is 0, rounded.
    double nearest = smaller(smaller(-x0, x1), smaller(-y0, y1));
    double full = h < nearest ? 2 * pi : sum.x > 0 ? angle : 2 * pi;
    double solidAngle = sum.y < 0 ? full - angle : angle;
    solidAngle = h > 0 ? solidAngle : 0.0;
    r.solidAngle = solidAngle >= leastSolidAngle ? solidAngle : 0.0;
    return r;
}

/// d^2 / (area cosine), the cosine taken from P's height alone, whatever the point's rounding.
[[gnu::always_inline]] inline double areaDensity(Double3 fromP, double height, double area) {
    double d2 = dot(fromP, fromP);
    return d2 * std::sqrt(d2) / (area * height);
}

[[gnu::always_inline]] inline float density(const SeenRectangle &r, Double3 fromP) {
    double d2 = dot(fromP, fromP); // As areaDensity has it, with one division for both.
    double weight = r.solidAngle > 0 ? 1 : d2 * std::sqrt(d2);
    float density = rounded(weight / (r.solidAngle > 0 ? r.solidAngle : r.area * r.height));
    return r.height > 0 ? density : 0.0f;
}

/// Turns (u,v) to shares of the edges, uniformly by solid angle.
[[gnu::always_inline]] inline void spread(const SeenRectangle &r, double &u, double &v) {
    double h2 = r.height * r.height;
    double per0 = 1 / (r.y0 * r.y0 + h2), per1 = 1 / (r.y1 * r.y1 + h2);
    double b0 = -r.y0 * std::sqrt(per0), b1 = r.y1 * std::sqrt(per1);
    double s, c;
    sinCosOf(u * r.solidAngle, s, c);
    double cosine = c * r.cosineK - s * r.sineK, sine = s * r.cosineK + c * r.sineK;
    // The paper's f is along / sine, and 1/cu^2 - 1 is slope2 / sine^2; b0^2 - 1 is written so that
    // it keeps its digits at low heights.
    double along = cosine * b0 - b1, slope2 = along * along - sine * sine * h2 * per0;
    double x = std::sqrt(h2 * sine * sine / (slope2 > 0 ? slope2 : 0.0));
    x = std::copysign(x, along * sine);
    x = x > r.x0 ? x : r.x0; // In this form NaN ends, too.
    x = x < r.x1 ? x : r.x1;
    double d2 = x * x + h2;
    double low = r.y0 / std::sqrt(d2 + r.y0 * r.y0), high = r.y1 / std::sqrt(d2 + r.y1 * r.y1);
    double at = low + v * (high - low), rest = 1 - at * at;
    double y = at * std::sqrt(d2 / (rest > 0 ? rest : 0.0));
    y = y > r.y0 ? y : r.y0;
    y = y < r.y1 ? y : r.y1;
    u = (x - r.x0) * r.perA, v = (y - r.y0) * r.perB;
    u = u < 1 ? u : 1.0, v = v < 1 ? v : 1.0;
}

[[gnu::always_inline]] inline float triangleDensity(Double3 P, Double3 corner, Double3 edgeA,
                                                    Double3 edgeB, double area, Double3 point) {
    Double3 normal = cross(edgeA, edgeB);
    double twice = std::sqrt(dot(normal, normal));
    double height = heightOver(corner - P, normal * (1 / twice));
    float density = rounded(areaDensity(point - P, height, area));
    return height > 0 ? density : 0.0f;
}

inline Double3 asFloats(Double3 p) { return {float(p.x), float(p.y), float(p.z)}; }

} // namespace

CANDELA_HOT void sampleSpheres(int count, const float *const P[3], const float *const centre[3],
                               const float *radius, const float *u, const float *v,
                               float *const point[3], float *pdf) {
    const Columns ps(P), centres(centre);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i], c = centres[i], toCentre = c - p;
        SeenSphere s = seen(toCentre, radius[i]);
        double d = std::sqrt(s.d2), perD = 1 / (d > 0 ? d : 1.0);
        Double3 w{toCentre.x * perD, toCentre.y * perD, d > 0 ? toCentre.z * perD : 1.0};
        // A frame about w (Duff et al. 2017).
        double sign = std::copysign(1.0, w.z), a = -1 / (sign + w.z), b = w.x * w.y * a;
        Double3 e{1 + sign * w.x * w.x * a, sign * b, -sign * w.x},
            f{b, sign + w.y * w.y * a, -w.y};
        double cosine, sine, rho;
        disc(u[i], v[i], cosine, sine, rho);
        store(point, i,
              pointOnSphere(p, c, radius[i], s, w, e * cosine + f * sine, rho, rho * rho));
        pdf[i] = s.density;
    }
}

CANDELA_HOT void sphereDensities(int count, const float *const P[3], const float *const centre[3],
                                 const float *radius, float *pdf) {
    const Columns ps(P), centres(centre);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
        pdf[i] = seen(centres[i] - ps[i], radius[i]).density;
}

CANDELA_HOT void sampleRectangles(int count, const float *const P[3], const float *const corner[3],
                                  const float *const edgeA[3], const float *const edgeB[3],
                                  const float *u, const float *v, float *const point[3],
                                  float *pdf) {
    const Columns ps(P), corners(corner), as(edgeA), bs(edgeB);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i], o = corners[i], a = as[i], b = bs[i];
        SeenRectangle r = seen(o - p, a, b);
        double s = u[i], t = v[i];
        spread(r, s, t);
        s = r.solidAngle > 0 ? s : u[i], t = r.solidAngle > 0 ? t : v[i];
        Double3 at = asFloats(o + a * s + b * t);
        store(point, i, at);
        pdf[i] = density(r, at - p);
    }
}

CANDELA_HOT void rectangleDensities(int count, const float *const P[3],
                                    const float *const corner[3], const float *const edgeA[3],
                                    const float *const edgeB[3], const float *const point[3],
                                    float *pdf) {
    const Columns ps(P), corners(corner), as(edgeA), bs(edgeB), points(point);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i];
        SeenRectangle r = seen(corners[i] - p, as[i], bs[i]);
        pdf[i] = density(r, points[i] - p);
    }
}

CANDELA_HOT void sampleTriangles(int count, const float *const P[3], const float *const corner[3],
                                 const float *const edgeA[3], const float *const edgeB[3],
                                 const float *area, const float *u, const float *v,
                                 float *const point[3], float *pdf) {
    const Columns ps(P), corners(corner), as(edgeA), bs(edgeB);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        Double3 p = ps[i], o = corners[i], a = as[i], b = bs[i];
        // The square folded along a diagonal, so that neighbours stay neighbours (Heitz 2019).
        double x = u[i], y = v[i];
        bool lower = x > y;
        double s = lower ? x - y / 2 : x / 2, t = lower ? y / 2 : y - x / 2;
        Double3 at = asFloats(o + a * s + b * t);
        store(point, i, at);
        pdf[i] = triangleDensity(p, o, a, b, area[i], at);
    }
}

CANDELA_HOT void triangleDensities(int count, const float *const P[3], const float *const corner[3],
                                   const float *const edgeA[3], const float *const edgeB[3],
                                   const float *area, const float *const point[3], float *pdf) {
    const Columns ps(P), corners(corner), as(edgeA), bs(edgeB), points(point);
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
        pdf[i] = triangleDensity(ps[i], corners[i], as[i], bs[i], area[i], points[i]);
}

} // namespace candela

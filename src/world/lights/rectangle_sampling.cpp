// SPDX-License-Identifier: Apache-2.0
// A rectangle is filled by lines along y, where the planes of a fan about the axis through P meet
// it. The fan's angle is uniform, and so is the solid angle along the line: what a line gathers,
// its `breadth`, is the one thing that samples differ in. As x is along the edge that P is further
// beyond the ends of, breadths hardly vary; the variance of their ratio to the mean is 0.3 at worst
// (narrow strips seen from beside their ends), 1e-4 in the middle of many views.
//
// Heights are small differences and need doubles. All else is written so that floats keep digits.
// Each step is a loop of its own: in a long one, lanes would wait for their own results.
#include "foundation/base/hot.h"
#include "foundation/base/vec3.h"
#include "world/lights/angles.h"
#include "world/lights/shape_arithmetic.h"
#include "world/lights/shape_sampling.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

inline float larger(float a, float b) { return a > b ? a : b; }

/// A number of [low, high]; NaN becomes low.
inline float within(float x, float low, float high) {
    x = x > low ? x : low;
    return x < high ? x : high;
}

constexpr int block = 128;
using Plane = float[block];

/// Rectangles in the frames of their edges, with P in the origin. Lengths are shares of size and
/// distance, so that their products stay in range.
struct alignas(64) SeenRectangles {
    Plane turned; ///< 1: x is along edge B, 0: along edge A.
    Plane height; ///< Of P above the plane; 0 = there's nothing to see.
    Plane x, y;   ///< The corner.
    Plane lengthX, lengthY;
    Plane axisX, axisY, axisZ; ///< The coordinate x of a vector is its product with this.
    Plane angle;               ///< Of the fan.
};

CANDELA_HOT void see(int count, const Columns<Vec3> &P, const Columns<Vec3> &corner,
                     const Columns<Vec3> &edgeA, const Columns<Vec3> &edgeB, SeenRectangles &r) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const Vec3 floatA = edgeA[i], floatB = edgeB[i];
        const Double3 toCorner = wide(corner[i]) - wide(P[i]), a = wide(floatA), b = wide(floatB);
        const float a2 = dot(floatA, floatA), b2 = dot(floatB, floatB);
        const float perA = 1 / std::sqrt(a2), perB = 1 / std::sqrt(b2);
        const float lengthA = a2 * perA, lengthB = b2 * perB;
        const Double3 normal = cross(a, b) * (double(perA) * double(perB));
        const float height = float(heightOver(toCorner, normal));
        const float atA = float(dot(toCorner, a)) * perA, atB = float(dot(toCorner, b)) * perB;
        const float beyondA = larger(larger(atA, -(atA + lengthA)), 0);
        const float beyondB = larger(larger(atB, -(atB + lengthB)), 0);
        const float scale = 1 / (std::fabs(atA) + std::fabs(atB) + (lengthA + lengthB) + height);
        const bool turned = beyondB > beyondA;
        const float perX = (turned ? perB : perA) * scale;
        r.turned[i] = turned ? 1.0f : 0.0f, r.height[i] = height * scale;
        r.x[i] = (turned ? atB : atA) * scale, r.y[i] = (turned ? atA : atB) * scale;
        r.lengthX[i] = (turned ? lengthB : lengthA) * scale;
        r.lengthY[i] = (turned ? lengthA : lengthB) * scale;
        r.axisX[i] = (turned ? floatB.x : floatA.x) * perX;
        r.axisY[i] = (turned ? floatB.y : floatA.y) * perX;
        r.axisZ[i] = (turned ? floatB.z : floatA.z) * perX;
    }
}

CANDELA_HOT void openFans(int count, SeenRectangles &r) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i)
        r.angle[i] = angleOf(r.height[i] * r.lengthX[i],
                             r.height[i] * r.height[i] + r.x[i] * (r.x[i] + r.lengthX[i]));
}

/// The line at x: its distance from P squared, and those of its ends.
struct Line {
    float y0, y1, lengthY, d2, end0, end1;
    bool aside; ///< Both ends are on one side of P.
};

[[gnu::always_inline]] inline Line lineAt(const SeenRectangles &r, int i, float x) {
    const float y0 = r.y[i], lengthY = r.lengthY[i], y1 = y0 + lengthY;
    const float d2 = x * x + r.height[i] * r.height[i];
    return {y0, y1, lengthY, d2, std::sqrt(d2 + y0 * y0), std::sqrt(d2 + y1 * y1), y0 * y1 > 0};
}

/// y1/end1 - y0/end0; for ends on one side in the form that doesn't cancel.
[[gnu::always_inline]] inline float breadth(const Line &l) {
    const float in = l.y1 * l.end0, out = l.y0 * l.end1, ends = l.end0 * l.end1;
    const float difference = l.aside ? l.d2 * l.lengthY * (l.y0 + l.y1) : in - out;
    return difference / (l.aside ? ends * (in + out) : ends);
}

/// Lines at shares u of the fans: how far along x.
CANDELA_HOT void chooseLines(int count, const SeenRectangles &r, const float *u, float *along) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        float sine, cosine;
        sinCosOf(u[i] * r.angle[i], sine, cosine);
        const float h = r.height[i], x = r.x[i], toward = h * cosine - x * sine;
        const float step = sine * (h * h + x * x) / toward;
        along[i] = within(toward > 0 ? step : r.lengthX[i], 0, r.lengthX[i]);
    }
}

/// Points at shares v of the lines: how far along y.
CANDELA_HOT void chooseOnLines(int count, const SeenRectangles &r, const float *along,
                               const float *v, float *across) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const Line line = lineAt(r, i, r.x[i] + along[i]);
        // Sines and cosines of the angles at P between y = 0 and the line's beginning, and the
        // point that is chosen.
        const float distance = std::sqrt(line.d2), perEnd = 1 / line.end0;
        const float s0 = line.y0 * perEnd, c0 = distance * perEnd, rise = v[i] * breadth(line);
        const float s = s0 + rise, rest = 1 - s * s, c = std::sqrt(rest > 0 ? rest : 0.0f);
        // distance (s / c - s0 / c0), where both are of one sign without a difference.
        const float up = line.aside ? distance * rise * (s + s0) : distance * s - line.y0 * c;
        across[i] = within(up / (line.aside ? (s * c0 + s0 * c) * c * c0 : c), 0, line.lengthY);
    }
}

CANDELA_HOT void placePoints(int count, const SeenRectangles &r, const float *along,
                             const float *across, const Columns<Vec3> &corner,
                             const Columns<Vec3> &edgeA, const Columns<Vec3> &edgeB,
                             float *const point[3]) {
    float *x = point[0], *y = point[1], *z = point[2];
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float u = along[i] / r.lengthX[i], v = across[i] / r.lengthY[i];
        const double a = r.turned[i] > 0 ? v : u, b = r.turned[i] > 0 ? u : v;
        const Vec3 at = narrow(wide(corner[i]) + wide(edgeA[i]) * a + wide(edgeB[i]) * b);
        x[i] = at.x, y[i] = at.y, z[i] = at.z;
    }
}

CANDELA_HOT void weigh(int count, const SeenRectangles &r, const Columns<Vec3> &P,
                       const Columns<Vec3> &point, float *pdf) {
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float x = dot(point[i] - P[i], {r.axisX[i], r.axisY[i], r.axisZ[i]});
        const float density = 1 / (r.angle[i] * breadth(lineAt(r, i, x)));
        pdf[i] = (r.height[i] > 0) & (density <= largestDensity) ? density : 0.0f;
    }
}

} // namespace

void sampleRectangles(int count, const float *const P[3], const float *const corner[3],
                      const float *const edgeA[3], const float *const edgeB[3], const float *u,
                      const float *v, float *const point[3], float *pdf) {
    SeenRectangles r;
    alignas(64) Plane along, across;
    for (int first = 0; first < count; first += block) {
        const int n = std::min(block, count - first);
        const Columns<Vec3> ps(P, first), corners(corner, first), as(edgeA, first);
        const Columns<Vec3> bs(edgeB, first);
        float *const at[3] = {point[0] + first, point[1] + first, point[2] + first};
        see(n, ps, corners, as, bs, r);
        openFans(n, r);
        chooseLines(n, r, u + first, along);
        chooseOnLines(n, r, along, v + first, across);
        placePoints(n, r, along, across, corners, as, bs, at);
        weigh(n, r, ps, Columns<Vec3>(at), pdf + first);
    }
}

void rectangleDensities(int count, const float *const P[3], const float *const corner[3],
                        const float *const edgeA[3], const float *const edgeB[3],
                        const float *const point[3], float *pdf) {
    SeenRectangles r;
    for (int first = 0; first < count; first += block) {
        const int n = std::min(block, count - first);
        const Columns<Vec3> ps(P, first);
        see(n, ps, {corner, first}, {edgeA, first}, {edgeB, first}, r);
        openFans(n, r);
        weigh(n, r, ps, {point, first}, pdf + first);
    }
}

} // namespace candela

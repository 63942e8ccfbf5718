// SPDX-License-Identifier: Apache-2.0
#include "world/lights/shape_sampling.h"

#include "foundation/base/planes.h"
#include "foundation/base/vec3.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

using namespace candela;

namespace {

using Real = long double;
constexpr Real pi = 3.14159265358979323846L;

struct R3 {
    Real x = 0, y = 0, z = 0;
    R3() = default;
    R3(Real x, Real y, Real z) : x(x), y(y), z(z) {}
    R3(Vec3 v) : x(v.x), y(v.y), z(v.z) {}
};
R3 operator-(R3 a, R3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
R3 operator+(R3 a, R3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
R3 operator*(R3 a, Real s) { return {a.x * s, a.y * s, a.z * s}; }
Real dot(R3 a, R3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
R3 cross(R3 a, R3 b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
Real length(R3 a) { return std::sqrt(dot(a, a)); }

enum class Kind { Sphere, Rectangle, Triangle };

/// A shape as seen from P; spheres have their centre in `corner`.
struct View {
    Kind kind;
    Vec3 P, corner, edgeA, edgeB;
    float radius = 0;
    float far = 0; ///< How often a sphere's farther wall is drawn.
};

float triangleArea(const View &view) { return float(length(cross(view.edgeA, view.edgeB)) / 2); }

struct Sampled {
    std::vector<Vec3> points;
    std::vector<float> pdf;
};

/// One shape in all lanes.
class Lanes {
public:
    Lanes(const View &view, int count) : kind_(view.kind), count_(count) {
        planes_ = Planes<float>(19, count);
        for (int plane = 0; plane < 19; ++plane)
            p_[plane] = planes_[plane];
        for (int i = 0; i < count; ++i) {
            for (int k = 0; k < 3; ++k) {
                p_[k][i] = view.P[k], p_[3 + k][i] = view.corner[k];
                p_[6 + k][i] = view.edgeA[k], p_[9 + k][i] = view.edgeB[k];
            }
            p_[18][i] = view.far;
            p_[12][i] = kind_ == Kind::Triangle ? triangleArea(view) : view.radius;
        }
    }
    Sampled sample(const std::vector<float> &u, const std::vector<float> &v) {
        if (kind_ == Kind::Sphere)
            sampleSpheres(count_, p_, p_ + 3, p_[12], p_[18], u.data(), v.data(), p_ + 13, p_[16]);
        else if (kind_ == Kind::Rectangle)
            sampleRectangles(count_, p_, p_ + 3, p_ + 6, p_ + 9, u.data(), v.data(), p_ + 13,
                             p_[16]);
        else
            sampleTriangles(count_, p_, p_ + 3, p_ + 6, p_ + 9, p_[12], u.data(), v.data(), p_ + 13,
                            p_[16]);
        Sampled s;
        for (int i = 0; i < count_; ++i)
            s.points.push_back({p_[13][i], p_[14][i], p_[15][i]}), s.pdf.push_back(p_[16][i]);
        return s;
    }
    std::vector<float> densities(const std::vector<Vec3> &points) {
        for (int i = 0; i < count_; ++i)
            for (int k = 0; k < 3; ++k)
                p_[13 + k][i] = points[i][k];
        if (kind_ == Kind::Sphere)
            sphereDensities(count_, p_, p_ + 3, p_[12], p_[18], p_[17]);
        else if (kind_ == Kind::Rectangle)
            rectangleDensities(count_, p_, p_ + 3, p_ + 6, p_ + 9, p_ + 13, p_[17]);
        else
            triangleDensities(count_, p_, p_ + 3, p_ + 6, p_ + 9, p_[12], p_ + 13, p_[17]);
        return {p_[17], p_[17] + count_};
    }

private:
    Kind kind_;
    int count_;
    Planes<float> planes_;
    float *p_[19];
};

/// The centres of n x n strata.
Sampled sampleStrata(const View &view, int n) {
    std::vector<float> u, v;
    for (int i = 0; i < n * n; ++i)
        u.push_back((float(i % n) + 0.5f) / float(n)),
            v.push_back((float(i / n) + 0.5f) / float(n));
    return Lanes(view, n * n).sample(u, v);
}

Sampled sampleRandomly(const View &view, int count, int seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<float> u, v;
    for (int i = 0; i < count; ++i)
        u.push_back(std::min(uniform(random), 0x1.fffffep-1f)),
            v.push_back(std::min(uniform(random), 0x1.fffffep-1f));
    for (int corner = 0; corner < 4; ++corner) {
        u[corner] = corner & 1 ? 0x1.fffffep-1f : 0;
        v[corner] = corner & 2 ? 0x1.fffffep-1f : 0;
    }
    return Lanes(view, count).sample(u, v);
}

/// Solid angle of a triangle (Van Oosterom and Strackee 1983).
Real triangleAngle(R3 a, R3 b, R3 c) {
    Real la = length(a), lb = length(b), lc = length(c);
    Real below = la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb;
    return 2 * std::fabs(std::atan2(std::fabs(dot(a, cross(b, c))), below));
}

/// Solid angle of the part [s0,s1] x [t0,t1] of a rectangle.
Real partAngle(const View &w, Real s0, Real s1, Real t0, Real t1) {
    auto at = [&](Real s, Real t) {
        return R3(w.corner) + R3(w.edgeA) * s + R3(w.edgeB) * t - R3(w.P);
    };
    return triangleAngle(at(s0, t0), at(s1, t0), at(s1, t1)) +
           triangleAngle(at(s0, t0), at(s1, t1), at(s0, t1));
}

/// Irradiance at P, normal N, of a convex polygon of radiance 1 above the horizon (Lambert).
Real lambert(const std::vector<R3> &corners, R3 N) {
    R3 sum;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        R3 a = corners[i], b = corners[(i + 1) % corners.size()], n = cross(a, b);
        sum = sum + n * (std::atan2(length(n), dot(a, b)) / length(n));
    }
    return std::fabs(dot(sum, N)) / 2;
}

Real estimate(const View &view, const Sampled &s, R3 N) {
    Real sum = 0;
    for (std::size_t i = 0; i < s.pdf.size(); ++i) {
        R3 d = R3(s.points[i]) - R3(view.P);
        sum += s.pdf[i] > 0 ? std::max(dot(d, N) / length(d), Real(0)) / s.pdf[i] : 0;
    }
    return sum / s.pdf.size();
}

/// Spheres near and far, tiny and huge, seen from outside.
std::vector<View> outsideSpheres() {
    std::vector<View> views;
    for (float r : {1e-9f, 1e-3f, 1.0f, 1e3f, 1e9f})
        for (float distance : {1.0000002f, 1.0001f, 1.01f, 2.0f, 1e3f, 1e7f})
            for (Vec3 w : {Vec3{0, 0, 1}, Vec3{0, 0, -1}, Vec3{0.6f, -0.64f, 0.48f}})
                for (float far : {0.0f, 0.5f, 1.0f})
                    views.push_back({Kind::Sphere, {0, 0, 0}, w * (r * distance), {}, {}, r, far});
    views.push_back({Kind::Sphere, {1000, 2000, 3000}, {1000, 2000, 3005}, {}, {}, 0.5f});
    return views;
}

std::vector<View> insideSpheres() {
    std::vector<View> views;
    for (float r : {1e-6f, 1.0f, 1e9f})
        for (float at : {0.0f, 0.5f, 0.999999f, 1.0f})
            for (Vec3 w : {Vec3{0, 0, 1}, Vec3{0, -1, 0}})
                for (float far : {0.0f, 0.5f, 1.0f})
                    views.push_back({Kind::Sphere, w * (r * at), {}, {}, {}, r, far});
    return views;
}

/// Rectangles or triangles of many sizes and forms, seen from above, beside, near and far.
std::vector<View> flatViews(Kind kind) {
    std::vector<View> views;
    std::vector<Vec3> places{{0.5f, 0.5f, 1},      {0.2f, 0.7f, -0.05f}, {0.1f, 0.1f, 1e-3f},
                             {-1, 0.5f, 0.3f},     {-1, -2, 1e-2f},      {3, 0.2f, -1e-3f},
                             {0.5f, 0.5f, 100},    {40, 80, 3},          {0, 0, 0.5f},
                             {-0.01f, 0.3f, 1e-4f}};
    for (float size : {1e-9f, 1e-3f, 1.0f, 1e9f})
        for (Vec3 p : places)
            for (float aspect : {1.0f, 0.01f})
                for (bool turned : {false, true}) {
                    Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
                    if (turned)
                        x = {0.36f, 0.48f, 0.8f}, y = {-0.8f, 0.6f, 0}, z = cross(x, y);
                    auto at = [&](Vec3 v) { return (x * v.x + y * v.y + z * v.z) * size; };
                    views.push_back({kind, at(p), {}, at({1, 0, 0}), at({0, aspect, 0}), 0});
                }
    return views;
}

std::vector<View> allViews() {
    std::vector<View> all = outsideSpheres();
    for (std::vector<View> more :
         {insideSpheres(), flatViews(Kind::Rectangle), flatViews(Kind::Triangle)})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

/// 1 - cos of the angle whose sine is s, also for tiny s.
Real capHeight(Real s) { return s * s / (1 + std::sqrt(1 - s * s)); }

Real chiSquare(const std::vector<int> &counts, const std::vector<Real> &shares, int total) {
    Real sum = 0;
    for (std::size_t c = 0; c < counts.size(); ++c) {
        Real expected = shares[c] * total;
        sum += (counts[c] - expected) * (counts[c] - expected) / expected;
    }
    return sum;
}

/// 63 degrees of freedom: exceeded once in 10^6 draws.
constexpr Real chiSquareLimit = 127;

} // namespace

TEST(ShapeSampling, HitsHaveTheDensityOfSamples) {
    for (const View &view : allViews()) {
        Sampled s = sampleRandomly(view, 101, 1);
        EXPECT_EQ(Lanes(view, 101).densities(s.points), s.pdf);
        for (float pdf : s.pdf)
            EXPECT_GT(pdf, 0);
    }
}

TEST(ShapeSampling, PointsLieOnTheShape) {
    for (const View &view : allViews()) {
        Real scale = length(R3(view.corner)) + view.radius + length(R3(view.edgeA));
        for (Vec3 point : sampleRandomly(view, 200, 2).points) {
            R3 d = R3(point) - R3(view.corner), a = view.edgeA, b = view.edgeB;
            if (view.kind == Kind::Sphere) {
                EXPECT_NEAR(length(d), view.radius, 2e-7L * scale);
                continue;
            }
            R3 n = cross(a, b), toB = cross(n, a), toA = cross(b, n);
            Real s = dot(d, toA) / dot(a, toA), t = dot(d, toB) / dot(b, toB);
            Real room = 2e-7L * scale;
            EXPECT_NEAR(dot(d, n) / length(n), 0, room);
            EXPECT_GE(s * length(a), -room);
            EXPECT_GE(t * length(b), -room);
            EXPECT_LE(view.kind == Kind::Triangle ? s + t : std::max(s, t),
                      1 + room / std::min(length(a), length(b)));
        }
    }
}

TEST(ShapeSampling, SphereDensityTimesSolidAngleIsOne) {
    for (const View &view : outsideSpheres()) {
        Real sine = view.radius / length(R3(view.corner) - R3(view.P));
        ASSERT_LT(sine, 1);
        const Real wall = view.far == 0.5f ? 0.5L : 1;
        EXPECT_NEAR(sampleStrata(view, 1).pdf[0] * 2 * pi * capHeight(sine), wall, 2e-7L);
    }
    for (const View &view : insideSpheres())
        EXPECT_NEAR(sampleStrata(view, 1).pdf[0] * 4 * pi, 1, 2e-7L);
}

/// Of the two walls that a direction meets, the one that is wanted; where either is, both count.
TEST(ShapeSampling, SpheresShineFromTheWallThatIsWanted) {
    for (float far : {0.0f, 0.5f, 1.0f})
        for (float height : {0.51f, 0.8f, 2.0f, 50.0f}) {
            const View view{Kind::Sphere, {0, 0, 0}, {0, 0.1f, height}, {}, {}, 0.5f, far};
            const Sampled samples = sampleRandomly(view, 4096, 7);
            int beyond = 0;
            for (Vec3 point : samples.points) {
                const R3 way = R3(point) - R3(view.P), out = R3(point) - R3(view.corner);
                beyond += dot(way, out) > 0;
            }
            EXPECT_NEAR(beyond / 4096.0, far, far == 0.5f ? 0.04 : 0.001) << height;
            const Real D = length(R3(view.corner)), s = 0.5L / D;
            const Real closed = pi * s * s * height / D * (far == 0.5f ? 2 : 1);
            EXPECT_NEAR(estimate(view, sampleStrata(view, 128), {0, 0, 1}) / closed, 1, 2e-4L);
        }
}

TEST(ShapeSampling, RectangleSamplesAreWorthTheSolidAngleAndHardlyDiffer) {
    std::vector<View> views = flatViews(Kind::Rectangle);
    for (float size : {1e-15f, 1.0f, 1e15f}) // Lines along which breadths differ most.
        for (float height : {1e-4f, 1e-3f, 1e-2f})
            for (float x : {1.03f, 0.5f, -0.03f})
                for (float y : {0.005f, -0.005f, -0.05f})
                    for (bool swapped : {false, true}) {
                        Vec3 a{size, 0, 0}, b{0, 0.01f * size, 0};
                        Vec3 P{x * size, y * size, height * size};
                        views.push_back(
                            {Kind::Rectangle, P, {}, swapped ? b : a, swapped ? a : b, 0});
                    }
    for (const View &view : views) {
        // What samples are worth varies with u alone, from low heights fast.
        const int n = 1 << 15;
        std::vector<float> u(n), v(n, 0.3f);
        for (int i = 0; i < n; ++i)
            u[i] = (float(i) + 0.5f) / float(n);
        Real sum = 0, squares = 0;
        for (float pdf : Lanes(view, n).sample(u, v).pdf)
            sum += 1 / Real(pdf), squares += 1 / (Real(pdf) * pdf);
        const Real mean = sum / n, solidAngle = partAngle(view, 0, 1, 0, 1);
        EXPECT_NEAR(mean / solidAngle, 1, 1e-5L) << double(solidAngle);
        EXPECT_LT(squares / n / (mean * mean) - 1, 0.3L);
    }
}

TEST(ShapeSampling, TriangleDensityIntegratesToOneOverDirections) {
    View view{Kind::Triangle, {0.2f, 0.3f, 0.8f}, {0, 0, 0}, {1, 0.2f, 0}, {0.1f, 1, 0.3f}, 0};
    // Directions of a fine grid of the sphere, met with the plane.
    int n = 1000;
    Real sum = 0;
    R3 a = view.edgeA, b = view.edgeB, normal = cross(a, b), o = R3(view.corner) - R3(view.P);
    std::vector<Vec3> points;
    for (int i = 0; i < n * n; ++i) {
        Real z = 2 * (i / n + 0.5L) / n - 1, phi = 2 * pi * (i % n + 0.5L) / n;
        R3 w{std::sqrt(1 - z * z) * std::cos(phi), std::sqrt(1 - z * z) * std::sin(phi), z};
        Real distance = dot(o, normal) / dot(w, normal);
        R3 d = w * distance - o, toB = cross(normal, a), toA = cross(b, normal);
        Real s = dot(d, toA) / dot(a, toA), t = dot(d, toB) / dot(b, toB);
        R3 at = d + R3(view.corner);
        if (distance > 0 && s >= 0 && t >= 0 && s + t <= 1)
            points.push_back({float(at.x), float(at.y), float(at.z)});
    }
    for (float pdf : Lanes(view, int(points.size())).densities(points))
        sum += pdf * 4 * pi / (Real(n) * n);
    EXPECT_NEAR(sum, 1, 1e-2L);
}

TEST(ShapeSampling, SphereSamplesFillTheConeUniformly) {
    int total = 20000, seed = 1;
    std::vector<View> views = outsideSpheres(), inside = insideSpheres();
    views.insert(views.end(), inside.begin(), inside.end());
    for (const View &view : views) {
        R3 w = R3(view.corner) - R3(view.P);
        Real d = length(w), r = view.radius;
        // Directions need digits: skip where the rounding of points hides them.
        if (d / r > 1e3L || (d >= r && d - r < 1e-3L * r) || (d < r && r - d < 1e-3L * r))
            continue;
        w = d > 0 ? w * (1 / d) : R3(0, 0, 1);
        R3 x = std::fabs(w.x) < 0.9L ? cross(w, {1, 0, 0}) : cross(w, {0, 1, 0}), y;
        x = x * (1 / length(x)), y = cross(w, x);
        Real height = d > r ? capHeight(r / d) : 2;
        std::vector<int> counts(64);
        for (Vec3 point : sampleRandomly(view, total, ++seed).points) {
            R3 to = R3(point) - R3(view.P);
            Real across = std::hypot(dot(to, x), dot(to, y)) / length(to);
            Real h = dot(to, w) > 0 ? capHeight(std::min<Real>(across, 1))
                                    : 2 - capHeight(std::min<Real>(across, 1));
            int ring = std::clamp(int(8 * h / height), 0, 7);
            int sector = int(8 * (std::atan2(dot(to, y), dot(to, x)) / (2 * pi) + 1)) % 8;
            ++counts[ring * 8 + sector];
        }
        EXPECT_LT(chiSquare(counts, std::vector<Real>(64, 1.0L / 64), total), chiSquareLimit);
    }
}

TEST(ShapeSampling, RectangleSamplesAreWorthTheSolidAngleOfEachPart) {
    const int total = 20000;
    int seed = 100;
    for (const View &view : flatViews(Kind::Rectangle)) {
        std::vector<int> counts(64);
        std::vector<Real> sums(64);
        Sampled samples = sampleRandomly(view, total, ++seed);
        for (int i = 0; i < total; ++i) {
            R3 d = R3(samples.points[i]) - R3(view.corner), a = view.edgeA, b = view.edgeB;
            int s = std::clamp(int(8 * dot(d, a) / dot(a, a)), 0, 7);
            int t = std::clamp(int(8 * dot(d, b) / dot(b, b)), 0, 7);
            ++counts[t * 8 + s], sums[t * 8 + s] += 1 / Real(samples.pdf[i]);
        }
        // Cells in which fewer than five are expected would spoil the statistic.
        if (*std::min_element(counts.begin(), counts.end()) < 10)
            continue;
        Real chiSquare = 0;
        for (int c = 0; c < 64; ++c) {
            const Real angle = partAngle(view, (c % 8) / 8.0L, (c % 8 + 1) / 8.0L, (c / 8) / 8.0L,
                                         (c / 8 + 1) / 8.0L);
            // Samples of a part are worth nearly the same: the variance is that of their number.
            const Real worth = sums[c] / counts[c], found = sums[c] / total;
            chiSquare += (found - angle) * (found - angle) * total / (angle * worth);
        }
        EXPECT_LT(chiSquare, chiSquareLimit);
    }
}

TEST(ShapeSampling, SquareGivesLambertsIrradiance) {
    for (Vec3 P : {Vec3{0, 0, -1}, Vec3{1, 0.5f, -2}, Vec3{0.3f, 0.2f, -0.05f}, Vec3{5, 5, -0.5f},
                   Vec3{0, 0, -300}, Vec3{0.4f, -0.4f, -0.002f}})
        for (float size : {1e-6f, 1.0f, 1e6f})
            for (Kind kind : {Kind::Rectangle, Kind::Triangle}) {
                View view{kind,
                          P * size,
                          Vec3{-0.5f, -0.5f, 0} * size,
                          Vec3{size, 0, 0},
                          Vec3{0, size, 0},
                          0};
                if (kind == Kind::Triangle && P.z > -0.5f)
                    continue; // By area: too noisy for closed forms this near.
                R3 o = R3(view.corner) - R3(view.P), a = view.edgeA, b = view.edgeB;
                std::vector<R3> corners{o, o + a, o + a + b, o + b};
                if (kind == Kind::Triangle)
                    corners = {o, o + a, o + b};
                Real closed = lambert(corners, {0, 0, 1});
                Real E = estimate(view, sampleStrata(view, 256), {0, 0, 1});
                EXPECT_NEAR(E / closed, 1, 1e-4L) << P.x << ' ' << P.z << ' ' << int(kind);
            }
}

TEST(ShapeSampling, WallGivesLambertsIrradianceAtGrazingPoints) {
    // A wall that stands on the floor, and a floor lamp seen edge on by a wall.
    for (float beside : {0.001f, 0.1f, 2.0f, 50.0f}) {
        View wall{Kind::Rectangle, {-beside, 0.2f, 0}, {0, -1, 0}, {0, 2, 0}, {0, 0, 3}, 0};
        R3 o = R3(wall.corner) - R3(wall.P), a = wall.edgeA, b = wall.edgeB;
        Real closed = lambert({o, o + a, o + a + b, o + b}, {0, 0, 1});
        EXPECT_NEAR(estimate(wall, sampleStrata(wall, 128), {0, 0, 1}) / closed, 1, 2e-4L);
        View lamp{Kind::Rectangle, {-0.05f, 0, beside}, {0, -1, 0}, {1, 0, 0}, {0, 2, 0}, 0};
        o = R3(lamp.corner) - R3(lamp.P), a = lamp.edgeA, b = lamp.edgeB;
        closed = lambert({o, o + a, o + a + b, o + b}, {1, 0, 0});
        EXPECT_NEAR(estimate(lamp, sampleStrata(lamp, 128), {1, 0, 0}) / closed, 1, 2e-3L);
    }
}

TEST(ShapeSampling, SphereGivesItsIrradiance) {
    // VALIDATION C5, and the same form at all sizes: E = pi L (r/D)^2 cos.
    struct Case {
        float r, height, aside;
    };
    for (Case c : {Case{0.5f, 2, 0}, Case{0.5f, 2, 1}, Case{0.5f, 2, 3}, Case{0.5f, 0.51f, 0},
                   Case{0.5f, 0.6f, 0.1f}, Case{0.5f, 500, 500}, Case{1, 1.5f, 100}})
        for (float size : {1e-6f, 1.0f, 1e7f}) {
            float r = c.r * size;
            View view{
                Kind::Sphere, Vec3{c.aside, 0, 0} * size, Vec3{0, 0, c.height} * size, {}, {}, r};
            Real D = length(R3(view.corner) - R3(view.P)), s = r / D;
            Real closed = pi * s * s * view.corner.z / D;
            EXPECT_NEAR(estimate(view, sampleStrata(view, 128), {0, 0, 1}) / closed, 1, 1e-4L);
        }
    for (const View &view : insideSpheres()) {
        if (length(R3(view.P)) > 0.9999L * view.radius)
            continue;
        EXPECT_NEAR(estimate(view, sampleStrata(view, 256), {0, 0.6L, 0.8L}) / pi, 1, 1e-3L);
    }
}

TEST(ShapeSampling, NeighboursInTheSquareAreNeighboursOnTheShape) {
    int n = 64;
    for (View view : {View{Kind::Sphere, {0, 0, 0}, {0, 0, 3}, {}, {}, 1},
                      View{Kind::Sphere, {0, 0, 0.5f}, {0, 0, 0}, {}, {}, 1},
                      View{Kind::Rectangle, {0.3f, 0.4f, 0.5f}, {}, {1, 0, 0}, {0, 1, 0}, 0},
                      View{Kind::Triangle, {0.3f, 0.4f, 0.5f}, {}, {1, 0, 0}, {0, 1, 0}, 0}}) {
        std::vector<Vec3> p = sampleStrata(view, n).points;
        bool seamed = view.kind == Kind::Sphere && length(view.P - view.corner) < view.radius;
        for (int i = 0; i < n * n; ++i) {
            // From within, the square's rim becomes the pole behind, about which rings widen fast.
            bool rim = i % n == 0 || i % n >= n - 2 || i / n == 0 || i / n >= n - 2;
            if (rim && seamed)
                continue;
            Vec3 right = i % n + 1 < n ? p[i + 1] : p[i], above = i / n + 1 < n ? p[i + n] : p[i];
            EXPECT_LT(length(right - p[i]), 10.0f / float(n));
            EXPECT_LT(length(above - p[i]), 10.0f / float(n));
        }
    }
}

TEST(ShapeSampling, NothingIsToBeHadFromBrokenOrEdgeOnShapes) {
    float nan = std::numeric_limits<float>::quiet_NaN();
    for (Kind kind : {Kind::Rectangle, Kind::Triangle})
        for (View view : {View{kind, {5, 0.5f, 0}, {}, {1, 0, 0}, {0, 1, 0}, 0},
                          View{kind, {0.3f, 0.3f, 0}, {}, {1, 0, 0}, {0, 1, 0}, 0},
                          View{kind, {5, -2, -3}, {0, 0, 0}, {1, 0, -1}, {0.5f, -1, 0.5f}, 0},
                          View{kind, {0, 0, 1}, {}, {0, 0, 0}, {0, 1, 0}, 0},
                          View{kind, {nan, 0, 1}, {}, {1, 0, 0}, {0, 1, 0}, 0}})
            for (float pdf : sampleStrata(view, 4).pdf)
                EXPECT_EQ(pdf, 0);
    for (View view : {View{Kind::Sphere, {0, 0, 0}, {0, 0, 1}, {}, {}, 0},
                      View{Kind::Sphere, {0, 0, 0}, {0, 0, 1}, {}, {}, nan},
                      View{Kind::Sphere, {0, 0, 0}, {0, nan, 1}, {}, {}, 1},
                      View{Kind::Sphere, {0, 0, 0}, {0, 0, 1e20f}, {}, {}, 1e-20f}})
        for (float pdf : sampleStrata(view, 4).pdf)
            EXPECT_EQ(pdf, 0);
}

// SPDX-License-Identifier: Apache-2.0
// Lamps of every curved kind, whose elements are grouped: light samples and hits agree.
#include "world/scene/light_test_support.h"

#include "world/scene/source_geometry.h"
#include "world/scene/source_pieces.h"

#include <cmath>
#include <gtest/gtest.h>
#include <set>

namespace candela {
namespace {

/// Closed bodies, all of whose walls shine.
struct Body {
    const char *name;
    std::vector<ShapeRecord> shapes;
    std::vector<std::vector<float>> vertices; ///< "P" of the shapes that have it.
    Vec3 inside;
};

/// A cube whose bicubic sides bulge.
Body blownUpCube() {
    Body body{"patches", {}, {}, {0.2f, -0.1f, 0.3f}};
    for (int side = 0; side < 6; ++side) {
        std::vector<float> P;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                Vec3 p;
                p[side / 2] = side % 2 ? 1 : -1;
                p[(side / 2 + 1) % 3] = float(i) * 2 / 3 - 1;
                p[(side / 2 + 2) % 3] = float(j) * 2 / 3 - 1;
                p *= 1 + 0.2f * (3 - dot(p, p));
                P.insert(P.end(), {p.x, p.y, p.z});
            }
        body.shapes.push_back(PatchMeshRecord{true, 4, 4, false, false});
        body.vertices.push_back(P);
    }
    return body;
}

/// Triangles between rings of points on a lens: too many for sources of their own.
Body lens() {
    constexpr int rings = 8, around = 16;
    Body body{"polygons", {}, {}, {0.2f, -0.1f, 0.1f}};
    PolygonsRecord mesh;
    std::vector<float> P;
    for (int ring = 0; ring <= rings; ++ring)
        for (int k = 0; k < around; ++k) {
            const float phi = float(M_PI) * (float(ring) / rings - 0.5f);
            const float theta = 2 * float(M_PI) * float(k) / around;
            P.insert(P.end(), {std::cos(phi) * std::cos(theta), std::cos(phi) * std::sin(theta),
                               0.5f * std::sin(phi)});
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int k = 0; k < around; ++k) {
            const int a = ring * around + k, b = ring * around + (k + 1) % around;
            for (int corner : {a, b, b + around, a, b + around, a + around})
                mesh.vertices.push_back(corner);
        }
    mesh.loopCounts.assign(mesh.vertices.size() / 3, 1);
    mesh.vertexCounts.assign(mesh.vertices.size() / 3, 3);
    body.shapes.push_back(mesh), body.vertices.push_back(P);
    return body;
}

std::vector<Body> bodies() {
    return {
        {"can",
         {CylinderRecord{1, -1, 1, 360}, DiskRecord{-1, 1, 360}, DiskRecord{1, 1, 360}},
         {},
         {0.3f, 0.2f, -0.4f}},
        {"cone", {ConeRecord{2, 1, 360}, DiskRecord{0, 1, 360}}, {}, {0.1f, 0.2f, 0.5f}},
        {"hemisphere", {SphereRecord{1, 0, 1, 360}, DiskRecord{0, 1, 360}}, {}, {0.4f, 0, 0.2f}},
        {"paraboloid",
         {ParaboloidRecord{1, 0, 1.5f, 360}, DiskRecord{1.5f, 1, 360}},
         {},
         {0.1f, -0.3f, 0.9f}},
        {"hyperboloid",
         {HyperboloidRecord{{1, 0, -1}, {0.5f, 0.9f, 1}, 360}, DiskRecord{-1, 1, 360},
          DiskRecord{1, std::hypot(0.5f, 0.9f), 360}},
         {},
         {0.2f, 0.1f, 0.3f}},
        {"torus", {TorusRecord{1, 0.6f, 0, 360, 360}}, {}, {0.9f, 0.2f, 0.2f}},
        blownUpCube(),
        lens()};
}

void build(TestWorld &world, const Body &body) {
    world.options.named["render:integrator"] = {"integrator", {}, {}, {"path"}};
    world.attributes.surface = TestWorld::shader("glow", {TestWorld::numbers("intensity", {1})});
    for (std::size_t i = 0; i < body.shapes.size(); ++i) {
        std::vector<Parameter> variables;
        if (i < body.vertices.size())
            variables.push_back(
                TestWorld::variable("P", StorageClass::Vertex, ValueType::Point, body.vertices[i]));
        world.add(body.shapes[i], variables);
    }
}

struct Estimates {
    double byLight = 0, byHits = 0, balanced = 0;
};

/// Irradiance at P, normal N: by light samples, by rays uniform over the hemisphere, by both with
/// the balance heuristic.
class Estimator {
public:
    Estimator(const Scene &scene, int count)
        : scene_(scene), samples_(count), rays_(count), hits_(count), points_(count) {}

    Estimates at(Vec3 P, Vec3 N, unsigned seed) {
        P_ = P, N_ = N, sums_ = {};
        samples_.draw(seed, P);
        for (LightGroup group : scene_.lights().groupsInUse()) {
            scene_.lights().sample(group, samples_.query, samples_.out);
            addLightSamples();
        }
        addHits();
        const double n = samples_.query.count;
        return {sums_.byLight / n, sums_.byHits / n, sums_.balanced / n};
    }

private:
    static constexpr double uniform = 1 / (2 * M_PI);

    void aim(int i, Vec3 direction, float tMax) {
        for (int c = 0; c < 3; ++c)
            rays_.origin[c][i] = P_[c], rays_.direction[c][i] = direction[c];
        rays_.tMin[i] = 0, rays_.tMax[i] = tMax;
    }

    void addLightSamples() {
        const int count = rays_.count = samples_.query.count;
        const auto &out = samples_.out;
        for (int i = 0; i < count; ++i)
            aim(i, {out.L[0][i], out.L[1][i], out.L[2][i]}, 1);
        Planes<float> planes(colorSamples, count);
        float *transmittance[colorSamples] = {planes[0], planes[1], planes[2]};
        scene_.transmittance(rays_, transmittance);
        for (int i = 0; i < count; ++i) {
            const Vec3 L{out.L[0][i], out.L[1][i], out.L[2][i]};
            const double f =
                std::max(0.0f, dot(normalize(L), N_)) * out.value[0][i] * transmittance[0][i];
            const double pdf = out.pdfSolidAngle[i];
            if (f > 0)
                sums_.byLight += f / pdf, sums_.balanced += f / (pdf + uniform);
        }
    }

    void addHits() {
        const int count = rays_.count;
        for (int i = 0; i < count; ++i) {
            const float z = 1 - 2 * samples_.floats[5][i],
                        phi = 2 * float(M_PI) * samples_.floats[6][i];
            const float r = std::sqrt(1 - z * z);
            Vec3 w{r * std::cos(phi), r * std::sin(phi), z};
            aim(i, dot(w, N_) < 0 ? -w : w, INFINITY);
        }
        scene_.intersect(rays_, hits_, Coherence::Secondary);
        std::vector<int> order;
        for (int i = 0; i < count; ++i)
            if (hits_.shape[i] != noHit)
                order.push_back(i);
        const std::vector<float> pdf = densities(scene_, rays_, hits_, order, points_);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const int i = order[k];
            const Vec3 w{rays_.direction[0][i], rays_.direction[1][i], rays_.direction[2][i]};
            const double f = std::max(0.0f, dot(w, N_));
            sums_.byHits += f / uniform, sums_.balanced += f / (pdf[k] + uniform);
        }
    }

    const Scene &scene_;
    Samples samples_;
    RayBatch rays_;
    HitBatch hits_;
    ShadingPoints points_;
    Vec3 P_, N_;
    Estimates sums_;
};

std::pair<double, double> meanAndError(const std::vector<double> &values) {
    double sum = 0, squares = 0;
    for (double value : values)
        sum += value, squares += value * value;
    const double n = double(values.size()), mean = sum / n;
    return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1))};
}

void expectPi(const std::vector<double> &values, const char *what) {
    const auto [mean, error] = meanAndError(values);
    EXPECT_LT(error, 0.01 * M_PI) << what;
    EXPECT_NEAR(mean, M_PI, 5 * error + 1e-4) << what; // Student's t, 24 seeds: 5e-5.
}

TEST(LightPieces, RadianceInsideIsOneByEachStrategyAlone) {
    for (const Body &body : bodies()) {
        SCOPED_TRACE(body.name);
        TestWorld world;
        build(world, body);
        bool rendered = false;
        world.render([&](const Scene &scene) {
            rendered = true;
            Estimator estimator(scene, 4096);
            for (Vec3 N : {Vec3{0, 0, 1}, normalize(Vec3{1, -2, -1})}) {
                std::vector<double> byLight, byHits, balanced;
                for (unsigned seed = 1; seed <= 24; ++seed) {
                    const Estimates e = estimator.at(body.inside, N, seed);
                    byLight.push_back(e.byLight), byHits.push_back(e.byHits);
                    balanced.push_back(e.balanced);
                }
                expectPi(byLight, "light samples alone");
                expectPi(byHits, "hits alone");
                expectPi(balanced, "balanced");
            }
        });
        EXPECT_TRUE(rendered);
    }
}

/// Checks the samples of a group of lights; returns how many met what they were aimed at.
std::size_t compareDensities(const Scene &scene, LightGroup group, Vec3 inside) {
    Samples samples(512);
    samples.draw(9, inside);
    scene.lights().sample(group, samples.query, samples.out);
    RayBatch rays(512);
    HitBatch hits(512);
    rays.count = 512;
    for (int i = 0; i < 512; ++i) {
        for (int c = 0; c < 3; ++c)
            rays.origin[c][i] = inside[c], rays.direction[c][i] = samples.out.L[c][i];
        rays.tMin[i] = 0, rays.tMax[i] = INFINITY;
    }
    scene.intersect(rays, hits, Coherence::Secondary);
    ShadingPoints points(512);
    std::vector<int> order;
    for (int i = 0; i < 512; ++i)
        if (hits.shape[i] != noHit && std::abs(hits.t[i] - 1) < 1e-3f)
            order.push_back(i);
    const std::vector<float> pdf = densities(scene, rays, hits, order, points);
    for (std::size_t k = 0; k < order.size(); ++k) {
        const float ratio = pdf[k] / samples.out.pdfSolidAngle[order[k]];
        EXPECT_NEAR(ratio, 1, 2e-3) << k; // The hit may be on the next piece's element.
    }
    return order.size();
}

/// The very density, wherever a ray towards a sample meets what was aimed at.
TEST(LightPieces, SamplesAndHitsTellOneDensity) {
    for (const Body &body : bodies()) {
        SCOPED_TRACE(body.name);
        TestWorld world;
        build(world, body);
        world.render([&](const Scene &scene) {
            std::size_t met = 0;
            for (LightGroup group : scene.lights().groupsInUse())
                met += compareDensities(scene, group, body.inside);
            EXPECT_GT(met, 150u); // The torus hides much of itself.
        });
    }
}

/// Spheres that instances leave spheres, and such as they make ellipsoids of.
TEST(LightPieces, InstancesOfSpheresShine) {
    for (float stretch : {1.0f, 2.0f}) {
        SCOPED_TRACE(stretch);
        TestWorld world;
        world.options.named["render:integrator"] = {"integrator", {}, {}, {"path"}};
        world.attributes.surface =
            TestWorld::shader("glow", {TestWorld::numbers("intensity", {1})});
        world.addObject(SphereRecord{0.5f, -0.5f, 0.5f, 360},
                        {scaling(2, 2, 2 * stretch) * translation(0, 1, 4),
                         scaling(1, stretch, 1) * translation(0, -2, 3)});
        world.render([&](const Scene &scene) {
            Estimator estimator(scene, 1 << 14);
            std::vector<double> byLight, byHits;
            for (unsigned seed = 1; seed <= 16; ++seed) {
                const Estimates e = estimator.at({0, 0, 0}, {0, 0, 1}, seed);
                byLight.push_back(e.byLight), byHits.push_back(e.byHits);
            }
            auto [light, lightError] = meanAndError(byLight);
            auto [hits, hitsError] = meanAndError(byHits);
            EXPECT_NEAR(light, hits, 5 * (lightError + hitsError));
            EXPECT_LT(lightError, 0.005 * light);
            if (stretch == 1) { // Pi R^2 cos / d^2 each.
                const double truth = M_PI * (4 / std::pow(17, 1.5) + 0.25 * 3 / std::pow(13, 1.5));
                EXPECT_NEAR(light, truth, 5 * lightError + 1e-5);
            }
        });
    }
}

LightElement triangle(Vec3 corner, Vec3 edgeA, Vec3 edgeB) {
    LightElement element;
    element.form = LightElement::Form::Triangle;
    element.corner = corner, element.edgeA = edgeA, element.edgeB = edgeB;
    return element;
}

TEST(LightPieces, AreFewCompactAndOfLikeArea) {
    // Two parallel square sheets of 128 x 128 triangles, finer on one side, whose normals differ.
    std::vector<LightElement> sheet;
    for (int side : {-1, 1})
        for (int i = 0; i < 128; ++i)
            for (int j = 0; j < 64; ++j) {
                const float x = std::pow(float(i) / 128, 2.0f), y = float(j) / 64;
                const float dx = std::pow(float(i + 1) / 128, 2.0f) - x, dy = 1 / 64.0f;
                const Vec3 a{dx, 0, 0}, b{0, dy * float(side), 0};
                sheet.push_back(triangle({x, y, 0.001f * float(side)}, a, b));
                sheet.push_back(triangle({x + dx, y + b.y, 0.001f * float(side)}, -a, -b));
            }
    const Pieces pieces = cutToPieces(sheet);
    ASSERT_EQ(pieces.ends.size(), std::size_t(mostPieces));
    EXPECT_EQ(std::set(pieces.order.begin(), pieces.order.end()).size(), sheet.size());
    std::uint32_t begin = 0;
    for (std::uint32_t end : pieces.ends) {
        double area = 0, up = 0;
        Box3 box;
        for (; begin < end; ++begin) {
            const LightElement &e = sheet[pieces.order[begin]];
            area += areaOf(e), up += cross(e.edgeA, e.edgeB).z > 0 ? areaOf(e) : 0;
            box.add(e.corner);
        }
        EXPECT_LT(area, 4 * 2.0 / mostPieces);
        EXPECT_GT(area, 2.0 / mostPieces / 4);
        EXPECT_TRUE(up == 0 || up == area) << "sides mixed: " << up / area;
        EXPECT_LT(std::max(box.extent().x, box.extent().y), 0.45);
    }
    EXPECT_TRUE(cutToPieces({}).ends.empty());
    EXPECT_EQ(cutToPieces(std::span(sheet).first(5)).ends.size(), 1u);
}

} // namespace
} // namespace candela

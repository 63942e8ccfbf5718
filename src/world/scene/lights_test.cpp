// SPDX-License-Identifier: Apache-2.0
// Light sampling against closed forms (VALIDATION C) and its own densities.
#include "world/scene/light_test_support.h"

#include "world/scene/light_categories.h"

#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace candela {
namespace {

/// Irradiance at P with normal N, unoccluded, from n samples.
double irradiance(const Scene &scene, Samples &samples, unsigned seed, Vec3 P, Vec3 N) {
    samples.draw(seed, P);
    scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
    double sum = 0;
    for (int i = 0; i < samples.query.count; ++i) {
        if (samples.out.light[i] == 0)
            continue;
        Vec3 L{samples.out.L[0][i], samples.out.L[1][i], samples.out.L[2][i]};
        double cosine = std::max(0.0f, dot(normalize(L), N));
        double pdf = samples.out.pdfSolidAngle[i];
        sum += samples.out.value[0][i] * cosine * (pdf > 0 ? 1 / pdf : M_PI);
    }
    return sum / samples.query.count;
}

/// 16 seeds: the mean lies within five standard errors of the truth, and these are small.
void expectIrradiance(const Scene &scene, Vec3 P, Vec3 N, double truth) {
    Samples samples(1 << 14);
    double sum = 0, squares = 0;
    for (unsigned seed = 1; seed <= 16; ++seed) {
        double E = irradiance(scene, samples, seed, P, N);
        sum += E, squares += E * E;
    }
    double mean = sum / 16, variance = std::max(squares / 16 - mean * mean, 0.0) / 15;
    EXPECT_NEAR(mean, truth, 5 * std::sqrt(variance) + 2e-6 * truth);
    EXPECT_LT(std::sqrt(variance), 0.006 * truth);
}

Parameter intensity(float value) { return TestWorld::numbers("intensity", {value}); }
const Vec3 up{0, 0, 1};

TEST(Lights, C1PointLight) {
    TestWorld world;
    world.addLight("pointlight", {intensity(1), TestWorld::numbers("from", {0, 0, 2})});
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        expectIrradiance(scene, {0, 0, 0}, up, 0.25);
        expectIrradiance(scene, {2, 0, 0}, up, 0.08838834764831845);
    });
}

TEST(Lights, C2DistantLight) {
    TestWorld world;
    world.addLight("distantlight", {intensity(3), TestWorld::numbers("to", {0, -3, -4})});
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) { expectIrradiance(scene, {0, 0, 0}, up, 3 * 0.8); });
}

TEST(Lights, C3Disc) {
    for (bool emitter : {false, true}) {
        TestWorld world;
        if (emitter) {
            world.options.named["render:integrator"] = {"integrator", {}, {}, {"path"}};
            world.attributes.surface = TestWorld::shader("glow", {intensity(1)});
        } else {
            world.addLight("arealight", {intensity(1)}, LightUnits::Si, true);
        }
        world.attributes.flipNormal = true;
        world.add(DiskRecord{1, 1, 360});
        world.render([](const Scene &scene) {
            expectIrradiance(scene, {0, 0, 0}, up, 1.5707963267948966);
            expectIrradiance(scene, {0.5f, 0, 0}, up, 1.375963);
            expectIrradiance(scene, {2, 0, 0}, up, 0.1658334);
        });
    }
}

TEST(Lights, C4Square) {
    TestWorld world;
    world.addLight("arealight", {intensity(1)}, LightUnits::Si, true);
    world.attributes.flipNormal = true;
    world.addPolygon({{-0.5f, -0.5f, 1}, {0.5f, -0.5f, 1}, {0.5f, 0.5f, 1}, {-0.5f, 0.5f, 1}});
    world.render([](const Scene &scene) {
        expectIrradiance(scene, {0, 0, 0}, up, 0.7522747);
        expectIrradiance(scene, {0.5f, 0.5f, 0}, up, 0.4352099);
        expectIrradiance(scene, {2, 0, 0}, up, 0.0437426);
    });
}

TEST(Lights, C5Sphere) {
    TestWorld world;
    world.addLight("arealight", {intensity(1)}, LightUnits::Si, true);
    world.transform = translation(0, 0, 2);
    world.add(SphereRecord{0.5f, -0.5f, 0.5f, 360});
    world.render([](const Scene &scene) {
        expectIrradiance(scene, {0, 0, 0}, up, 0.1963495);
        expectIrradiance(scene, {1, 0, 0}, up, 0.1404963);
        expectIrradiance(scene, {3, 0, 0}, up, 0.0335123);
    });
}

/// What a lamp may bring decides how often it is chosen: three times the power, three times as
/// often, and the nearer one more.
TEST(Lights, PowersDecideHowOftenALightIsChosen) {
    TestWorld world;
    for (float power : {1.0f, 3.0f})
        world.addLight("pointlight", {intensity(power), TestWorld::numbers("from", {0, 0, 2})});
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        Samples samples(1 << 15);
        samples.draw(3, {0, 0, 0});
        scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
        int second = 0;
        for (int i = 0; i < samples.query.count; ++i)
            second += samples.out.light[i] == 2;
        EXPECT_NEAR(second / double(samples.query.count), 0.75, 5 * 0.5 / std::sqrt(1 << 15));
        EXPECT_TRUE(scene.lights().isOn(0, 1));
        EXPECT_TRUE(scene.lights().isOn(0, 0));
    });
}

/// One lamp on, 99 off: every sample is the one lamp's.
TEST(Lights, SurfacesDrawOnlyFromLightsThatAreOn) {
    TestWorld world;
    for (int i = 0; i < 100; ++i)
        world.addLight("pointlight", {intensity(1), TestWorld::numbers("from", {float(i), 0, 2})});
    world.attributes.lightsOn = {37};
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.attributes.lightsOn = {};
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        Samples samples(1024);
        samples.draw(3, {0, 0, 0});
        for (int i = 512; i < 1024; ++i)
            samples.integers[0][i] = 1;
        scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
        for (int i = 0; i < 1024; ++i)
            EXPECT_EQ(samples.out.light[i], i < 512 ? 38 : 0);
    });
}

/// Rays over the whole sphere: what hits report as density is a density.
TEST(Lights, DensitiesOfHitsIntegrateToOne) {
    TestWorld world;
    world.options.named["render:integrator"] = {"integrator", {}, {}, {"path"}};
    world.attributes.surface = TestWorld::shader("glow", {intensity(1)});
    world.transform = translation(0, 0.3f, 3);
    world.add(SphereRecord{1, -1, 1, 360});
    world.transform = translation(0, 3, -1);
    world.add(CylinderRecord{0.5f, -1, 1, 360});
    world.transform = Matrix4{};
    world.attributes.surface = TestWorld::shader("glow", {intensity(5)});
    world.addPolygon({{-3, -1, -1}, {-3, 1, -1}, {-3, 1, 1}, {-3, -1, 1}});
    world.addPolygon({{3, -1, -1}, {3, 1, -1}, {3.5f, 1, 1}});
    world.render([](const Scene &scene) {
        constexpr int rows = 1024, columns = 2048;
        RayBatch rays(columns);
        HitBatch hits(columns);
        ShadingPoints points(columns);
        double sum = 0;
        rays.count = columns;
        for (int row = 0; row < rows; ++row) {
            for (int i = 0; i < columns; ++i) {
                double z = 1 - 2 * (row + 0.5) / rows, phi = 2 * M_PI * (i + 0.5) / columns;
                double r = std::sqrt(1 - z * z);
                rays.origin[0][i] = rays.origin[1][i] = rays.origin[2][i] = 0;
                rays.direction[0][i] = float(r * std::cos(phi));
                rays.direction[1][i] = float(r * std::sin(phi));
                rays.direction[2][i] = float(z), rays.tMin[i] = 0, rays.tMax[i] = INFINITY;
            }
            scene.intersect(rays, hits, Coherence::Secondary);
            for (int code = 0; code < scene.codeCount(); ++code) {
                std::vector<int> order;
                for (int i = 0; i < columns; ++i)
                    if (hits.shape[i] != noHit && scene.codeOf(hits, i) == code)
                        order.push_back(i);
                if (!order.empty())
                    for (float pdf : densities(scene, rays, hits, order, points))
                        sum += pdf;
            }
        }
        // The cylinder's far side is hidden by its near one.
        const double total = sum * 4 * M_PI / (double(rows) * columns);
        Samples samples(1 << 15);
        samples.draw(5, {0, 0, 0});
        scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
        int hidden = 0;
        rays.count = 1;
        for (int i = 0; i < samples.query.count; ++i) {
            Vec3 L{samples.out.L[0][i], samples.out.L[1][i], samples.out.L[2][i]};
            for (int c = 0; c < 3; ++c)
                rays.origin[c][0] = 0, rays.direction[c][0] = L[c];
            rays.tMin[0] = 0, rays.tMax[0] = 0.999f;
            scene.intersect(rays, hits, Coherence::Secondary);
            hidden += samples.out.light[i] != 0 && hits.shape[0] != noHit;
        }
        const double share = hidden / double(samples.query.count);
        EXPECT_NEAR(total, 1 - share, 0.005 + 5 * std::sqrt(share / samples.query.count));
    });
}

/// The same density from both sides: samples and hits agree where they meet.
TEST(Lights, SamplesAndHitsAgree) {
    TestWorld world;
    world.addLight("arealight", {intensity(7)}, LightUnits::Si, true);
    world.transform = translation(0, 0, 2);
    world.add(SphereRecord{0.5f, -0.5f, 0.5f, 360});
    world.render([](const Scene &scene) {
        Samples samples(64);
        samples.draw(9, {0, 0, 0});
        scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
        RayBatch rays(64);
        HitBatch hits(64);
        rays.count = 64;
        for (int i = 0; i < 64; ++i) {
            for (int c = 0; c < 3; ++c)
                rays.direction[c][i] = samples.out.L[c][i];
            rays.tMin[i] = 0, rays.tMax[i] = INFINITY;
        }
        scene.intersect(rays, hits, Coherence::Secondary);
        int compared = 0;
        for (int i = 0; i < 64; ++i) {
            if (hits.shape[i] == noHit || samples.out.value[0][i] == 0)
                continue;
            ShadingPoints point(1);
            const float pdf = densities(scene, rays, hits, {i}, point)[0];
            EXPECT_NEAR(pdf / samples.out.pdfSolidAngle[i], 1, 1e-5);
            Planes<float> planes(colorSamples, 1);
            float *radiance[colorSamples] = {planes[0], planes[1], planes[2]};
            scene.lights().emission(scene.codeOf(hits, i), point, radiance);
            EXPECT_FLOAT_EQ(radiance[0][0], 7);
            EXPECT_FLOAT_EQ(samples.out.value[0][i], 7);
            ++compared;
        }
        EXPECT_GT(compared, 60);
    });
}

TEST(Lights, ClassicLightsHandOverTheirNumber) {
    TestWorld world;
    world.addLight("distantlight", {intensity(1), TestWorld::numbers("to", {0, 0, -1})},
                   LightUnits::Classic);
    world.addLight("ambientlight", {intensity(0.25f)}, LightUnits::Classic);
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        Samples samples(4);
        samples.draw(1, {0, 0, 0});
        scene.lights().sampleOne(0, samples.query, samples.out);
        EXPECT_EQ(samples.out.value[0][3], 1);
        EXPECT_EQ(samples.out.pdfSolidAngle[3], 0);
        EXPECT_EQ(samples.out.castsShadow[3], 0) << "classic lights shine through everything";
        EXPECT_TRUE(std::isinf(samples.out.distance[3]));
        scene.lights().sampleOne(1, samples.query, samples.out);
        EXPECT_EQ(samples.out.light[0], 0);
        Planes<float> planes(colorSamples, 4);
        float *ambient[colorSamples] = {planes[0], planes[1], planes[2]};
        ASSERT_TRUE(scene.lights().hasAmbient());
        scene.lights().ambient(samples.query, ambient);
        EXPECT_EQ(ambient[1][2], 0.25f);
    });
}

/// The start of the ray may lie further from the point than a direction is long.
TEST(Lights, DistantLightComesFromOneDirection) {
    for (const float length : {1e-3f, 1.0f, 1e4f}) {
        TestWorld world;
        world.addLight("distantlight",
                       {intensity(1), TestWorld::numbers("to", {0, 0.6f * length, -0.8f * length})},
                       LightUnits::Si);
        world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
        world.render([&](const Scene &scene) {
            for (const float offset : {0.0f, 1e-3f, 1.0f, 1e5f}) {
                Samples samples(1);
                samples.draw(1, {0, 0, offset});
                Planes<float> point(3, 1);
                samples.query.Ps = {point[0], point[1], point[2]};
                scene.lights().sampleOne(0, samples.query, samples.out);
                ASSERT_NE(samples.out.light[0], 0);
                const Vec3 L{samples.out.L[0][0], samples.out.L[1][0], samples.out.L[2][0]};
                EXPECT_NEAR(L.y / L.z, -0.75f, 1e-6f) << length << " " << offset;
                EXPECT_GT(L.z, 0);
            }
        });
    }
}

TEST(Lights, FaultyAndBareLightsAreDark) {
    TestWorld world;
    world.addLight("missing", {});
    world.addLight("arealight", {intensity(1)}, LightUnits::Si, true);
    world.render([](const Scene &scene) {
        EXPECT_TRUE(scene.lights().groupsInUse().empty());
        EXPECT_EQ(scene.lights().count(), 2);
        Samples samples(2);
        samples.draw(1, {0, 0, 0});
        scene.lights().sample(lampGroup, samples.query, samples.out);
        EXPECT_EQ(samples.out.light[0], 0);
        EXPECT_EQ(samples.out.value[0][0], 0);
    });
}

TEST(Lights, Categories) {
    LightTags plain, a{{"a"}, false, false}, both{categoryWords("a, b"), false, false};
    LightTags nonDiffuse{{}, true, false};
    EXPECT_TRUE(categoryAccepts("", plain));
    EXPECT_FALSE(categoryAccepts("a,-b", plain));
    EXPECT_TRUE(categoryAccepts("a,-b", a));
    EXPECT_FALSE(categoryAccepts("a,-b", both));
    EXPECT_TRUE(categoryAccepts("-b", plain));
    EXPECT_FALSE(categoryAccepts("!diffuse", nonDiffuse));
    EXPECT_TRUE(categoryAccepts("!specular", nonDiffuse));
}

} // namespace
} // namespace candela

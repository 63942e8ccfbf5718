// SPDX-License-Identifier: Apache-2.0
// Lights that shine elsewhere are chosen rarely, but may be chosen; many lights are known as well
// as few.
#include "world/scene/light_test_support.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

struct Drawn {
    double irradiance = 0, error = 0; ///< At the origin, normal +z, and its standard error.
    double dark = 0;                  ///< The share of samples that bring nothing.
};

Drawn draw(const Scene &scene, int count) {
    Samples samples(count);
    samples.draw(7, {0, 0, 0});
    scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
    double sum = 0, squares = 0;
    Drawn drawn;
    for (int i = 0; i < count; ++i) {
        const Vec3 L{samples.out.L[0][i], samples.out.L[1][i], samples.out.L[2][i]};
        const double pdf = samples.out.pdfSolidAngle[i];
        const double value =
            samples.out.value[0][i] * std::max(0.0f, normalize(L).z) * (pdf > 0 ? 1 / pdf : M_PI);
        sum += value, squares += value * value;
        drawn.dark += value == 0;
    }
    drawn.irradiance = sum / count, drawn.dark /= count;
    drawn.error = std::sqrt((squares / count - drawn.irradiance * drawn.irradiance) / count);
    return drawn;
}

/// Small squares on a sphere about the origin, which all face down or all but every second one,
/// and the irradiance below.
double addSquares(TestWorld &world, int count, bool everySecondTurned) {
    constexpr float size = 0.05f;
    double irradiance = 0;
    for (int i = 0; i < count; ++i) {
        const float z = 0.4f + 0.6f * (float(i) + 0.5f) / float(count), phi = 2.4f * float(i);
        const float r = std::sqrt(1 - z * z);
        const Vec3 way{r * std::cos(phi), r * std::sin(phi), z};
        Vec3 s, t;
        orthonormalBasis(way, s, t);
        const bool turned = everySecondTurned && i % 2;
        if (turned)
            std::swap(s, t);
        s *= size, t *= size;
        const Vec3 a = way * 3 - (s + t) * 0.5f;
        world.addPolygon({a, a + s, a + s + t, a + t});
        irradiance += turned ? 0 : double(size) * size / 9 * z;
    }
    return irradiance;
}

/// Squares shine to one side, whichever `flipNormal` makes it.
TEST(LightDirections, LampsThatFaceAwayCostAlmostNothing) {
    for (bool turned : {false, true}) {
        SCOPED_TRACE(turned);
        int bright = 0;
        for (bool flip : {false, true}) {
            TestWorld world;
            world.addLight("arealight", {TestWorld::numbers("intensity", {1})}, LightUnits::Si,
                           true);
            world.attributes.flipNormal = flip;
            const double truth = addSquares(world, 60, turned);
            world.render([&](const Scene &scene) {
                const Drawn drawn = draw(scene, 1 << 14);
                if (drawn.irradiance == 0 && !turned)
                    return;
                ++bright;
                EXPECT_LT(drawn.dark, turned ? 0.04 : 1e-3);
                if (!flip || !turned) { // The other half hangs at other heights.
                    EXPECT_NEAR(drawn.irradiance, truth, 0.02 * truth + 5 * drawn.error);
                }
            });
        }
        EXPECT_EQ(bright, turned ? 2 : 1);
    }
}

/// What looked dark may be chosen all the same: hits on backs have a density.
TEST(LightDirections, BacksKeepAProbability) {
    TestWorld world;
    world.addLight("arealight", {TestWorld::numbers("intensity", {1})}, LightUnits::Si, true);
    addSquares(world, 60, true);
    world.render([&](const Scene &scene) {
        RayBatch rays(60);
        HitBatch hits(60);
        ShadingPoints points(60);
        std::vector<int> order;
        rays.count = 60;
        for (int i = 0; i < 60; ++i) {
            const float z = 0.4f + 0.6f * (float(i) + 0.5f) / 60, phi = 2.4f * float(i);
            const float r = std::sqrt(1 - z * z);
            rays.direction[0][i] = r * std::cos(phi), rays.direction[1][i] = r * std::sin(phi);
            rays.direction[2][i] = z, rays.tMin[i] = 0, rays.tMax[i] = INFINITY;
            order.push_back(i);
        }
        scene.intersect(rays, hits, Coherence::Secondary);
        const std::vector<float> pdf = densities(scene, rays, hits, order, points);
        const float most = *std::max_element(pdf.begin(), pdf.end());
        int rare = 0;
        for (float density : pdf) {
            EXPECT_GT(density, 0);
            rare += density < 0.05f * most;
        }
        EXPECT_EQ(rare, 30);
    });
}

TEST(LightDirections, BeamsThatMissCostAlmostNothing) {
    TestWorld world;
    double truth = 0;
    for (int i = 0; i < 100; ++i) {
        const float phi = 2.4f * float(i), r = 0.3f;
        const Vec3 from{r * std::cos(phi), r * std::sin(phi), 2};
        const Vec3 to = i % 2 ? Vec3{0, 0, 0} : Vec3{from.x, from.y, 4};
        world.addLight("spotlight", {TestWorld::numbers("intensity", {1}),
                                     TestWorld::numbers("from", {from.x, from.y, from.z}),
                                     TestWorld::numbers("to", {to.x, to.y, to.z})});
        truth += i % 2 ? 2 / std::pow(double(dot(from, from)), 1.5) : 0;
    }
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([&](const Scene &scene) {
        const Drawn drawn = draw(scene, 1 << 14);
        EXPECT_LT(drawn.dark, 0.04);
        EXPECT_NEAR(drawn.irradiance, truth, 5 * drawn.error + 1e-4 * truth);
        EXPECT_LT(drawn.error, 0.01 * truth);
    });
}

/// 40,000 lights, asked 16 times each: their powers decide all the same.
TEST(LightDirections, ManyLightsAreChosenByPower) {
    TestWorld world;
    constexpr int count = 40000;
    for (int i = 0; i < count; ++i)
        world.addLight("pointlight", {TestWorld::numbers("intensity", {i % 2 ? 3.0f : 1.0f}),
                                      TestWorld::numbers("from", {0.001f * float(i % 7), 0, 2})});
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        Samples samples(1 << 15);
        samples.draw(3, {0, 0, 0});
        scene.lights().sample(scene.lights().groupsInUse().front(), samples.query, samples.out);
        int strong = 0;
        for (int i = 0; i < samples.query.count; ++i)
            strong += samples.out.light[i] % 2 == 0;
        EXPECT_NEAR(strong / double(samples.query.count), 0.75, 5 * 0.5 / std::sqrt(1 << 15));
    });
}

} // namespace
} // namespace candela

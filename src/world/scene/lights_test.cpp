// SPDX-License-Identifier: Apache-2.0
// Light sampling against closed forms (VALIDATION C) and its own densities.
#include "world/scene/test_world.h"

#include "world/scene/light_categories.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace candela {
namespace {

struct Samples {
    explicit Samples(int n) : floats(14, n), integers(2, n), shadow(1, n) {
        query.count = n;
        query.P = {floats[0], floats[1], floats[2]};
        query.lightSet = integers[0];
        query.time = floats[3];
        query.choice = floats[4];
        query.position = {floats[5], floats[6]};
        out.L = {floats[7], floats[8], floats[9]};
        out.distance = floats[10], out.pdfSolidAngle = floats[11];
        out.light = integers[1], out.castsShadow = shadow[0];
        for (int c = 0; c < colorSamples; ++c)
            out.value[c] = values[c];
    }
    void draw(unsigned seed, Vec3 P) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> uniform(0, 1);
        for (int i = 0; i < query.count; ++i) {
            for (int c = 0; c < 3; ++c)
                floats[c][i] = P[c];
            for (int plane = 4; plane <= 6; ++plane)
                floats[plane][i] = std::min(uniform(random), 0x1.fffffep-1f);
        }
    }
    Planes<float> floats;
    Planes<std::int32_t> integers;
    Planes<std::uint8_t> shadow;
    Planes<float> values{colorSamples, 1 << 15};
    LightQuery query;
    LightSamples out;
};

/// Irradiance at P with normal N, unoccluded, from n samples.
double irradiance(const Scene &scene, Samples &samples, unsigned seed, Vec3 P, Vec3 N) {
    samples.draw(seed, P);
    scene.sampleLights(samples.query, samples.out);
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

TEST(Lights, PowersDecideHowOftenALightIsChosen) {
    TestWorld world;
    for (float power : {1.0f, 3.0f})
        world.addLight("pointlight", {intensity(power), TestWorld::numbers("from", {power, 0, 2})});
    world.addPolygon({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}});
    world.render([](const Scene &scene) {
        Samples samples(1 << 15);
        samples.draw(3, {0, 0, 0});
        scene.sampleLights(samples.query, samples.out);
        int second = 0;
        for (int i = 0; i < samples.query.count; ++i)
            second += samples.out.light[i] == 2;
        double expected = 0.05 / 2 + 0.95 * 0.75;
        EXPECT_NEAR(second / double(samples.query.count), expected, 5 * 0.5 / std::sqrt(1 << 15));
        EXPECT_TRUE(scene.lightIsOn(0, 1));
        EXPECT_TRUE(scene.lightIsOn(0, 0));
    });
}

/// Rays over the whole sphere: what hits report as density is a density.
TEST(Lights, DensitiesOfHitsIntegrateToOne) {
    TestWorld world;
    world.options.named["render:integrator"] = {"integrator", {}, {}, {"path"}};
    world.attributes.surface = TestWorld::shader("glow", {intensity(1)});
    world.transform = translation(0, 0.3f, 3);
    world.add(SphereRecord{1, -1, 1, 360});
    world.transform = Matrix4{};
    world.attributes.surface = TestWorld::shader("glow", {intensity(5)});
    world.addPolygon({{-3, -1, -1}, {-3, 1, -1}, {-3, 1, 1}, {-3, -1, 1}});
    world.render([](const Scene &scene) {
        constexpr int rows = 512, columns = 1024;
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
            std::vector<int> order;
            for (int i = 0; i < columns; ++i)
                if (hits.shape[i] != noHit)
                    order.push_back(i);
            scene.shadingPoints(rays, hits, order.data(), int(order.size()), points);
            for (int k = 0; k < points.count; ++k) {
                auto vec3 = [&](ShaderInput input) {
                    return Vec3{points.input(int(input))[k], points.input(int(input) + 1)[k],
                                points.input(int(input) + 2)[k]};
                };
                Vec3 I = vec3(ShaderInput::I);
                double cosine = std::abs(dot(normalize(I), normalize(vec3(ShaderInput::Ng))));
                sum += points.lightPdfArea[k] * dot(I, I) / cosine;
            }
        }
        // Half of the sphere's density lies on its far side, which rays from here never hit.
        double toSphere = sum * 4 * M_PI / (rows * columns);
        double spherePower = 4 * M_PI * 2 * M_PI, wallPower = 5 * 4 * 2 * M_PI;
        double sphereShare = 0.025 + 0.95 * spherePower / (spherePower + wallPower);
        double distance = std::sqrt(0.09 + 9), seen = (1 - 1 / distance) / 2;
        EXPECT_NEAR(toSphere, 1 - sphereShare * (1 - seen), 0.004);
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
        scene.sampleLights(samples.query, samples.out);
        RayBatch rays(64);
        HitBatch hits(64);
        rays.count = 64;
        for (int i = 0; i < 64; ++i) {
            rays.direction[0][i] = samples.out.L[0][i], rays.direction[1][i] = samples.out.L[1][i];
            rays.direction[2][i] = samples.out.L[2][i], rays.tMin[i] = 0, rays.tMax[i] = INFINITY;
        }
        scene.intersect(rays, hits, Coherence::Secondary);
        int compared = 0;
        for (int i = 0; i < 64; ++i) {
            if (hits.shape[i] == noHit || samples.out.value[0][i] == 0)
                continue;
            ShadingPoints point(1);
            scene.shadingPoints(rays, hits, &i, 1, point);
            auto vec3 = [&](ShaderInput input) {
                return Vec3{point.input(int(input))[0], point.input(int(input) + 1)[0],
                            point.input(int(input) + 2)[0]};
            };
            Vec3 I = vec3(ShaderInput::I);
            float cosine = std::abs(dot(normalize(I), normalize(vec3(ShaderInput::Ng))));
            if (cosine < 0.2f)
                continue;
            EXPECT_NEAR(point.lightPdfArea[0] * dot(I, I) / cosine / samples.out.pdfSolidAngle[i],
                        1, 0.02);
            Planes<float> planes(colorSamples, 1);
            float *radiance[colorSamples] = {planes[0], planes[1], planes[2]};
            scene.emission(scene.codeOf(hits.shape[i]), point, radiance);
            EXPECT_FLOAT_EQ(radiance[0][0], 7);
            EXPECT_FLOAT_EQ(samples.out.value[0][i], 7);
            ++compared;
        }
        EXPECT_GT(compared, 10);
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
        scene.sampleLight(0, samples.query, samples.out);
        EXPECT_EQ(samples.out.value[0][3], 1);
        EXPECT_EQ(samples.out.pdfSolidAngle[3], 0);
        EXPECT_EQ(samples.out.castsShadow[3], 0) << "classic lights shine through everything";
        EXPECT_TRUE(std::isinf(samples.out.distance[3]));
        scene.sampleLight(1, samples.query, samples.out);
        EXPECT_EQ(samples.out.light[0], 0);
        Planes<float> planes(colorSamples, 4);
        float *ambient[colorSamples] = {planes[0], planes[1], planes[2]};
        ASSERT_TRUE(scene.hasAmbient());
        scene.ambient(4, samples.query.P, samples.query.lightSet, ambient);
        EXPECT_EQ(ambient[1][2], 0.25f);
    });
}

TEST(Lights, FaultyAndBareLightsAreDark) {
    TestWorld world;
    world.addLight("missing", {});
    world.addLight("arealight", {intensity(1)}, LightUnits::Si, true);
    world.render([](const Scene &scene) {
        EXPECT_FALSE(scene.hasLights());
        EXPECT_EQ(scene.lightCount(), 2);
        Samples samples(2);
        samples.draw(1, {0, 0, 0});
        scene.sampleLights(samples.query, samples.out);
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

// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_choice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

using namespace candela;

namespace {

constexpr float pi = std::numbers::pi_v<float>;

EmitterBound lamp(Vec3 at, float power) { return {{at, at}, {}, pi, pi, power}; }

struct Chosen {
    std::int32_t source;
    float probability;
    double u;
};

Chosen choose(const LightChoice &choice, Vec3 p, Vec3 n, double u) {
    const float *P[3] = {&p.x, &p.y, &p.z}, *N[3] = {&n.x, &n.y, &n.z};
    Chosen c{-1, 0, u};
    choice.choose(1, P, N, &c.u, &c.source, &c.probability);
    return c;
}

float probability(const LightChoice &choice, Vec3 p, Vec3 n, std::int32_t source) {
    const float *P[3] = {&p.x, &p.y, &p.z}, *N[3] = {&n.x, &n.y, &n.z};
    float result = -1;
    choice.probability(1, P, N, &source, &result);
    return result;
}

/// Sources 1, 3, 5... are lamps, 0 and 2 a dome and a sun, 4 is off.
LightChoice mixed() {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<EmitterBound> bounds;
    std::vector<std::int32_t> sources;
    for (int i = 0; i < 20; ++i) {
        bounds.push_back(
            lamp({uniform(random), uniform(random), uniform(random)}, uniform(random)));
        sources.push_back(2 * i + 1);
    }
    InfiniteLight dome{0, 0.3f, true, {}, 1}, sun{2, 0.8f, false, {0, 0, 1}, 0.99f};
    return LightChoice(bounds, sources, std::vector{dome, sun}, 50);
}

} // namespace

TEST(LightChoice, OneSourceHasProbabilityOneAndKeepsU) {
    std::vector<EmitterBound> one{lamp({1, 2, 3}, 0.7f)}, none;
    std::vector<std::int32_t> five{5}, noSource;
    std::vector<InfiniteLight> sun{{7, 0.3f, false, {0, 0, 1}, 0.9f}}, noInfinite;
    std::vector<InfiniteLight> blackSun{{7, 0, true, {}, 1}};
    LightChoice choices[] = {
        {one, five, noInfinite, 9}, {none, noSource, sun, 9}, {one, five, blackSun, 9}};
    for (int c = 0; c < 3; ++c)
        for (double u : {0.0, 0.1, 1 / 3.0, 0x1.fffffffffffffp-1}) {
            std::int32_t source = c == 1 ? 7 : 5;
            Chosen chosen = choose(choices[c], {0.1f, 0.3f, 0.7f}, {0, 0.6f, 0.8f}, u);
            EXPECT_EQ(chosen.source, source);
            EXPECT_EQ(chosen.probability, 1);
            EXPECT_EQ(chosen.u, u);
            EXPECT_EQ(probability(choices[c], {0.1f, 0.3f, 0.7f}, {0, 0.6f, 0.8f}, source), 1);
        }
}

/// A dome and a lamp: where scattered rays find the dome, all samples are the lamp's; from outside
/// the dome is a lamp like the other, whatever rays there are.
TEST(LightChoice, WhatSurroundsAPointIsLeftToScatteredRays) {
    const std::vector<EmitterBound> one{lamp({1, 2, 3}, 0.7f)}, none;
    const std::vector<std::int32_t> five{5}, noSource;
    const std::vector<InfiniteLight> noInfinite;
    const SurroundingLight dome{2, {{{-4, -4, -4}, {4, 4, 4}}, {}, pi, pi, 9}, {0, 0, 0}, 4};
    const LightChoice both(one, five, noInfinite, 9, dome),
        alone(none, noSource, noInfinite, 9, dome);
    const Vec3 within{0.1f, 0.3f, 0.7f}, outside{0, 0, -9}, up{0, 0.6f, 0.8f},
        down{0, -0.6f, -0.8f};
    struct Case {
        const LightChoice &choice;
        Vec3 P, N;
        float scattered;
        double ofDome, ofLamp; ///< Below 0: any share.
    };
    for (const Case &test : {Case{both, within, up, 1, 0, 1},
                             {both, within, up, 0, .5, .5},
                             {both, within, down, 0, 1, 0},
                             {both, within, down, 1, 0, 1},
                             {alone, within, up, 0, 1, 0},
                             {alone, within, up, 1, 0, 0},
                             {both, outside, up, 1, -1, -1},
                             {both, outside, up, 0, -1, -1},
                             {alone, outside, up, 1, 1, 0},
                             {alone, outside, up, 0, 1, 0},
                             {alone, {0, 0, -4}, up, 1, 1, 0}}) {
        const float *P[3] = {&test.P.x, &test.P.y, &test.P.z};
        const float *N[3] = {&test.N.x, &test.N.y, &test.N.z};
        double share[2];
        for (int k : {0, 1}) {
            const std::int32_t source = k == 0 ? 2 : 5;
            float probability;
            test.choice.probability(1, P, N, &source, &probability, &test.scattered);
            share[k] = probability;
            const double expected = k == 0 ? test.ofDome : test.ofLamp;
            if (expected >= 0) {
                EXPECT_EQ(probability, &test.choice == &both || k == 0 ? expected : 0);
            } else {
                EXPECT_GT(probability, 0.01f);
            }
        }
        int found[2] = {0, 0};
        for (double u = 0.0005; u < 1; u += 0.001) {
            double rest = u;
            std::int32_t source;
            float probability;
            test.choice.choose(1, P, N, &rest, &source, &probability, &test.scattered);
            found[0] += source == 2, found[1] += source == 5;
            if (source >= 0) {
                EXPECT_EQ(probability, share[source == 2 ? 0 : 1]);
            }
            EXPECT_TRUE(rest >= 0 && rest < 1);
        }
        for (int k : {0, 1}) // A single lamp is picked whether it shines there or not.
            if (share[k] > 0) {
                EXPECT_NEAR(found[k], 1000 * share[k], 1);
            }
    }
}

TEST(LightChoice, ChoicesHaveTheirProbabilityAndLeaveUUniform) {
    LightChoice choice = mixed();
    int total = 100000;
    for (Vec3 n : {Vec3{}, Vec3{0, 0.6f, 0.8f}, Vec3{0, 0, -1}}) {
        Vec3 p{0.4f, 0.5f, 0.6f};
        std::vector<int> counts(50), lowHalf(50);
        int nothing = 0;
        for (int i = 0; i < total; ++i) {
            Chosen c = choose(choice, p, n, (i + 0.5) / total);
            ASSERT_TRUE(c.u >= 0 && c.u < 1);
            if (c.source < 0) {
                EXPECT_EQ(c.probability, 0);
                ++nothing;
                continue;
            }
            ASSERT_EQ(c.probability, probability(choice, p, n, c.source));
            ++counts[c.source], lowHalf[c.source] += c.u < 0.5;
        }
        double sum = 0;
        for (int s = 0; s < 50; ++s) {
            double expected = probability(choice, p, n, s);
            sum += expected;
            EXPECT_NEAR(counts[s], expected * total, 2);
            EXPECT_NEAR(lowHalf[s], expected * total / 2, 2);
        }
        EXPECT_NEAR(sum, 1 - double(nothing) / total, 1e-4);
    }
}

TEST(LightChoice, EqualIrradiancesHaveEqualShares) {
    // 4 pi W in all directions and pi W from a Lambertian give 1 W/m^2 at 1 m, as the sun does;
    // 2 pi W where both sides shine.
    EmitterBound isotropic = lamp({0, 0, 1}, 4 * pi);
    EmitterBound lambertian{{{0, 0, 1}, {0, 0, 1}}, {0, 0, -1}, 0, pi / 2, pi};
    EmitterBound leaf{{{0, 0, 1}, {0, 0, 1}}, {0, 0, 1}, 0, pi, 2 * pi};
    for (EmitterBound bound : {isotropic, lambertian, leaf}) {
        std::vector<InfiniteLight> sun{{1, 1, false, {0, 0, 1}, 1}};
        LightChoice choice(std::vector{bound}, std::vector{0}, sun, 2);
        EXPECT_NEAR(probability(choice, {}, {0, 0, 1}, 0), 0.5f, 1e-6f);
        EXPECT_NEAR(probability(choice, {}, {0, 0, 1}, 1), 0.5f, 1e-6f);
    }
}

TEST(LightChoice, NeitherSideFallsBelowATenth) {
    for (float irradiance : {1e-30f, 1e-3f, 1.0f, 1e30f})
        for (float power : {1e-30f, 1.0f, 1e30f}) {
            LightChoice choice(std::vector{lamp({0, 0, 1}, power)}, std::vector{0},
                               std::vector{InfiniteLight{1, irradiance, true, {}, 1}}, 2);
            float finite = probability(choice, {}, {0, 0, 1}, 0);
            EXPECT_GE(finite, 0.0999999f);
            EXPECT_LE(finite, 0.9000001f);
            EXPECT_NEAR(probability(choice, {}, {0, 0, 1}, 1), 1 - finite, 1e-6f);
            EXPECT_EQ(probability(choice, {}, {0, 0, -1}, 1), 1); // The lamp is below.
        }
}

TEST(LightChoice, SunsAreCulledOnlyWhereAllOfThemIsBelowTheHorizon) {
    for (float halfAngle : {0.0f, 0.3f, pi / 2}) {
        std::vector<InfiniteLight> sun{{0, 1, false, {0, 0, 1}, std::cos(halfAngle)}};
        LightChoice choice(std::vector<EmitterBound>{}, std::vector<std::int32_t>{}, sun, 1);
        for (float angle = 0; angle <= pi; angle += 0.01f) {
            float p = probability(choice, {}, {std::sin(angle), 0, std::cos(angle)}, 0);
            float above = pi / 2 + halfAngle - angle;
            EXPECT_TRUE(p == 1 || above <= 0) << angle << ' ' << halfAngle;
            EXPECT_TRUE(p == 0 || above >= -0.01f) << angle << ' ' << halfAngle;
        }
        EXPECT_EQ(probability(choice, {}, {}, 0), 1);
        EXPECT_EQ(choose(choice, {}, {0, 0, -1}, 0.5).source, halfAngle > 1 ? 0 : -1);
    }
}

TEST(LightChoice, StrangersAndBrokenLightsAreNeverChosen) {
    LightChoice choice = mixed();
    for (std::int32_t source : {-1, 4, 6, 49, 50, 1 << 30, -(1 << 30)})
        EXPECT_EQ(probability(choice, {}, {}, source), 0);
    float nan = std::numeric_limits<float>::quiet_NaN();
    for (float broken : {nan, -1.0f, Box3::infinity, 0.0f}) {
        LightChoice none(std::vector{lamp({}, broken)}, std::vector{0},
                         std::vector{InfiniteLight{1, broken, true, {}, 1}}, 2);
        for (double u : {0.0, 0.5, 0.99, double(nan), 2.0}) {
            EXPECT_EQ(choose(none, {1, 0, 0}, {}, u).source, -1);
            Chosen c = choose(choice, {nan, 0, 0}, {nan, 0, 0}, u);
            EXPECT_TRUE(c.source >= 0 && c.probability > 0 && c.probability <= 1);
            EXPECT_EQ(c.probability, probability(choice, {nan, 0, 0}, {nan, 0, 0}, c.source));
        }
    }
    LightChoice empty({}, {}, {}, 0);
    EXPECT_EQ(choose(empty, {}, {}, 0.5).source, -1);
    EXPECT_EQ(probability(empty, {}, {}, 0), 0);
}

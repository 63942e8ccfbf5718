// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree.h"

#include <gtest/gtest.h>

#include <random>

using namespace candela;

TEST(LightTree, ProbabilitiesAreThoseOfTheChoiceAndSumToOne) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(0, 1);
    std::vector<EmitterBound> emitters(1000);
    for (EmitterBound &e : emitters) {
        Vec3 at{uniform(random), uniform(random), uniform(random)};
        e = {{at, at}, {}, 0, 3.2f, uniform(random)};
    }
    LightTree tree(emitters);
    float p[3] = {0.3f, 0.4f, 0.5f}, zero = 0;
    const float *P[3] = {p, p + 1, p + 2}, *N[3] = {&zero, &zero, &zero};
    double sum = 0;
    for (std::int32_t e = 0; e < tree.size(); ++e) {
        float probability;
        tree.probability(1, P, N, &e, &probability);
        EXPECT_GT(probability, 0);
        sum += probability;
    }
    EXPECT_NEAR(sum, 1, 1e-5);
    for (int i = 0; i < 1000; ++i) {
        double u = (i + 0.5) / 1000;
        std::int32_t e;
        float chosen, again;
        tree.choose(1, P, N, &u, &e, &chosen);
        tree.probability(1, P, N, &e, &again);
        EXPECT_EQ(chosen, again);
        EXPECT_TRUE(u >= 0 && u < 1);
    }
}

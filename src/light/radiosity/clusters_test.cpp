// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/clusters.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::radiosity {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

Vec3 direction(int k, int count) { // Spread evenly.
    const float z = 1 - (2 * float(k) + 1) / float(count), turn = float(k) * 2.399963f;
    const float r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

TEST(Harmonics, AreOrthonormal) {
    constexpr int count = 20000;
    double sums[harmonics][harmonics] = {};
    for (int k = 0; k < count; ++k) {
        const auto Y = harmonicsOf(direction(k, count));
        for (int a = 0; a < harmonics; ++a)
            for (int b = 0; b < harmonics; ++b)
                sums[a][b] += double(Y[a]) * Y[b] * 4 * pi / count;
    }
    for (int a = 0; a < harmonics; ++a)
        for (int b = 0; b < harmonics; ++b)
            EXPECT_NEAR(sums[a][b], a == b ? 1 : 0, 1e-3) << a << " " << b;
}

/// Light from one direction: the cosine, within what nine harmonics know of it.
TEST(Directional, TellsTheClampedCosine) {
    Directional light;
    light.add(Vec3{0, 0, 1}, Color{1, 2, 0});
    double largest = 0, mean = 0;
    constexpr int count = 1000;
    for (int k = 0; k < count; ++k) {
        const Vec3 N = direction(k, count);
        const Color E = light.cosineAt(N);
        largest = std::max(largest, double(std::fabs(E[0] - std::max(N.z, 0.0f))));
        mean += double(E[0]) / count;
        EXPECT_FLOAT_EQ(E[1], 2 * E[0]);
        EXPECT_EQ(E[2], 0);
    }
    EXPECT_LT(largest, 0.1);
    EXPECT_NEAR(mean, 0.25, 0.01); // A quarter of all normals' area is seen from afar.
}

} // namespace
} // namespace candela::radiosity

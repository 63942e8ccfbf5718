// SPDX-License-Identifier: Apache-2.0
#include "world/lights/emission_lobes.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela {
namespace {

constexpr double sphere = 4 * std::numbers::pi;

struct Lobes {
    const char *name;
    std::vector<EmissionCone> cones;
};

class EmissionLobesOf : public testing::TestWithParam<Lobes> {};

/// Sum over a grid of equal areas.
template <class Value> double overSphere(Value value) {
    constexpr int rows = 600, columns = 600;
    double sum = 0;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double z = 1 - 2 * (row + .5) / rows, r = std::sqrt(1 - z * z);
            const double turn = 2 * std::numbers::pi * (column + .5) / columns;
            sum += value(Vec3{float(r * std::cos(turn)), float(r * std::sin(turn)), float(z)});
        }
    return sum * sphere / (double(rows) * columns);
}

TEST_P(EmissionLobesOf, haveADensityOfUnitIntegralThatIsNowhere0) {
    const EmissionLobes lobes(GetParam().cones);
    EXPECT_NEAR(overSphere([&](Vec3 direction) {
                    EXPECT_GT(lobes.pdf(direction), 0);
                    return lobes.pdf(direction);
                }),
                1, 5e-3);
}

TEST_P(EmissionLobesOf, areSampledAsTheirDensitySays) {
    // Moments of the samples against the integrals of the density.
    const EmissionLobes lobes(GetParam().cones);
    constexpr int side = 400;
    double x = 0, y = 0, zz = 0;
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            const Vec3 d = lobes.sample((i + .5) / side, (k + .5) / side);
            EXPECT_NEAR(length(d), 1, 1e-5);
            x += d.x, y += d.y, zz += double(d.z) * d.z;
        }
    constexpr double count = double(side) * side;
    EXPECT_NEAR(x / count, overSphere([&](Vec3 d) { return d.x * lobes.pdf(d); }), 5e-3);
    EXPECT_NEAR(y / count, overSphere([&](Vec3 d) { return d.y * lobes.pdf(d); }), 5e-3);
    EXPECT_NEAR(zz / count, overSphere([&](Vec3 d) { return d.z * d.z * lobes.pdf(d); }), 5e-3);
}

const Vec3 slanting = normalize(Vec3{1, 2, -3});

INSTANTIATE_TEST_SUITE_P(
    All, EmissionLobesOf,
    testing::Values(Lobes{"None", {}}, Lobes{"OfNoImportance", {{slanting, 40, 0, 0}}},
                    Lobes{"Spot", {{slanting, 60, 0, 1}}}, Lobes{"Down", {{{0, 0, -1}, 180, 1, 2}}},
                    Lobes{"Wide", {{{0, 1, 0}, 300, 2, 1}}},
                    Lobes{"Two", {{slanting, 90, 3, 1}, {{-1, 0, 0}, 120, 0, 3}}}),
    [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela

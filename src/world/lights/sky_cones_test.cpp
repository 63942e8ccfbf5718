// SPDX-License-Identifier: Apache-2.0
#include "world/lights/sky_cones.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace candela {
namespace {

constexpr double pi = std::numbers::pi;

Vec3 onSphere(double a, double b) {
    const double z = 1 - 2 * a, r = std::sqrt(std::max(0.0, 1 - z * z));
    return {float(r * std::cos(2 * pi * b)), float(r * std::sin(2 * pi * b)), float(z)};
}

/// What solar() draws from one cone (language/ir/lower).
Vec3 drawn(const EmissionCone &cone, double x, double y) {
    const double cosine = 1 - x * (1 - std::cos(cone.angle * pi / 360));
    const double sine = std::sqrt(1 - cosine * cosine), sign = cone.axis.z < 0 ? -1 : 1;
    const double a = -1 / (sign + cone.axis.z), b = double(cone.axis.x) * cone.axis.y * a;
    const double c = sine * std::cos(2 * pi * y), s = sine * std::sin(2 * pi * y);
    const Vec3 n = cone.axis;
    return {float(cosine * n.x + c * (1 + sign * n.x * n.x * a) + s * b),
            float(cosine * n.y + c * sign * b + s * (sign + n.y * n.y * a)),
            float(cosine * n.z - c * sign * n.x - s * n.y)};
}

struct Sky {
    const char *name;
    std::vector<EmissionCone> cones;
    double wideShare = 1; ///< Of the importance, that of cones with a width.
};

const Vec3 down{0, 0, -1}, up{0, 0, 1}, tilted = normalize(Vec3{-.6f, .3f, -.4f});
const Sky skies[] = {
    {"Everywhere", {{down, 360, 0, 1}}},
    {"HalfSphere", {{down, 180, 0, 1}}},
    {"UpsideDown", {{up, 180, 3, 2}}},
    {"Tilted", {{tilted, 70, 0, 5}}},
    {"DiscOfTheSun", {{tilted, .53f, 0, 1}}},
    {"SkyAndDisc", {{down, 180, 0, 1}, {tilted, 5, 0, 1}}},
    {"DiscOfSmallImportance", {{down, 180, 0, 1}, {tilted, 4, 0, .01f}}},
    {"Overlapping", {{down, 180, 0, 1}, {tilted, 90, 7, 3}, {up, 120, 0, .5f}}},
    {"SkyAndSunOfOneDirection", {{down, 180, 0, 3}, {tilted, 0, 0, 1}}, .75},
    {"NothingOfSecond", {{down, 180, 0, 1}, {up, 180, 0, 0}}},
};

class SkyConesOf : public testing::TestWithParam<Sky> {};

TEST_P(SkyConesOf, DrawAgainWhatTheyHaveDrawn) {
    const Sky &sky = GetParam();
    const SkyCones cones(sky.cones);
    ASSERT_TRUE(cones.isWide());
    for (const EmissionCone &cone : sky.cones) {
        if (!(cone.angle > 0 && cone.importance > 0))
            continue;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 direction =
                drawn(cone, std::fmod((i + .5) * .7548776662466927, 1), (i + .5) / 1000);
            const auto [x, y] = cones.numbersFor(direction);
            ASSERT_GE(x, 0);
            ASSERT_LT(x, 1);
            ASSERT_GE(y, 0);
            ASSERT_LT(y, 1);
            // The numbers choose one of the cones, and a place in it.
            double total = 0, low = 0;
            for (const EmissionCone &each : sky.cones)
                total += each.importance;
            const EmissionCone *chosen = nullptr;
            for (const EmissionCone &each : sky.cones) {
                if (!chosen && x * total < low + each.importance)
                    chosen = &each;
                if (!chosen)
                    low += each.importance;
            }
            ASSERT_NE(chosen, nullptr);
            const Vec3 again = drawn(*chosen, (x * total - low) / chosen->importance, y);
            EXPECT_LT(length(again - direction), 2e-3 * std::sin(chosen->angle * pi / 720))
                << i << ": " << x << " " << y;
            EXPECT_NEAR(cones.pdfOfDrawn(x, direction), cones.pdf(direction),
                        1e-6 * cones.pdf(direction));
        }
    }
}

/// Half a million directions, even over each cone, weighted by what others would have drawn.
TEST_P(SkyConesOf, HaveDensitiesThatAddUpToOne) {
    const Sky &sky = GetParam();
    const SkyCones cones(sky.cones);
    constexpr int count = 500000;
    double sum = 0;
    for (int i = 0; i < count; ++i)
        sum += cones.pdf(onSphere((i + .5) / count, (i + .5) * .6180339887498949));
    double widest = 0;
    for (const EmissionCone &cone : sky.cones)
        widest = std::max(widest, double(cone.angle));
    if (sky.cones.size() == 1 && widest < 1) // Too few of them.
        sum = cones.pdf(sky.cones[0].axis) * 2 * pi * (1 - std::cos(widest * pi / 360)) / (4 * pi) *
              count;
    EXPECT_NEAR(sum / count * 4 * pi, sky.wideShare, sky.cones.size() > 1 ? .02 : 1e-3);
}

TEST(SkyCones, OfOneDirectionAreMetByNoRay) {
    const std::vector<EmissionCone> sun{{down, 0, 0, 1}};
    EXPECT_FALSE(SkyCones(sun).isWide());
    const std::vector<EmissionCone> both{{down, 180, 0, 3}, {tilted, 0, 0, 1}};
    const SkyCones cones(both);
    EXPECT_EQ(cones.pdfOfDrawn(.9f, tilted), 0);
    EXPECT_GT(cones.pdfOfDrawn(.7f, tilted), 0);
}

INSTANTIATE_TEST_SUITE_P(All, SkyConesOf, testing::ValuesIn(skies),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace candela

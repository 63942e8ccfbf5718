// SPDX-License-Identifier: Apache-2.0
#include "world/shading/volume_lights.h"

#include "language/runtime/shader_abi.h"

#include <gtest/gtest.h>
#include <vector>

namespace candela {
namespace {

/// Asks as code of that width does, for four lanes from lane `first` on.
class Asker {
public:
    explicit Asker(VolumeLights &lights) : lights_(lights) {}

    /// What gatherlight gives: by lane, the number and how many samples.
    std::vector<float> gather(int first, const std::vector<Vec3> &points, std::uint32_t mask) {
        cells_.clear();
        for (int c = 0; c < 3; ++c)
            for (const Vec3 &P : points)
                cells_.push_back({.number = P[c]});
        lights_.gather(call(first, int(points.size()), mask, 2));
        return results_;
    }
    /// What lightsample gives to one lane.
    std::vector<float> sample(float number, float turn, float category) {
        cells_ = {{.number = number}, {.number = turn}, {.number = category}};
        lights_.sample(call(0, 1, 1, 8));
        return results_;
    }
    ShaderArgs args;

private:
    ServiceCall call(int first, int lanes, std::uint32_t mask, int results) {
        results_.assign(std::size_t(results * lanes), 0.0f);
        return {&args, nullptr, first, lanes, mask, cells_.data(), results_.data()};
    }
    VolumeLights &lights_;
    std::vector<ServiceCell> cells_;
    std::vector<float> results_;
};

const Vec3 a{1, 2, 3}, b{4, 5, 6}, c{7, 8, 9};

TEST(VolumeLights, AreNotedAndThenTold) {
    VolumeLights lights;
    Asker asker(lights);
    lights.begin(8);
    EXPECT_EQ(asker.gather(2, {a, b}, 3), (std::vector<float>{0, 1, 0, 0}));
    EXPECT_EQ(asker.gather(2, {a, c}, 3), (std::vector<float>{0, 2, 0, 0}));
    ASSERT_EQ(lights.points(), 3);
    EXPECT_EQ(lights.lane(2), 3);
    EXPECT_EQ(lights.ordinal(2), 1);
    EXPECT_EQ(lights.point(2), c);

    lights.light(2);
    lights.set(0, 2, {0, 0, 1}, {.5f, .25f, 0}, 1);
    lights.set(1, 2, {0, 1, 0}, {1, 1, 1}, 2);
    lights.beginRun();
    EXPECT_EQ(asker.gather(3, {c}, 1), (std::vector<float>{2, 2}));
    EXPECT_EQ(asker.gather(3, {b}, 1), (std::vector<float>{1, 2})) << "in any order";
    EXPECT_EQ(asker.sample(2, 0, -1), (std::vector<float>{1, 0, 0, 1, .5f, .25f, 0, 1}));
    EXPECT_EQ(asker.sample(0, 0, -1)[0], 0) << "a sample without light";

    EXPECT_EQ(asker.gather(3, {a}, 1), (std::vector<float>{3, 0})) << "what waits is dark";
    lights.light(2);
    EXPECT_EQ(asker.sample(2, 1, -1)[4], 1) << "what was lit stays so";
}

TEST(VolumeLights, HearByCategory) {
    VolumeLights lights;
    Asker asker(lights);
    lights.begin(1);
    asker.gather(0, {a}, 1);
    lights.light(1);
    lights.set(0, 0, {0, 0, 1}, {1, 1, 1}, 2);
    const std::uint8_t accepts[] = {1, 1, 0, /* and in the second category */ 0, 0, 1};
    asker.args.categoryAccepts = accepts, asker.args.lightCount = 2;
    EXPECT_EQ(asker.sample(0, 0, -1)[0], 1);
    EXPECT_EQ(asker.sample(0, 0, 0)[0], 0);
    EXPECT_EQ(asker.sample(0, 0, 1)[0], 1);
}

TEST(VolumeLights, AreOfLanesThatAskAndOfSoManyPoints) {
    VolumeLights lights;
    Asker asker(lights);
    lights.begin(4);
    asker.gather(0, {a, b, c}, 5);
    EXPECT_EQ(lights.points(), 2);
    for (int k = 0; k < 2 * VolumeLights::mostPoints; ++k)
        asker.gather(1, {{float(k), 0, 0}}, 1);
    EXPECT_EQ(lights.points(), 2 + VolumeLights::mostPoints);
    EXPECT_TRUE(lights.hasRefused());
    lights.begin(4);
    EXPECT_EQ(lights.points(), 0);
    EXPECT_FALSE(lights.hasRefused());
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/media.h"

#include <gtest/gtest.h>
#include <vector>

namespace candela {
namespace {

constexpr std::int32_t air = 9;
const SurfaceMedia ball{.atmosphere = air, .interior = 1};
const SurfaceMedia water{.atmosphere = air, .interior = 2};
const SurfaceMedia shell{.atmosphere = air, .interior = 3};
const SurfaceMedia core{.atmosphere = air, .interior = 4};
const SurfaceMedia roof{.atmosphere = air, .exterior = 5};
const SurfaceMedia sheet{.atmosphere = air};

/// How a ray crosses, or leaves on the side that it came from.
enum class Way { In, Out, OffOutside, OffInside };

struct Step {
    const SurfaceMedia &surface;
    Way way;
};

struct Case {
    const char *name;
    std::vector<Step> steps;
    std::int32_t medium; ///< Afterwards, on the way to something with the atmosphere `air`.
};

MediaAround after(const std::vector<Step> &steps) {
    MediaAround around;
    for (const auto &[surface, way] : steps)
        around = around.beyond(surface, way == Way::Out || way == Way::OffInside,
                               way == Way::In || way == Way::OffInside);
    return around;
}

TEST(Media, FollowTheSidesThatRaysPass) {
    const Case cases[] = {
        {"from the eye", {}, air},
        {"in a ball", {{ball, Way::In}}, 1},
        {"reflected inside", {{ball, Way::In}, {ball, Way::OffInside}}, 1},
        {"through a ball", {{ball, Way::In}, {ball, Way::Out}}, air},
        {"off a ball", {{ball, Way::OffOutside}}, air},
        {"a ball in water", {{water, Way::In}, {ball, Way::In}}, 1},
        {"out of the ball", {{water, Way::In}, {ball, Way::In}, {ball, Way::Out}}, 2},
        {"bodies that overlap", {{water, Way::In}, {ball, Way::In}, {water, Way::Out}}, 1},
        {"another substance at the other face",
         {{water, Way::In}, {ball, Way::In}, {shell, Way::Out}},
         2},
        {"the same substance twice", {{ball, Way::In}, {ball, Way::In}, {ball, Way::Out}}, 1},
        {"three deep", {{water, Way::In}, {ball, Way::In}, {shell, Way::In}, {shell, Way::Out}}, 1},
        {"four deep and back: the outermost is forgotten",
         {{water, Way::In},
          {ball, Way::In},
          {shell, Way::In},
          {core, Way::In},
          {core, Way::Out},
          {shell, Way::Out},
          {ball, Way::Out}},
         air},
        {"a sheet in water", {{water, Way::In}, {sheet, Way::In}}, 2},
        {"a sheet of the other orientation", {{water, Way::In}, {sheet, Way::Out}}, 2},
        {"the eye in a body", {{ball, Way::OffInside}}, 1},
        {"the eye in a body, out of it", {{ball, Way::Out}}, air},
        {"off a roof", {{roof, Way::OffOutside}}, 5},
        {"a sheet over a roof", {{roof, Way::OffOutside}, {sheet, Way::Out}}, 5},
        {"off a roof and something else", {{roof, Way::OffOutside}, {sheet, Way::OffOutside}}, air},
        {"under a roof", {{roof, Way::In}}, air},
        {"out from under a roof", {{roof, Way::Out}}, 5},
    };
    for (const Case &c : cases)
        EXPECT_EQ(after(c.steps).towardsAir(air), c.medium) << c.name;
}

TEST(Media, OfASegmentIsTheInteriorWhereItsEndIsMetFromInside) {
    EXPECT_EQ(MediaAround().towards(ball, true), 1);
    EXPECT_EQ(MediaAround().towards(ball, false), air);
    EXPECT_EQ(MediaAround().towards(sheet, true), air);
    EXPECT_EQ(after({{water, Way::In}}).towards(ball, false), 2);
    EXPECT_EQ(after({{roof, Way::OffOutside}}).towards(sheet, true), 5);
}

TEST(Media, StandInTwoWords) {
    const MediaAround around = after({{water, Way::In}, {ball, Way::In}, {shell, Way::In}});
    EXPECT_EQ(MediaAround(around.inner(), around.outer()), around);
    EXPECT_EQ(MediaAround(0, 0), MediaAround());
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Object definitions, their instances, and motion blocks.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

TEST_F(State, instancesTakeAttributesAndPlaceOfTheirTime) {
    state.worldBegin(at);
    state.color(at, Color(1, 0, 0));
    state.objectBegin(at, {"1"});
    state.translate(at, 0, 1, 0);
    sphere();
    state.objectEnd(at);
    EXPECT_TRUE(primitives().empty());
    state.color(at, Color(0, 0, 1));
    state.translate(at, 5, 0, 0);
    state.objectInstance(at, {"1"});
    state.scale(at, 2, 2, 2);
    state.objectInstance(at, {"1"});
    sphere();
    ASSERT_EQ(primitives().size(), 3u);
    EXPECT_EQ(primitives()[0].attributes->color, Color(0, 0, 1));
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{5, 1, 0}));
    EXPECT_EQ(primitives()[1].place(0, 0, 0), (Vec3{5, 2, 0}));
    EXPECT_EQ(primitives()[2].place(0, 0, 0), (Vec3{5, 0, 0})); // Nothing leaks out.
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, transformInAnObjectIsRelativeToTheInstance) {
    state.worldBegin(at);
    state.objectBegin(at, {"o"});
    state.transformBegin(at);
    state.transform(at, translation(0, 0, 3));
    sphere();
    state.transformEnd(at);
    state.identity(at);
    sphere();
    state.objectEnd(at);
    state.translate(at, 1, 0, 0);
    state.objectInstance(at, {"o"});
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{1, 0, 3}));
    EXPECT_EQ(primitives()[1].place(0, 0, 0), (Vec3{1, 0, 0}));
}

TEST_F(State, shadingAttributesInAnObjectAreWarnedAboutAndIgnored) {
    state.worldBegin(at);
    state.objectBegin(at, {"o"});
    state.color(at, Color(0, 1, 0));
    state.reverseOrientation(at); // Part of the shape, so it counts.
    sphere();
    state.objectEnd(at);
    state.objectInstance(at, {"o"});
    sphere();
    EXPECT_EQ(warnings(), 1);
    EXPECT_EQ(primitives()[0].attributes->color, Color(1));
    EXPECT_TRUE(primitives()[0].attributes->flipNormal);
    EXPECT_FALSE(primitives()[1].attributes->flipNormal);
}

TEST_F(State, objectsMayHoldInstancesButNotThemselves) {
    state.objectBegin(at, {"a"});
    sphere();
    state.objectInstance(at, {"a"});
    state.objectEnd(at);
    EXPECT_TRUE(says("no object 'a'"));
    state.objectBegin(at, {"b"});
    state.translate(at, 1, 0, 0);
    state.objectInstance(at, {"a"});
    state.objectInstance(at, {"a"});
    state.objectEnd(at);
    state.objectBegin(at, {"a"}); // "b" keeps the first.
    state.objectEnd(at);
    state.worldBegin(at);
    state.objectInstance(at, {"b"});
    ASSERT_EQ(primitives().size(), 2u);
    EXPECT_EQ(primitives()[1].place(0, 0, 0).x, 1);
    state.objectInstance(at, {"c"});
    EXPECT_EQ(errors(), 2);
}

TEST_F(State, chainsOfObjectsHaveALimit) {
    state.objectBegin(at, {"o"});
    sphere();
    state.objectEnd(at);
    for (int i = 0; i < 1000; ++i) {
        state.objectBegin(at, {"o"});
        state.objectInstance(at, {"o"});
        state.objectEnd(at);
    }
    EXPECT_GT(errors(), 0);
    EXPECT_TRUE(says("nested more than"));
}

TEST_F(State, blocksInObjectsMatch) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.objectBegin(at, {"o"});
    state.attributeEnd(at); // Does not reach out of the object.
    EXPECT_EQ(errors(), 1);
    state.attributeBegin(at);
    state.translate(at, 1, 0, 0);
    sphere();
    state.objectEnd(at); // Closes the block inside.
    EXPECT_EQ(errors(), 2);
    state.objectInstance(at, {"o"});
    state.attributeEnd(at);
    state.worldEnd(at);
    EXPECT_EQ(errors(), 2);
    EXPECT_EQ(primitives().size(), 1u);
}

// Each object holds the one before it twice.
TEST_F(State, objectsThatGrowWithoutMeasureAreRefused) {
    state.worldBegin(at);
    for (int i = 0; i < 40; ++i) {
        state.objectBegin(at, {std::to_string(i)});
        for (int copy = 0; copy < 2 && i > 0; ++copy)
            state.objectInstance(at, {std::to_string(i - 1)});
        state.objectEnd(at);
    }
    state.objectInstance(at, {"39"});
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(says("come to more than 10000000 requests"));
}

// No object is too large, but all of them together are.
TEST_F(State, instancesThatGrowWithoutMeasureAreRefused) {
    state.worldBegin(at);
    for (int i = 0; i < 20; ++i) {
        state.objectBegin(at, {std::to_string(i)});
        for (int copy = 0; copy < 2 && i > 0; ++copy)
            state.objectInstance(at, {std::to_string(i - 1)});
        state.objectEnd(at);
    }
    for (int copy = 0; copy < 20; ++copy)
        state.objectInstance(at, {"19"});
    EXPECT_EQ(errors(), 11);
    state.worldEnd(at);
    state.worldBegin(at);
    state.objectInstance(at, {"19"});
    EXPECT_EQ(errors(), 11);
}

TEST_F(State, motionBlocksShowTheFirstTime) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 1, 0, 0);
    state.translate(at, 9, 0, 0);
    state.motionEnd(at);
    sphere();
    EXPECT_EQ(primitives()[0].place(0, 0, 0).x, 1);
    EXPECT_EQ(warnings(), 1);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 1, 0, 0);
    state.rotate(at, 9, 0, 0, 1);
    state.motionEnd(at);
    EXPECT_TRUE(says("expected Translate, found Rotate"));
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, motionInObjectsIsTheFirstTimeToo) {
    state.worldBegin(at);
    state.objectBegin(at, {"o"});
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 1, 0, 0);
    state.translate(at, 9, 0, 0);
    state.motionEnd(at);
    sphere();
    state.objectEnd(at);
    state.objectInstance(at, {"o"});
    ASSERT_EQ(primitives().size(), 1u);
    EXPECT_EQ(primitives()[0].place(0, 0, 0).x, 1);
}

TEST_F(State, unclosedMotionBlocksDoNotSwallowTheWorld) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 1, 0, 0);
    state.worldEnd(at);
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(builder.worlds.back().ended);
}

} // namespace candela::testing

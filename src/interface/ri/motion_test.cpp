// SPDX-License-Identifier: Apache-2.0
// Motion blocks about transformations: where things are at a time.
#include "interface/ri/graphics_state_fixture.h"
#include "interface/ri/transform_motion.h"

#include <cmath>
#include <functional>

namespace candela::testing {

namespace {

Vec3 placeAt(const MotionTransform &transform, double time, Vec3 point) {
    return transformPoint(
        transform.motion ? transform.motion->at(time).rounded() : transform.matrix, point);
}

void expectNear(Vec3 found, Vec3 wanted) {
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(found[axis], wanted[axis], 1e-6) << axis;
}

} // namespace

TEST_F(State, requestsMoveByTheirParameters) {
    struct Row {
        const char *name;
        std::function<void(GraphicsState &, const SourceLocation &, int)> sample;
        Vec3 point, half; ///< Where the point is half-way between two samples.
    };
    const float h = std::sqrt(0.5f);
    const Row rows[] = {
        {"Translate",
         [](auto &to, auto &at, int k) { to.translate(at, float(2 * k), 0, 4); },
         {1, 0, 0},
         {2, 0, 4}},
        {"Rotate",
         [](auto &to, auto &at, int k) { to.rotate(at, float(90 * k), 0, 0, 1); },
         {1, 0, 0},
         {h, h, 0}},
        {"Rotate by turns",
         [](auto &to, auto &at, int k) { to.rotate(at, float(720 * k), 0, 0, 1); },
         {1, 0, 0},
         {1, 0, 0}},
        {"Scale",
         [](auto &to, auto &at, int k) { to.scale(at, float(1 + 2 * k), 1, 1); },
         {1, 2, 3},
         {2, 2, 3}},
        {"Skew",
         [](auto &to, auto &at, int k) { to.skew(at, float(60 * k), 0, 1, 0, 1, 0, 0); },
         {0, 1, 0},
         {std::tan(float(M_PI) / 6), 1, 0}},
        {"ConcatTransform",
         [](auto &to, auto &at, int k) {
             to.concatTransform(at, rotation(float(90 * k), {0, 0, 1}) *
                                        translation(float(4 * k), 0, 0));
         },
         {1, 0, 0},
         {2 + h, h, 0}},
        {"Transform",
         [](auto &to, auto &at, int k) { to.transform(at, scaling(float(1 + k), 1, 1)); },
         {1, 0, 0},
         {1.5f, 0, 0}},
    };
    state.worldBegin(at);
    for (const Row &row : rows) {
        SCOPED_TRACE(row.name);
        state.attributeBegin(at);
        state.motionBegin(at, {{1, 3}});
        for (int k : {0, 1})
            row.sample(state, at, k);
        state.motionEnd(at);
        sphere();
        const MotionTransform &moved = primitives().back().currentFromObject;
        ASSERT_TRUE(moved.moving());
        expectNear(placeAt(moved, 2, row.point), row.half);
        // What comes before the first time, and after the last one, stands still.
        for (auto [outside, end] : {std::pair{0.0, 1.0}, {9.0, 3.0}})
            expectNear(placeAt(moved, outside, row.point), placeAt(moved, end, row.point));
        state.attributeEnd(at);
    }
    EXPECT_EQ(errors() + warnings(), 0) << found.text();
}

TEST_F(State, motionStandsBetweenWhatStandsStill) {
    state.translate(at, 0, 0, 5);
    state.shutter(at, 0, 1);
    state.worldBegin(at);
    state.translate(at, 1, 0, 0);
    state.motionBegin(at, {{0, 1}});
    state.rotate(at, 0, 0, 0, 1);
    state.rotate(at, 180, 0, 0, 1);
    state.motionEnd(at);
    state.translate(at, 2, 0, 0);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 0, 0, 0);
    state.translate(at, 0, 2, 0);
    state.motionEnd(at);
    state.scale(at, 3, 3, 3);
    sphere();
    const MotionTransform &moved = primitives().back().currentFromObject;
    EXPECT_EQ(transformPoint(moved.matrix, {0, 0, 0}), (Vec3{3, 0, 5}));
    expectNear(placeAt(moved, 0, {1, 0, 0}), {6, 0, 5});
    expectNear(placeAt(moved, 0.5, {1, 0, 0}), {0, 5, 5});
    expectNear(placeAt(moved, 1, {0, 0, 0}), {-1, -2, 5});
    EXPECT_EQ(errors() + warnings(), 0) << found.text();
}

TEST_F(State, identityAndTransformEndMotion) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 0, 0, 0);
    state.translate(at, 9, 0, 0);
    state.motionEnd(at);
    state.transformBegin(at);
    state.identity(at);
    sphere();
    state.transform(at, translation(1, 2, 3));
    sphere();
    state.transformEnd(at);
    sphere();
    EXPECT_FALSE(primitives()[0].currentFromObject.moving());
    EXPECT_FALSE(primitives()[1].currentFromObject.moving());
    EXPECT_TRUE(primitives()[2].currentFromObject.moving());
}

// Current space is the camera's when the shutter opens.
TEST_F(State, cameraMotionIsTheCamerasAlone) {
    state.shutter(at, 0.5f, 1);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 0, 0, 4);
    state.translate(at, 0, 0, 8);
    state.motionEnd(at);
    state.worldBegin(at);
    sphere();
    EXPECT_FALSE(primitives()[0].currentFromObject.moving());
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{0, 0, 6}));
    const CameraRecord &camera = builder.worlds.back().options.camera;
    ASSERT_TRUE(camera.motion);
    EXPECT_EQ(camera.motion->at(1).at(3, 2), 8);
    EXPECT_EQ(camera.cameraFromWorld, translation(0, 0, 6));
}

TEST_F(State, lightsBeforeTheWorldDoNotMoveWithTheCamera) {
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 0, 0, 4);
    state.translate(at, 0, 0, 8);
    state.motionEnd(at);
    state.translate(at, 1, 0, 0);
    light("key");
    state.worldBegin(at);
    const auto &lights = builder.worlds.back().lights;
    ASSERT_EQ(lights.size(), 1u);
    EXPECT_FALSE(lights[0]->shader.currentFromShader.moving());
    EXPECT_EQ(lights[0]->shader.currentFromShader.atOpen(), translation(1, 0, 4));
}

TEST_F(State, faultyMotionBlocksAreReported) {
    struct Row {
        Floats times;
        int samples;
        bool rotates; ///< The last one is a Rotate.
        const char *says;
    };
    const Row rows[] = {
        {{0, 1}, 1, false, "expected a Translate for each of the 2 times, found 1"},
        {{0, 1}, 3, false, "expected a Translate for each of the 2 times, found 3"},
        {{1, 0}, 2, false, "expected times in increasing order"},
        {{0, 0}, 2, false, "expected times in increasing order"},
        {{}, 2, false, "expected times in increasing order"},
        {{0, 1}, 2, true, "expected Translate, found Rotate"},
    };
    state.worldBegin(at);
    for (const Row &row : rows) {
        SCOPED_TRACE(row.says);
        const int before = errors();
        state.transformBegin(at);
        state.motionBegin(at, {row.times});
        for (int k = 0; k < row.samples; ++k)
            if (k > 0 && row.rotates)
                state.rotate(at, 9, 0, 0, 1);
            else
                state.translate(at, float(1 + k), 0, 0);
        state.motionEnd(at);
        sphere();
        EXPECT_EQ(primitives().back().place(0, 0, 0).x, 1);
        state.transformEnd(at);
        EXPECT_GT(errors(), before);
        EXPECT_TRUE(says(row.says)) << found.text();
    }
}

TEST_F(State, whatFlattensAtATimeIsLeftOut) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.scale(at, 1, 1, 1);
    state.scale(at, 1, 1, 0);
    state.motionEnd(at);
    sphere();
    EXPECT_TRUE(primitives().empty());
    EXPECT_TRUE(says("singular"));
}

TEST_F(State, unclosedMotionBlocksDoNotSwallowTheWorld) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.translate(at, 1, 0, 0);
    state.worldEnd(at);
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(builder.worlds.back().ended);
}

TEST_F(State, shapesMoveBetweenWhatABlockSays) {
    state.worldBegin(at);
    state.motionBegin(at, {{1, 3}});
    state.sphere(at, 1, -1, 1, 360, {});
    state.sphere(at, 2, -2, 1, 180, {});
    state.motionEnd(at);
    state.motionBegin(at, {{0, 1, 2}});
    triangle({0, 0, 0, 1, 0, 0, 0, 1, 0});
    triangle({0, 0, 2, 1, 0, 2, 0, 1, 2});
    triangle({0, 0, 0, 1, 0, 0, 0, 5, 0});
    state.motionEnd(at);
    ASSERT_EQ(primitives().size(), 2u);
    const auto half = recordAt(primitives()[0].record, 2);
    EXPECT_EQ(std::get<SphereRecord>(half->shape).radius, 1.5f);
    EXPECT_EQ(std::get<SphereRecord>(half->shape).zMin, -1.5f);
    EXPECT_EQ(std::get<SphereRecord>(half->shape).thetaMax, 270);
    EXPECT_EQ(recordAt(primitives()[1].record, .5)->variables.find("P")->floats,
              (Floats{0, 0, 1, 1, 0, 1, 0, 1, 1}));
    EXPECT_EQ(recordAt(primitives()[1].record, 9)->variables.find("P")->floats,
              (Floats{0, 0, 0, 1, 0, 0, 0, 5, 0}));
    EXPECT_EQ(errors() + warnings(), 0) << found.text();
}

TEST_F(State, blobsMoveIfTheirCodesAreTheSame) {
    const auto blobs = [](float x) {
        return Floats{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, 0, 0, 1};
    };
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.blobby(at, 1, {1001, 0}, blobs(2), {}, {});
    state.blobby(at, 1, {1001, 0}, blobs(4), {}, {});
    state.motionEnd(at);
    ASSERT_EQ(primitives().size(), 1u);
    const auto half = recordAt(primitives()[0].record, .5);
    EXPECT_EQ(std::get<BlobbyRecord>(half->shape).floats, blobs(3));
    EXPECT_EQ(errors() + warnings(), 0) << found.text();
    state.motionBegin(at, {{0, 1}});
    state.blobby(at, 1, {1001, 0}, blobs(2), {}, {});
    state.blobby(at, 1, {1001, 0, 6, 0}, blobs(4), {}, {});
    state.motionEnd(at);
    ASSERT_EQ(primitives().size(), 2u);
    EXPECT_FALSE(primitives()[1].record->motion);
    EXPECT_TRUE(says("the same counts")) << found.text();
}

TEST_F(State, shapesThatCannotBecomeEachOtherStayAsTheyAre) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    triangle({0, 0, 0, 1, 0, 0, 0, 1, 0});
    triangle({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    state.motionEnd(at);
    ASSERT_EQ(primitives().size(), 1u);
    EXPECT_FALSE(primitives()[0].record->motion);
    EXPECT_TRUE(says("the same counts")) << found.text();
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, coloursAndParametersMove) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    state.color(at, Color{.25f});
    state.color(at, Color{.75f});
    state.motionEnd(at);
    state.motionBegin(at, {{0, 1}});
    state.surface(at, "marble", numbers("scale", {1}));
    state.surface(at, "marble", numbers("scale", {3}));
    state.motionEnd(at);
    sphere();
    state.color(at, Color{1.0f});
    sphere();
    ASSERT_TRUE(primitives()[0].attributes->colorMotion);
    EXPECT_EQ(primitives()[0].attributes->color, Color{.25f});
    EXPECT_EQ(primitives()[0].attributes->colorMotion->values[1], Color{.75f});
    EXPECT_FALSE(primitives()[1].attributes->colorMotion);
    const ShaderRecord &surface = *primitives()[0].attributes->surface;
    ASSERT_TRUE(surface.motion);
    EXPECT_EQ(between(surface.motion->values[0], surface.motion->values[1], .25).number("scale", 0),
              1.5f);
    EXPECT_EQ(errors() + warnings(), 0) << found.text();
}

TEST_F(State, lightsOfABlockAreOne) {
    state.worldBegin(at);
    state.motionBegin(at, {{0, 1}});
    light("key");
    light("key");
    state.motionEnd(at);
    sphere();
    ASSERT_EQ(builder.worlds.back().lights.size(), 1u);
    EXPECT_TRUE(builder.worlds.back().lights[0]->shader.motion);
    EXPECT_EQ(last().lightsOn, std::vector<int>{0});
}

} // namespace candela::testing

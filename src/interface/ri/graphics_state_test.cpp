// SPDX-License-Identifier: Apache-2.0
// Scopes: what blocks save and restore, and what happens where they do not match.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

TEST_F(State, attributeBlocksRestoreAttributesAndTransformation) {
    state.worldBegin(at);
    state.color(at, Color(1, 0, 0));
    state.attributeBegin(at);
    state.color(at, Color(0, 1, 0));
    state.matte(at, true);
    state.translate(at, 5, 0, 0);
    sphere();
    state.attributeEnd(at);
    sphere();
    state.worldEnd(at);
    ASSERT_EQ(primitives().size(), 2u);
    EXPECT_EQ(primitives()[0].attributes->color, Color(0, 1, 0));
    EXPECT_TRUE(primitives()[0].attributes->matte);
    EXPECT_EQ(primitives()[0].place(0, 0, 0).x, 5);
    EXPECT_EQ(primitives()[1].attributes->color, Color(1, 0, 0));
    EXPECT_FALSE(primitives()[1].attributes->matte);
    EXPECT_EQ(primitives()[1].place(0, 0, 0).x, 0);
    EXPECT_EQ(errors(), 0);
}

TEST_F(State, transformBlocksRestoreTheTransformationAlone) {
    state.worldBegin(at);
    state.transformBegin(at);
    state.translate(at, 5, 0, 0);
    state.color(at, Color(0, 1, 0));
    state.transformEnd(at);
    sphere();
    EXPECT_EQ(last().color, Color(0, 1, 0));
    EXPECT_EQ(primitives().back().place(0, 0, 0).x, 0);
}

TEST_F(State, primitivesShareTheirAttributes) {
    state.worldBegin(at);
    sphere();
    state.attributeBegin(at);
    state.color(at, Color(0, 1, 0));
    sphere();
    state.attributeEnd(at);
    sphere();
    EXPECT_EQ(primitives()[0].attributes, primitives()[2].attributes);
    EXPECT_NE(primitives()[0].attributes, primitives()[1].attributes);
}

TEST_F(State, transformationsApplyToTheObjectFirst) {
    state.translate(at, 0, 0, 10); // The camera.
    state.worldBegin(at);
    state.translate(at, 1, 0, 0);
    state.scale(at, 2, 2, 2);
    sphere();
    EXPECT_EQ(primitives()[0].place(1, 0, 0), (Vec3{3, 0, 10}));
    state.transform(at, translation(0, 7, 0)); // Relative to the world, not to the camera.
    sphere();
    EXPECT_EQ(primitives()[1].place(0, 0, 0), (Vec3{0, 7, 10}));
    state.identity(at);
    sphere();
    EXPECT_EQ(primitives()[2].place(0, 0, 0), (Vec3{0, 0, 10}));
}

TEST_F(State, projectionStartsCameraSpace) {
    state.projection(at, "perspective", numbers("fov", {30}));
    state.rotate(at, 90, 0, 0, 1);
    state.worldBegin(at);
    const Options &options = builder.worlds[0].options;
    EXPECT_EQ(options.camera.fieldOfView, 30);
    EXPECT_EQ(options.camera.cameraFromWorld, rotation(90, {0, 0, 1}));
    EXPECT_EQ(options.coordinateSystems.at("world"), options.camera.cameraFromWorld);
    EXPECT_EQ(options.coordinateSystems.at("camera"), Matrix4{});
}

TEST_F(State, framesAreIndependent) {
    for (int frame : {1, 2}) {
        state.frameBegin(at, frame);
        state.format(at, 100 * frame, 50, 1);
        if (frame == 1) {
            state.exposure(at, 2, 2.2f);
            light("x");
            state.translate(at, 0, 0, 3);
        }
        state.worldBegin(at);
        sphere();
        state.worldEnd(at);
        state.frameEnd(at);
    }
    ASSERT_EQ(builder.worlds.size(), 2u);
    EXPECT_EQ(builder.worlds[0].options.frame, 1);
    EXPECT_EQ(builder.worlds[1].options.frame, 2);
    EXPECT_EQ(builder.worlds[1].options.format.xResolution, 200);
    EXPECT_EQ(builder.worlds[0].options.exposure->gain, 2);
    EXPECT_FALSE(builder.worlds[1].options.exposure);
    EXPECT_EQ(builder.worlds[0].lights.size(), 1u);
    EXPECT_EQ(builder.worlds[1].lights.size(), 0u);
    EXPECT_EQ(builder.worlds[1].options.camera.cameraFromWorld, Matrix4{});
}

TEST_F(State, optionsAreFrozenInTheWorld) {
    state.worldBegin(at);
    state.format(at, 10, 10, 1);
    state.format(at, 20, 20, 1);
    state.display(at, "late", "file", "rgb", {});
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(warnings(), 2); // Once a request.
    state.worldEnd(at);
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds[1].options.format.xResolution, 640);
}

TEST_F(State, theCommandLineHasTheLastWord) {
    GraphicsState other(builder, shaders, policy,
                        {{}, [](Options &options) { options.format.xResolution = 77; }, {}});
    other.format(at, 10, 10, 1);
    other.worldBegin(at);
    EXPECT_EQ(builder.worlds[0].options.format.xResolution, 77);
    EXPECT_EQ(builder.worlds[0].options.format.yResolution, 10);
}

TEST_F(State, primitivesOutsideTheWorldAreReported) {
    sphere();
    EXPECT_TRUE(says("Sphere is legal only between WorldBegin and WorldEnd"));
    EXPECT_TRUE(builder.worlds.empty());
}

TEST_F(State, unmatchedEndsAreReportedAndDropped) {
    state.worldEnd(at);
    state.frameEnd(at);
    state.objectEnd(at);
    state.motionEnd(at);
    state.worldBegin(at);
    state.attributeEnd(at);
    state.transformEnd(at);
    EXPECT_EQ(errors(), 6);
    sphere();
    state.worldEnd(at);
    EXPECT_TRUE(builder.worlds.back().ended);
    EXPECT_EQ(primitives().size(), 1u);
}

TEST_F(State, openBlocksAreClosedByTheEndAroundThem) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.transformBegin(at);
    state.color(at, Color(0, 1, 0));
    state.attributeEnd(at); // TransformEnd is missing.
    sphere();
    EXPECT_EQ(last().color, Color(1));
    EXPECT_TRUE(says("TransformBegin"));
    state.attributeBegin(at);
    state.worldEnd(at); // AttributeEnd is missing.
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(builder.worlds.back().ended);
}

TEST_F(State, blocksOutsideAWorldStayOpenInIt) {
    state.attributeBegin(at);
    state.worldBegin(at);
    state.attributeEnd(at);
    EXPECT_EQ(errors(), 1);
    state.worldEnd(at);
    state.attributeEnd(at);
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, aWorldThatIsNeverClosedIsReported) {
    state.worldBegin(at);
    sphere();
    state.finish();
    EXPECT_EQ(errors(), 1);
    EXPECT_FALSE(builder.worlds.back().ended);
}

TEST_F(State, worldsAndFramesDoNotNest) {
    state.frameBegin(at, 1);
    state.frameBegin(at, 2);
    state.worldBegin(at);
    state.worldBegin(at);
    state.frameBegin(at, 3);
    EXPECT_EQ(errors(), 3);
    EXPECT_EQ(builder.worlds.size(), 1u);
}

TEST_F(State, nestingHasALimit) {
    state.worldBegin(at);
    for (int i = 0; i < 100000; ++i)
        state.attributeBegin(at);
    EXPECT_EQ(found.count(Severity::Fatal), 1);
    EXPECT_TRUE(state.stopped());
}

TEST_F(State, coordinateSystemsAreNamedAndEntered) {
    state.coordinateSystem(at, "outer");
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds[0].options.coordinateSystems.count("outer"), 1u);
    state.translate(at, 1, 2, 3);
    state.coordinateSystem(at, "desk");
    EXPECT_EQ(builder.worlds[0].coordinateSystems.at("desk"), translation(1, 2, 3));
    state.identity(at);
    state.coordSysTransform(at, "desk");
    sphere();
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{1, 2, 3}));
    state.coordSysTransform(at, "nowhere");
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, abortEndsWithBlocksStillOpen) {
    state.errorHandler(at, "abort");
    state.worldBegin(at);
    state.attributeBegin(at);
    state.worldEnd(at);
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(state.stopped());
    EXPECT_FALSE(builder.worlds.back().ended);
}

TEST_F(State, errorHandlersDecide) {
    state.errorHandler(at, "ignore");
    sphere();
    EXPECT_EQ(found.all().size(), 0u);
    state.errorHandler(at, "print");
    sphere();
    EXPECT_EQ(errors(), 1);
    EXPECT_FALSE(state.stopped());
    state.errorHandler(at, "abort");
    sphere();
    EXPECT_TRUE(state.stopped());
    EXPECT_EQ(found.count(Severity::Fatal), 1);
    state.worldBegin(at);
    EXPECT_TRUE(builder.worlds.empty());
    EXPECT_EQ(found.count(Severity::Fatal), 1);
}

TEST_F(State, whatComesLaterIsWarnedAboutOnce) {
    state.colorSamples(at, {1, 1, 1}, {1, 1, 1});
    state.colorSamples(at, {1, 1, 1}, {1, 1, 1});
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(warnings(), 1);
    EXPECT_TRUE(says("ColorSamples: this version keeps three samples in a color"));
}

TEST_F(State, optionsWithoutEffectAreWarnedAboutOnce) {
    state.hider(at, "hidden", {});
    state.hider(at, "null", {});
    EXPECT_EQ(warnings(), 0);
    for (const char *type : {"paint", "zbuffer", "zbuffer"})
        state.hider(at, type, {});
    EXPECT_EQ(warnings(), 2);
}

TEST_F(State, integratorsAreChecked) {
    auto integrator = [&](const char *name) {
        state.option(at, "render", text("integrator", name));
    };
    integrator("path");
    integrator("bidir");
    integrator("vcm");
    integrator("radiosity");
    integrator("classic");
    EXPECT_EQ(found.all().size(), 0u);
    integrator("magic");
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, highlightsAreChecked) {
    for (const char *name : {"production", "ri", "shiny"})
        state.option(at, "shading", text("highlights", name));
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(says("one of \"production\", \"ri\""));
}

TEST_F(State, depthsAreChecked) {
    const auto depth = [&](float value) {
        state.option(at, "trace", numbers("float maxdepth", {value}));
    };
    depth(0), depth(7);
    EXPECT_EQ(errors(), 0);
    depth(-1), depth(NAN), depth(INFINITY);
    EXPECT_EQ(errors(), 3);
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds.back().options.named.number("trace:maxdepth", 64), 7);
}

TEST_F(State, samplesHaveALimit) {
    state.pixelSamples(at, 4096, 4096);
    EXPECT_EQ(errors(), 0);
    state.pixelSamples(at, 60000, 60000);
    EXPECT_EQ(errors(), 1);
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds.back().options.xSamples, 4096);
}

TEST_F(State, displayParametersAreDeclared) {
    TokenList tokens = numbers("halfbuffers", {1});
    tokens.all.push_back(numbers("quantize", {0, 255, 0, 255}).all.front());
    tokens.all.push_back(numbers("dither", {.5f}).all.front());
    state.display(at, "a.exr", "file", "rgb", tokens);
    EXPECT_EQ(found.text(), "");
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
// Transformations: composed in double, rounded once; what flattens, tapers or is not finite.
#include "foundation/base/matrix4d.h"
#include "interface/ri/graphics_state_fixture.h"

#include <cmath>
#include <limits>

namespace candela::testing {

TEST_F(State, longChainsAndTheirInversesMeetAtTheIdentity) {
    state.worldBegin(at);
    // Where the chain begins and how long it is: within an ulp of a float as long as its roundings
    // in double, each half an ulp of the distance, come to less than that.
    const std::pair<float, int> table[] = {{0, 1000}, {1, 1000}, {1e4f, 1000}, {1e7f, 10}};
    for (auto [distance, length] : table) {
        state.transformBegin(at);
        state.translate(at, distance, -distance, 3);
        for (int i = 0; i < length; ++i) {
            state.rotate(at, float(i), 1, float(i % 3), 2);
            state.translate(at, 0.1f, -0.3f, 0.7f);
        }
        for (int i = length - 1; i >= 0; --i) {
            state.translate(at, -0.1f, 0.3f, -0.7f);
            state.rotate(at, -float(i), 1, float(i % 3), 2);
        }
        state.translate(at, -distance, distance, -3);
        sphere();
        const Matrix4 &matrix = primitives().back().currentFromObject.atOpen();
        for (int entry = 0; entry < 16; ++entry)
            EXPECT_NEAR(matrix.m[entry], Matrix4{}.m[entry], std::numeric_limits<float>::epsilon())
                << "entry " << entry << " at " << distance;
        state.transformEnd(at);
    }
}

// The camera follows an object that is as far away as a planet: what is between them is small and
// all that the world gets to see.
TEST_F(State, farFromTheOriginNothingIsLost) {
    state.rotate(at, 33, 1, 2, 3);
    state.translate(at, -1e7f, 2e7f, -1e7f);
    state.worldBegin(at);
    state.translate(at, 1e7f, -2e7f, 1e7f);
    state.rotate(at, -33, 1, 2, 3);
    state.translate(at, 0.25f, 0.125f, 2);
    sphere();
    const Vec3 centre = primitives()[0].place(0, 0, 0);
    Matrix4d seen = inDouble(translation(0.25f, 0.125f, 2)) * rotationInDouble(-33, {1, 2, 3}) *
                    rotationInDouble(33, {1, 2, 3});
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(centre[axis], seen.at(3, axis), 2e-8) << axis;
}

TEST_F(State, coordinateSystemsKeepTheirPrecision) {
    state.worldBegin(at);
    state.translate(at, 1e7f, 0, 0);
    state.translate(at, 0.25f, 0, 0); // Lost in a float.
    state.coordinateSystem(at, "desk");
    state.identity(at);
    state.coordSysTransform(at, "desk");
    state.translate(at, -1e7f, 0, 0);
    sphere();
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{0.25f, 0, 0}));
}

TEST_F(State, transformationsAloneCopyNoAttributes) {
    state.worldBegin(at);
    state.color(at, Color(0, 1, 0));
    sphere();
    for (int i = 0; i < 100; ++i) {
        state.attributeBegin(at);
        state.scale(at, i % 2 ? 1.f : -1.f, 1, 1);
        sphere();
        state.attributeEnd(at);
        EXPECT_EQ(primitives().back().attributes, primitives()[0].attributes);
    }
    state.attributeBegin(at);
    state.color(at, Color(1, 0, 0));
    sphere();
    state.attributeEnd(at);
    EXPECT_EQ(last().color, Color(1, 0, 0));
    EXPECT_EQ(primitives()[0].attributes->color, Color(0, 1, 0));
}

TEST_F(State, whatIsNotATransformationIsReportedAndIgnored) {
    state.worldBegin(at);
    state.translate(at, 1, 2, 3);
    state.translate(at, NAN, 0, 0);
    state.scale(at, INFINITY, 1, 1);
    state.scale(at, 1e30f, 1, 1);
    state.scale(at, 1e30f, 1, 1); // More than a float holds.
    state.scale(at, 1e-30f, 1, 1);
    state.transform(at, Matrix4{{}});
    state.concatTransform(at, Matrix4{{1, 0, 0, INFINITY}});
    state.rotate(at, 30, 0, 0, 0);
    state.rotate(at, INFINITY, 0, 0, 1);
    state.perspective(at, 0);
    state.skew(at, 30, 1, 0, 0, 2, 0, 0);
    state.skew(at, 95, 0, 1, 0, 1, 0, 0);
    EXPECT_EQ(errors(), 10);
    sphere();
    for (int entry = 0; entry < 16; ++entry)
        EXPECT_FLOAT_EQ(primitives()[0].currentFromObject.atOpen().m[entry],
                        translation(1, 2, 3).m[entry]);
}

TEST_F(State, whatIsFlattenedIsLeftOutWithAWarning) {
    const auto flatten = [this](int way) {
        if (way == 0)
            state.scale(at, 1, 0, 1);
        else if (way == 1)
            state.concatTransform(at, Matrix4{{1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}});
        else
            state.transform(at, scaling(0, 0, 0));
    };
    state.worldBegin(at);
    state.objectBegin(at, {"o"});
    sphere();
    state.objectEnd(at);
    for (int way : {0, 1, 2}) {
        const int before = warnings();
        state.transformBegin(at);
        flatten(way);
        EXPECT_EQ(warnings(), before);
        state.rotate(at, 30, 0, 0, 1); // Nothing brings back what is flat,
        sphere();
        state.objectInstance(at, {"o"});
        EXPECT_EQ(warnings(), before + 2);
        state.identity(at); // but a transformation in its place.
        sphere();
        state.transformEnd(at);
        sphere();
        EXPECT_EQ(warnings(), before + 2);
    }
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(primitives().size(), 6u);
    EXPECT_TRUE(builder.worlds[0].instances.empty());
}

TEST_F(State, aFlatCameraIsAnError) {
    state.scale(at, 1, 1, 0);
    state.worldBegin(at);
    sphere();
    EXPECT_EQ(errors(), 1);
    EXPECT_EQ(builder.worlds[0].options.camera.cameraFromWorld, Matrix4{});
    EXPECT_EQ(primitives().size(), 1u);
}

TEST_F(State, noTransformationTapers) {
    state.translate(at, 1, 2, 3);
    state.perspective(at, 90);
    state.perspective(at, 60);
    EXPECT_EQ(warnings(), 1);
    EXPECT_TRUE(says("Perspective: this version has no perspective but that of Projection"));
    state.worldBegin(at);
    Matrix4 scaled = translation(4, 5, 6); // All of it by 2: the same place.
    for (float &entry : scaled.m)
        entry *= 2;
    scaled.at(0, 3) = 1e-7f;
    state.concatTransform(at, scaled);
    sphere();
    EXPECT_EQ(primitives()[0].place(0, 0, 0), (Vec3{5, 7, 9}));
    EXPECT_EQ(errors(), 0);
}

TEST_F(State, withoutAProjectionTheTransformationIsTheCameras) {
    for (const char *name : {"null", "", "none at all"}) {
        state.frameBegin(at, 1);
        state.scale(at, .5f, .5f, 1);
        if (name != std::string("none at all"))
            state.projection(at, name, {});
        state.translate(at, 0, 0, 4);
        state.worldBegin(at);
        const CameraRecord &camera = builder.worlds.back().options.camera;
        EXPECT_FALSE(camera.perspective);
        EXPECT_EQ(camera.screenFromProjected, Matrix4{});
        EXPECT_EQ(camera.cameraFromWorld, translation(0, 0, 4) * scaling(.5f, .5f, 1)) << name;
        state.worldEnd(at);
        state.frameEnd(at);
    }
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, whatStandsBeforeProjectionMovesThePicture) {
    for (const char *name : {"perspective", "orthographic"}) {
        state.frameBegin(at, 1);
        state.translate(at, .25f, 0, 0);
        state.rotate(at, 90, 0, 0, 1);
        state.projection(at, name, {});
        state.translate(at, 0, 0, 4);
        state.worldBegin(at);
        const CameraRecord &camera = builder.worlds.back().options.camera;
        EXPECT_EQ(camera.screenFromProjected, rotation(90, {0, 0, 1}) * translation(.25f, 0, 0));
        EXPECT_EQ(camera.cameraFromWorld, translation(0, 0, 4));
        state.worldEnd(at);
        state.frameEnd(at);
    }
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, whatCannotMoveAPictureIsLeftOut) {
    const auto screen = [this](auto request) {
        state.frameBegin(at, 1);
        request();
        state.projection(at, "orthographic", {});
        state.worldBegin(at);
        state.worldEnd(at);
        state.frameEnd(at);
        return builder.worlds.back().options.camera.screenFromProjected;
    };
    const Matrix4 tilted = screen([&] { state.rotate(at, 60, 0, 1, 0); });
    EXPECT_EQ(warnings(), 1);
    EXPECT_EQ(tilted.at(2, 0), 0);
    EXPECT_NEAR(tilted.at(0, 0), .5, 1e-6);
    EXPECT_EQ(screen([&] { state.rotate(at, 90, 0, 1, 0); }), Matrix4{}); // Seen edge on.
    EXPECT_EQ(errors(), 1);
    EXPECT_EQ(screen([&] { state.scale(at, 0, 1, 1); }), Matrix4{});
    EXPECT_EQ(errors(), 2);
    EXPECT_EQ(screen([&] { state.perspective(at, 60); }), Matrix4{});
    EXPECT_EQ(warnings(), 3);
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
// Which side is the outside (RI 3.2, 4.2.9). The natural normal is carried along as a covector,
// which keeps its side in every mirror; the flag says whether it is turned round besides.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

namespace {

struct Mirror {
    const char *name;
    float x, y, z;
    bool mirrors() const { return x * y * z < 0; }
};
constexpr Mirror mirrors[] = {
    {"none", 1, 1, 1}, {"x", -1, 1, 1}, {"z", 1, 1, -1}, {"xy", -1, -1, 1}, {"xyz", -1, -1, -1}};

} // namespace

TEST_F(State, outsideIsLeftToTheCovectorInEveryMirror) {
    for (const Mirror &camera : mirrors)
        for (const Mirror &before : mirrors)
            for (const Mirror &after : mirrors)
                for (bool inside : {false, true})
                    for (bool reversed : {false, true}) {
                        state.frameBegin(at, 1);
                        state.scale(at, camera.x, camera.y, camera.z);
                        state.worldBegin(at);
                        state.attributeBegin(at);
                        state.scale(at, before.x, before.y, before.z);
                        if (inside)
                            state.orientation(at, "inside");
                        if (reversed)
                            state.reverseOrientation(at);
                        state.scale(at, after.x, after.y, after.z);
                        sphere();
                        EXPECT_EQ(last().flipNormal, inside != reversed)
                            << camera.name << before.name << after.name << inside << reversed;
                        state.attributeEnd(at);
                        sphere();
                        EXPECT_FALSE(last().flipNormal);
                        state.worldEnd(at);
                        state.frameEnd(at);
                    }
    EXPECT_EQ(errors() + warnings(), 0);
}

// "lh" and "rh" are compared with the coordinate system where they stand; from there on the
// orientation turns with the coordinate system.
TEST_F(State, absoluteOrientationsTurnWithTheCoordinateSystem) {
    for (const Mirror &camera : mirrors)
        for (const Mirror &before : mirrors)
            for (const Mirror &after : mirrors)
                for (const char *name : {"lh", "rh"}) {
                    state.frameBegin(at, 1);
                    state.scale(at, camera.x, camera.y, camera.z);
                    state.worldBegin(at);
                    state.scale(at, before.x, before.y, before.z);
                    state.orientation(at, name);
                    state.scale(at, after.x, after.y, after.z);
                    sphere();
                    const bool rightHanded = camera.mirrors() != before.mirrors();
                    EXPECT_EQ(last().flipNormal, rightHanded != (name == std::string("rh")))
                        << camera.name << before.name << after.name << name;
                    state.reverseOrientation(at);
                    sphere();
                    EXPECT_EQ(last().flipNormal, rightHanded == (name == std::string("rh")));
                    state.worldEnd(at);
                    state.frameEnd(at);
                }
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, orientationBeforeTheWorldHoldsInIt) {
    state.orientation(at, "inside");
    state.scale(at, 1, 1, -1);
    state.worldBegin(at);
    sphere();
    EXPECT_TRUE(last().flipNormal);
    state.transformBegin(at);
    state.scale(at, -1, 1, 1);
    state.reverseOrientation(at); // An attribute: the end of the transformation does not undo it.
    state.transformEnd(at);
    sphere();
    EXPECT_FALSE(last().flipNormal);
}

TEST_F(State, unknownOrientationsAreReported) {
    state.worldBegin(at);
    state.orientation(at, "sideways");
    EXPECT_EQ(errors(), 1);
}

// The flag of the definition and that of the instance stand side by side; the world combines them.
TEST_F(State, orientationsOfObjectsAndInstancesAreApart) {
    for (bool outer : {false, true})
        for (bool inner : {false, true})
            for (bool atInstance : {false, true})
                for (bool mirrored : {false, true}) {
                    state.worldBegin(at);
                    if (outer) // Before the definition, it is the instance's alone.
                        state.reverseOrientation(at);
                    if (mirrored)
                        state.scale(at, 1, 1, -1);
                    state.objectBegin(at, {"o"});
                    if (inner)
                        state.reverseOrientation(at);
                    state.scale(at, -1, 1, 1);
                    sphere();
                    state.objectEnd(at);
                    if (atInstance)
                        state.reverseOrientation(at);
                    state.objectInstance(at, {"o"});
                    const auto &world = builder.worlds.back();
                    EXPECT_EQ(world.objects.at(0).primitives[0].attributes->flipNormal, inner);
                    EXPECT_EQ(world.instances[0].attributes->flipNormal, outer != atInstance);
                    state.worldEnd(at);
                }
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
// Resources, coordinate systems of blocks, channels of displays.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

namespace {

TokenList operation(const std::string &what, const std::string &subset = "") {
    TokenList list{{{"string operation", {}, {}, {what}}}};
    if (!subset.empty())
        list.all.push_back({"string subset", {}, {}, {subset}});
    return list;
}

} // namespace

class ResourcesOfState : public State {
protected:
    void save(const std::string &name) {
        state.resource(at, name, "attributes", operation("save"));
    }
    void restore(const std::string &name, const std::string &subset = "") {
        state.resource(at, name, "attributes", operation("restore", subset));
    }
    /// Everything that a subset may hold is changed.
    void change(float by) {
        state.color(at, Color(by, 0, 0));
        state.sides(at, by > 0.5f ? 1 : 2);
        state.translate(at, by, 0, 0);
        state.reverseOrientation(at);
        state.displacement(at, "dents" + std::to_string(by), {});
    }
};

TEST_F(ResourcesOfState, attributesAreSavedAndRestoredAcrossBlocks) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.color(at, Color(1, 0, 0));
    state.translate(at, 3, 0, 0);
    state.attribute(at, "user", text("string mood", "calm"));
    save("red");
    state.attributeEnd(at);
    state.color(at, Color(0, 1, 0));
    restore("red");
    sphere();
    EXPECT_EQ(last().color, Color(1, 0, 0));
    EXPECT_EQ(last().named.string("user:mood", ""), "calm");
    EXPECT_EQ(primitives().back().place(0, 0, 0), (Vec3{3, 0, 0}));
    EXPECT_EQ(found.text(), "");
}

TEST_F(ResourcesOfState, subsetsRestoreWhatTheyName) {
    const struct {
        const char *subset;
        bool color, sides, place, turned, displacement;
    } cases[] = {{"all", true, true, true, true, true},
                 {"", true, true, true, true, true},
                 {"shading", true, false, false, false, false},
                 {"hiding", false, true, false, false, false},
                 {"transform", false, false, true, false, false},
                 {"geometry", false, false, false, true, true},
                 {"geometrydefinition", false, false, false, true, false},
                 {"geometrymodification", false, false, false, false, true},
                 {"shading,transform", true, false, true, false, false}};
    state.worldBegin(at);
    for (const auto &each : cases) {
        state.attributeBegin(at);
        change(0.25f);
        save("there");
        change(1);
        restore("there", each.subset);
        sphere();
        EXPECT_EQ(last().color == Color(.25f, 0, 0), each.color) << each.subset;
        EXPECT_EQ(last().sides == 2, each.sides) << each.subset;
        EXPECT_EQ(primitives().back().place(0, 0, 0).x == .25f, each.place) << each.subset;
        EXPECT_EQ(last().flipNormal, each.turned) << each.subset;
        EXPECT_EQ(last().displacement->name == "dents0.250000", each.displacement) << each.subset;
        state.attributeEnd(at);
    }
    EXPECT_EQ(found.text(), "");
}

TEST_F(ResourcesOfState, haveBlocksOfTheirOwn) {
    state.worldBegin(at);
    state.color(at, Color(1, 0, 0));
    save("a");
    state.resourceBegin(at);
    state.color(at, Color(0, 1, 0));
    save("a");
    state.color(at, Color(1));
    restore("a");
    sphere();
    EXPECT_EQ(last().color, Color(0, 1, 0));
    state.resourceEnd(at);
    restore("a");
    sphere();
    EXPECT_EQ(last().color, Color(1, 0, 0));
    EXPECT_EQ(found.text(), "");
}

TEST_F(ResourcesOfState, lightsOfAnEarlierWorldDoNotComeBack) {
    state.worldBegin(at);
    light("one"), light("two");
    save("lit");
    state.attributeBegin(at);
    state.illuminate(at, {"one"}, false);
    restore("lit", "shading");
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector<int>{0, 1}));
    state.attributeEnd(at);
    state.worldEnd(at);
    state.worldBegin(at);
    light("three");
    restore("lit");
    sphere();
    EXPECT_EQ(last().lightsOn, std::vector<int>{0});
    EXPECT_EQ(found.text(), "");
}

TEST_F(ResourcesOfState, whatIsWrongIsReported) {
    state.worldBegin(at);
    restore("nothing");
    EXPECT_TRUE(says("no attributes have been saved as 'nothing'"));
    state.resource(at, "a", "attributes", operation("guess"));
    save("a");
    restore("a", "everything");
    state.resourceEnd(at);
    EXPECT_EQ(errors(), 4);
    state.resource(at, "a", "archive", operation("read"));
    EXPECT_EQ(warnings(), 1);
}

TEST_F(State, scopedCoordinateSystemsEndWithTheirBlock) {
    state.worldBegin(at);
    state.translate(at, 1, 0, 0);
    state.coordinateSystem(at, "here");
    state.attributeBegin(at);
    state.translate(at, 1, 0, 0);
    state.scopedCoordinateSystem(at, "here");
    state.transformBegin(at);
    state.scopedCoordinateSystem(at, "inner"); // Transform blocks are none of attributes.
    state.transformEnd(at);
    state.identity(at);
    state.coordSysTransform(at, "here");
    sphere();
    EXPECT_EQ(primitives().back().place(0, 0, 0), (Vec3{2, 0, 0}));
    state.coordSysTransform(at, "inner");
    EXPECT_EQ(errors(), 0);
    EXPECT_EQ(warnings(), 1); // Two systems "here".
    state.attributeEnd(at);
    state.identity(at);
    state.coordSysTransform(at, "here");
    sphere();
    EXPECT_EQ(primitives().back().place(0, 0, 0), (Vec3{1, 0, 0}));
    state.coordSysTransform(at, "inner");
    EXPECT_EQ(errors(), 1);
    EXPECT_EQ(builder.worlds.back().coordinateSystems.count("inner"), 1u); // Shaders may ask.
}

TEST_F(State, displaysNameChannels) {
    state.displayChannel(at, "varying color _shine", text("string source", "color gloss"));
    state.displayChannel(at, "varying float depth", text("string source", "z"));
    state.displayChannel(at, "varying color diffuse", {});
    state.display(at, "a.exr", "openexr", "rgba,_shine,depth,diffuse,N", {});
    state.display(at, "+b.exr", "openexr", "_shine", {});
    state.worldBegin(at);
    const auto &displays = builder.worlds.back().options.displays;
    EXPECT_EQ(displays.at(0).mode, "rgba,gloss,z,diffuse,N");
    EXPECT_EQ(displays.at(1).mode, "gloss");
    EXPECT_EQ(found.text(), "");
    state.worldEnd(at);
    state.displayChannel(at, "varying clor x", {});
    EXPECT_TRUE(says("'varying clor x' is no channel"));
}

TEST_F(State, conditionsAskForOptionsAndAttributes) {
    state.option(at, "user", text("string pass", "beauty"));
    state.option(at, "user", numbers("float[2] pair", {7, 8}));
    state.frameBegin(at, 12);
    state.attribute(at, "user", numbers("int n", {3}));
    EXPECT_EQ(state.valueOf("Frame"), StateValue(12.0));
    EXPECT_EQ(state.valueOf("user:pass"), StateValue("beauty"));
    EXPECT_EQ(state.valueOf("user:pair"), StateValue(7.0));
    EXPECT_EQ(state.valueOf("user:n"), StateValue(3.0));
    EXPECT_EQ(state.valueOf("Attribute:user:n"), StateValue(3.0));
    EXPECT_EQ(state.valueOf("Option:user:n"), std::nullopt);
    EXPECT_EQ(state.valueOf("user:other"), std::nullopt);
    EXPECT_EQ(state.valueOf(""), std::nullopt);
}

} // namespace candela::testing

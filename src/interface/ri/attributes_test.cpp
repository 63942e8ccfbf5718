// SPDX-License-Identifier: Apache-2.0
// Lights, shaders, named options and attributes, and what of them is refused.
#include "interface/ri/graphics_state_fixture.h"
#include "interface/ri/search_path.h"
#include "interface/ri/trim_record.h"

#include <cmath>

namespace candela::testing {

TEST_F(State, lightsAreSwitchedByBlocks) {
    light("outer");
    state.worldBegin(at);
    state.attributeBegin(at);
    light("inner");
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector{0, 1}));
    state.attributeEnd(at);
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector{0}));
    state.illuminate(at, {"inner"}, true);
    state.illuminate(at, {"outer"}, false);
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector{1}));
    state.illuminate(at, {"outer"}, true);
    state.illuminate(at, {"outer"}, true);
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector{0, 1}));
    state.illuminate(at, {"none"}, true);
    EXPECT_EQ(errors(), 1);
    ASSERT_EQ(builder.worlds[0].lights.size(), 2u);
    EXPECT_EQ(builder.worlds[0].lights[1]->index, 1);
    EXPECT_EQ(builder.worlds[0].lights[1]->handle, "inner");
}

TEST_F(State, lightsOfAWorldDieWithIt) {
    light("outer");
    for (int world = 0; world < 2; ++world) {
        state.worldBegin(at);
        light("inner");
        sphere();
        state.worldEnd(at);
        EXPECT_EQ(builder.worlds[world].lights.size(), 2u);
        EXPECT_EQ(last().lightsOn, (std::vector{0, 1}));
    }
    state.worldBegin(at);
    state.illuminate(at, {"inner"}, true);
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, aHandleMayBeUsedAgain) {
    state.worldBegin(at);
    light("x");
    light("x");
    state.illuminate(at, {"x"}, false);
    sphere();
    EXPECT_EQ(last().lightsOn, (std::vector{0}));
}

TEST_F(State, areaLightsBelongToTheirBlock) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.areaLightSource(at, "arealight", {"a"}, {});
    sphere();
    ASSERT_TRUE(last().areaLight);
    EXPECT_EQ(last().areaLight, builder.worlds[0].lights[0]);
    EXPECT_TRUE(last().areaLight->area);
    state.areaLightSource(at, "null", {"b"}, {});
    sphere();
    EXPECT_FALSE(last().areaLight);
    state.attributeEnd(at);
    sphere();
    EXPECT_FALSE(last().areaLight);
    EXPECT_EQ(builder.worlds[0].lights.size(), 1u);
}

TEST_F(State, unitsOfLightsComeFromTheAttributeThenTheOption) {
    light("a");
    state.option(at, "radiometry", text("string units", "si"));
    light("b");
    state.worldBegin(at);
    state.attributeBegin(at);
    state.attribute(at, "light", text("units", "classic"));
    state.attribute(at, "light", text("shadows", "on"));
    light("c");
    state.attributeEnd(at);
    light("d");
    state.attribute(at, "light", text("units", "imperial"));
    light("e");
    const auto &lights = builder.worlds[0].lights;
    EXPECT_EQ(lights[0]->units, LightUnits::Classic);
    EXPECT_EQ(lights[1]->units, LightUnits::Si);
    EXPECT_EQ(lights[2]->units, LightUnits::Classic);
    EXPECT_TRUE(lights[2]->shadows);
    EXPECT_EQ(lights[3]->units, LightUnits::Si);
    EXPECT_FALSE(lights[3]->shadows);
    EXPECT_EQ(lights[4]->units, LightUnits::Si);
    EXPECT_EQ(errors(), 1);
}

TEST_F(State, shadersCarryTheirSpaceAndTypedParameters) {
    state.worldBegin(at);
    state.translate(at, 1, 0, 0);
    TokenList tokens{{{"vein", {}, {1, 0, 0}, {}},
                      {"grain", {}, {}, {"fine"}},
                      {"color extra", {}, {1, 2, 3}, {}}}};
    state.surface(at, "marble", tokens);
    state.translate(at, 5, 0, 0);
    sphere();
    const ShaderRecord &shader = *last().surface;
    EXPECT_EQ(shader.name, "marble");
    EXPECT_EQ(shader.currentFromShader.atOpen(), translation(1, 0, 0));
    EXPECT_EQ(shader.parameters.find("vein")->declaration.type, ValueType::Color);
    EXPECT_EQ(shader.parameters.string("grain", ""), "fine");
    EXPECT_EQ(shader.parameters.find("extra")->declaration.type, ValueType::Color);
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, typesComeFromInlineThenDeclareThenShaderThenStandard) {
    state.worldBegin(at);
    state.declare(at, "vein", "point");
    state.surface(at, "marble", numbers("vein", {1, 2, 3}));
    sphere();
    EXPECT_EQ(last().surface->parameters.find("vein")->declaration.type, ValueType::Point);
    state.surface(at, "marble", numbers("vector vein", {1, 2, 3}));
    sphere();
    EXPECT_EQ(last().surface->parameters.find("vein")->declaration.type, ValueType::Vector);
    state.surface(at, "marble", numbers("color scale", {1, 2, 3})); // Not in the dictionary.
    state.surface(at, "marble", numbers("scale", {4}));
    sphere();
    EXPECT_EQ(last().surface->parameters.number("scale", 0), 4);
    state.surface(at, "elsewhere", numbers("specularcolor", {1, 2, 3}));
    sphere();
    EXPECT_EQ(last().surface->parameters.all[0].declaration.type, ValueType::Color);
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, badShaderParametersAreLeftOut) {
    state.worldBegin(at);
    state.surface(at, "marble", numbers("vein", {1, 2}));
    state.surface(at, "marble", text("scale", "big"));
    state.surface(at, "marble", numbers("scale", {NAN}));
    state.surface(at, "marble", numbers("uniform nonsense scale", {1}));
    EXPECT_EQ(errors(), 4);
    state.surface(at, "marble", numbers("Kd", {1}));
    EXPECT_TRUE(says("shader 'marble' has no parameter 'Kd'"));
    EXPECT_EQ(warnings(), 1);
    sphere();
    EXPECT_TRUE(last().surface->parameters.all.empty());
    state.declare(at, "x", "many floats");
    EXPECT_EQ(errors(), 5);
}

TEST_F(State, namedOptionsAndAttributesAreKept) {
    state.option(at, "render", text("string integrator", "path"));
    state.option(at, "mine", numbers("float[2] pair", {1, 2}));
    state.worldBegin(at);
    state.attribute(at, "identifier", text("name", "ball"));
    state.attribute(at, "user", numbers("uniform float x", {3}));
    sphere();
    EXPECT_EQ(builder.worlds[0].options.named.string("render:integrator", ""), "path");
    EXPECT_EQ(builder.worlds[0].options.named.find("mine:pair")->floats, (Floats{1, 2}));
    EXPECT_EQ(last().name, "ball");
    EXPECT_EQ(last().named.number("user:x", 0), 3);
    EXPECT_EQ(warnings(), 0);
    state.attribute(at, "user", numbers("undeclared", {3, 4}));
    state.attribute(at, "user", numbers("undeclared", {5, 6}));
    EXPECT_EQ(warnings(), 1);
    sphere();
    EXPECT_EQ(last().named.find("user:undeclared")->floats, (Floats{5, 6}));
}

TEST_F(State, searchPathsAreExpanded) {
    GraphicsState other(builder, shaders, policy, {{"lib:more", "", ""}, {}, {}});
    other.option(at, "searchpath", text("shader", "mine:@"));
    other.option(at, "searchpath", text("string shader", "first:&"));
    other.worldBegin(at);
    EXPECT_EQ(builder.worlds[0].options.named.string("searchpath:shader", ""),
              "first:mine:lib:more");
}

TEST_F(State, searchPathsThatAreTooLongAreTold) {
    std::string path;
    for (std::size_t i = 0; i < mostSearchFolders; ++i)
        path += "/f" + std::to_string(i) + ":";
    state.option(at, "searchpath", text("string shader", path));
    EXPECT_EQ(warnings(), 0);
    state.option(at, "searchpath", text("string shader", path + "/more"));
    EXPECT_EQ(warnings(), 1);
    EXPECT_TRUE(says("at most 256 folders"));
}

TEST_F(State, displaysReplaceOrAdd) {
    state.display(at, "a", "file", "rgb", {});
    state.display(at, "b", "file", "rgb", {});
    state.display(at, "+c.png", "png", "rgba", numbers("float[4] quantize", {0, 255, 0, 255}));
    state.quantize(at, "rgba", 255, 0, 255, 0.5f);
    state.worldBegin(at);
    const Options &options = builder.worlds[0].options;
    ASSERT_EQ(options.displays.size(), 2u);
    EXPECT_EQ(options.displays[0].name, "b");
    EXPECT_FALSE(options.displays[0].quantize);
    EXPECT_EQ(options.displays[1].name, "c.png");
    EXPECT_EQ(options.displays[1].quantize->one, 255);
    EXPECT_EQ(options.colorQuantize->ditherAmplitude, 0.5f);
}

TEST_F(State, displaysThatAreAddedBeforeTheFirstOneStay) {
    state.display(at, "+w", "file", "weight", {});
    state.display(at, "a", "file", "rgb", {});
    state.display(at, "+z", "file", "z", {});
    state.worldBegin(at);
    std::vector<std::string> names;
    for (const DisplayRecord &display : builder.worlds[0].options.displays)
        names.push_back(display.name);
    EXPECT_EQ(names, (std::vector<std::string>{"a", "w", "z"}));
}

TEST_F(State, cropWindowsAreTakenInOrderAndWithinTheFrame) {
    state.cropWindow(at, .75f, .25f, -1, 1.5f);
    EXPECT_EQ(errors(), 0);
    EXPECT_TRUE(says("its edges are taken in order"));
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds[0].options.format.cropWindow, (std::array{.25f, .75f, 0.0f, 1.0f}));
}

TEST_F(State, nonsenseInOptionsIsReportedAndHasNoEffect) {
    state.format(at, 0, 10, 1);
    state.frameAspectRatio(at, -1);
    state.screenWindow(at, 0, 0, 0, 1);
    state.cropWindow(at, 0.5f, 0.5f, 0, 1);
    state.cropWindow(at, NAN, 1, 0, 1);
    state.projection(at, "perspective", numbers("fov", {180}));
    state.clipping(at, 2, 1);
    state.depthOfField(at, {{1, 2}});
    state.shutter(at, 1, 0);
    state.pixelSamples(at, 0, 1);
    state.pixelFilter(at, "box", 0, 1);
    state.exposure(at, 1, 0);
    state.quantize(at, "rgba", 1, 3, 2, 0);
    EXPECT_EQ(errors(), 13);
    state.worldBegin(at);
    const Options &options = builder.worlds[0].options, standard;
    EXPECT_EQ(options.format.xResolution, standard.format.xResolution);
    EXPECT_FALSE(options.format.frameAspectRatio || options.format.screenWindow);
    EXPECT_EQ(options.format.cropWindow, standard.format.cropWindow);
    EXPECT_EQ(options.camera.fieldOfView, 90);
    EXPECT_EQ(options.camera.near, standard.camera.near);
    EXPECT_EQ(options.xSamples, 2);
}

TEST_F(State, matteHoldsForItsBlock) {
    state.worldBegin(at);
    state.attributeBegin(at);
    state.matte(at, true);
    state.sphere(at, 1, -1, 1, 360, {});
    state.attributeEnd(at);
    state.sphere(at, 1, -1, 1, 360, {});
    state.worldEnd(at);
    EXPECT_EQ(found.text(), "");
    const auto &primitives = builder.worlds[0].primitives;
    EXPECT_TRUE(primitives[0].attributes->matte);
    EXPECT_FALSE(primitives[1].attributes->matte);
}

TEST_F(State, trimCurvesAreKeptTillTheBlockEnds) {
    state.worldBegin(at);
    const auto patch = [&] {
        state.nuPatch(at, 2, 2, {0, 0, 1, 1}, 0, 1, 2, 2, {0, 0, 1, 1}, 0, 1,
                      numbers("P", Floats(12)));
        return trimOf(*primitives().back().attributes);
    };
    EXPECT_TRUE(patch().empty());
    state.attributeBegin(at);
    state.trimCurve(at, {1}, {2}, {0, 0, 1, 2, 3, 3}, {0}, {3}, {4}, {0, 1, 0, 0}, {0, 0, 1, 0},
                    {1, 1, 1, 1});
    const TrimRecord loops = patch();
    ASSERT_EQ(loops.size(), 1u);
    ASSERT_EQ(loops[0].size(), 1u);
    EXPECT_EQ(loops[0][0].spline.knots.size(), 6u);
    EXPECT_EQ(loops[0][0].u, (Floats{0, 1, 0, 0}));
    EXPECT_EQ(errors(), 0);
    state.trimCurve(at, {1}, {2}, {0, 0, 1}, {0}, {3}, {4}, {0}, {0}, {1}); // Left out.
    EXPECT_EQ(errors(), 1);
    EXPECT_EQ(patch().size(), 1u);
    state.trimCurve(at, {}, {}, {}, {}, {}, {}, {}, {}, {}); // None any more.
    EXPECT_TRUE(patch().empty());
    state.attributeEnd(at);
    EXPECT_TRUE(patch().empty());
    EXPECT_EQ(errors(), 1);
}

} // namespace candela::testing

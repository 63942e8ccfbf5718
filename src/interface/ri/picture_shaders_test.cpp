// SPDX-License-Identifier: Apache-2.0
// PushFilter, PopFilter and Imager: options like others.
#include "interface/ri/graphics_state_fixture.h"

namespace candela::testing {

static std::string namesOf(const std::vector<ShaderRecord> &filters) {
    std::string names;
    for (const ShaderRecord &filter : filters)
        names += filter.name + " ";
    return names;
}

TEST_F(State, filtersAreStackedInTheOrderOfTheirRequests) {
    state.pushFilter(at, "one", {});
    state.pushFilter(at, "two", {});
    state.pushFilter(at, "two", {});
    state.worldBegin(at);
    state.worldEnd(at);
    state.popFilter(at);
    state.pushFilter(at, "three", {});
    state.worldBegin(at);
    EXPECT_EQ(namesOf(builder.worlds[0].options.filters), "one two two ");
    EXPECT_EQ(namesOf(builder.worlds[1].options.filters), "one two three ");
    EXPECT_EQ(errors(), 0);
}

// RI freezes options at WorldBegin; files that were made for others have it behind, for the
// picture.
TEST_F(State, imagersWithinTheWorldCountForItsPicture) {
    state.imager(at, "marble", {});
    state.worldBegin(at);
    state.imager(at, "marble", numbers("scale", {2}));
    EXPECT_EQ(builder.worlds[0].options.imager->parameters.number("scale", 0), 2);
    state.imager(at, "null", {});
    EXPECT_FALSE(builder.worlds[0].options.imager);
    state.worldEnd(at);
    state.worldBegin(at);
    ASSERT_TRUE(builder.worlds[1].options.imager);
    EXPECT_EQ(builder.worlds[1].options.imager->parameters.number("scale", 0), 0);
    EXPECT_EQ(errors() + warnings(), 0);
}

TEST_F(State, framesSaveAndRestoreFiltersAndImager) {
    state.pushFilter(at, "all", {});
    state.imager(at, "clouds", {});
    state.frameBegin(at, 1);
    state.popFilter(at);
    state.pushFilter(at, "first", {});
    state.imager(at, "null", {});
    state.worldBegin(at);
    state.worldEnd(at);
    state.frameEnd(at);
    state.frameBegin(at, 2);
    state.pushFilter(at, "second", {});
    state.worldBegin(at);
    state.worldEnd(at);
    state.frameEnd(at);
    EXPECT_EQ(namesOf(builder.worlds[0].options.filters), "first ");
    EXPECT_FALSE(builder.worlds[0].options.imager);
    EXPECT_EQ(namesOf(builder.worlds[1].options.filters), "all second ");
    ASSERT_TRUE(builder.worlds[1].options.imager);
    EXPECT_EQ(builder.worlds[1].options.imager->name, "clouds");
}

TEST_F(State, filtersAndImagersTakeTheTypesOfTheirShadersParameters) {
    TokenList tokens = numbers("vein", {1, 2, 3});
    tokens.all.push_back({"grain", {}, {}, {"fine"}});
    tokens.all.push_back({"sound", {}, {1}, {}});
    state.pushFilter(at, "marble", tokens);
    state.imager(at, "marble", numbers("scale", {4}));
    state.worldBegin(at);
    const Options &options = builder.worlds[0].options;
    const ParameterList &filter = options.filters[0].parameters;
    ASSERT_EQ(filter.all.size(), 2u);
    EXPECT_EQ(filter.find("vein")->declaration.type, ValueType::Color);
    EXPECT_EQ(filter.string("grain", ""), "fine");
    EXPECT_EQ(options.imager->parameters.number("scale", 0), 4);
    EXPECT_EQ(warnings(), 1);
    EXPECT_TRUE(says("PushFilter: shader 'marble' has no parameter 'sound'")) << found.text();
}

TEST_F(State, anEmptyStackHasNothingToPop) {
    at = {std::make_shared<const std::string>("scene.rib"), 7, 0};
    state.pushFilter(at, "one", {});
    state.popFilter(at);
    state.popFilter(at);
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(says("scene.rib:7: error: PopFilter: there is no filter on the stack"))
        << found.text();
}

TEST_F(State, filtersAreOptionsAndNotForWorlds) {
    state.pushFilter(at, "one", {});
    state.worldBegin(at);
    state.pushFilter(at, "two", {});
    state.popFilter(at);
    state.worldEnd(at);
    EXPECT_EQ(warnings(), 2) << found.text(); // As of other options.
    EXPECT_TRUE(says("PopFilter has no effect between WorldBegin and WorldEnd"));
    state.worldBegin(at);
    EXPECT_EQ(namesOf(builder.worlds[1].options.filters), "one ");
}

/// A picture lies in no space, so that no transformation can flatten its shaders'.
TEST_F(State, pictureShadersDoNotMindFlatTransformations) {
    state.scale(at, 1, 1, 0);
    const std::string before = found.text();
    state.pushFilter(at, "one", {});
    state.imager(at, "clouds", {});
    EXPECT_EQ(found.text(), before);
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
// Bad RIB: each mistake is reported where it stands, and what follows is read all the same.
#include "interface/rib/reading_fixture.h"

namespace candela::testing {

TEST_F(Reading, everyMistakeIsReportedAtItsPlaceAndTheRestIsRead) {
    struct {
        const char *bad, *message;
        int primitives; ///< Beside the disk that follows.
    } cases[] = {
        {"Spere 1 -1 1 360", ":2:1: error: unknown request 'Spere'; did you mean 'Sphere'?", 0},
        {"Foo 1 [2] \"x\" Bar 3", ":2:1: error: unknown request 'Foo'", 0},
        {"3 4 Sphere 1 -1 1 360", ":2:1: error: WorldBegin: expected the next request after 0", 1},
        {"Sphere 1 -1 1",
         ":3:1: error: Sphere: expected a number for 'thetaMax' (argument 4), "
         "found 'Disk'",
         0},
        {"Sphere 1 -1 1 360 5", ":2:19: error: Sphere: expected the name of a parameter", 0},
        {"Sphere [1 -1 1 360 5]", ":2:20: error: Sphere: expected ']', found the number 5", 0},
        {"Translate 1 2 3 4",
         ":2:17: error: Translate: expected the next request after 3 "
         "arguments, found the number 4",
         0},
        {"Sphere 1 \"x\" 1 360",
         ":2:10: error: Sphere: expected a number for 'zMin' (argument 2), "
         "found the string \"x\"",
         0},
        {"Surface matte", ":2:9: error: Surface: expected a string for 'name'", 0},
        {"Sides 1.5", ":2:7: error: Sides: expected a whole number", 0},
        {"Sides 1e30", ":2:7: error: Sides: expected a whole number", 0},
        {"Color [1 0]", ":2:11: error: Color: expected 3 numbers, not 2,", 0},
        {"Illuminate 1.5 1", ":2:12: error: Illuminate: expected a handle", 0},
        {"PointsPolygons [3] [0 1 x] \"P\" [0]", ":2:25: error: PointsPolygons: expected a whole",
         0},
        {"PointsPolygons [3] [0 1 2.5] \"P\" [0]", ":2:25: error: PointsPolygons: expected a wh",
         0},
        {"PointsPolygons 3 \"P\" [0]", ":2:18: error: PointsPolygons: expected '[' and whole", 0},
        {"Surface \"matte", ":2:9: error: unterminated string", 0},
        {"Sphere 1 -1 1 360 \"Cs\"", "parameter 'Cs' has no value", 1},
        {"Sphere 1 -1 1 360 \"Cs\" [1 \"a\"]", "numbers and strings are mixed", 1},
        {"Sphere 1 -1 1 360 \"Cs\" [1 [2] 3]", "expected ']', found '['", 1},
        {"Sphere 1 -1 1 360 \"Cs\" [1 2", "expected ']', found 'Disk'", 1},
        {"Sphere 1 -1 1 360 \"Cs\" [1 2 3]", "'Cs' (varying color) needs 12 numbers", 1},
        {"Sphere 1 -1 1 360 \"constant float x\" 1 2 \"constant float y\" 3",
         "expected the name of a parameter, found the number 2", 1},
        {"Sphere 1 -1 1 360 \"varying clor x\" [1]", "'varying clor x' is no parameter", 1},
        {"Sphere 1 -1 1 360 ]", ":2:19: error: Sphere: expected the name of a parameter", 0},
        {"ReadArchive \"missing.rib\"", "there is no archive 'missing.rib'", 0},
        {"Polygon \"P\" [0 0 0 1 0 0 nan 1 0]",
         ":2:1: error: Polygon: 'P' has values that are "
         "infinite or not a number",
         0},
        {"Polygon \"P\" [0 0 0 1 0 0 1e99 1 0]", "infinite or not a number", 0},
        {"Polygon \"P\" [0 0 0 1 0 0 1.2.3 1 0]", ":2:26: error: '1.2.3' is no number", 0},
        {"Transform [1 2 3]", ":2:17: error: Transform: expected 16 numbers, not 3, for 'matrix'",
         0},
        {"AttributeEnd", ":2:1: error: AttributeEnd without AttributeBegin", 0},
        {"WorldBegin", ":2:1: error: WorldBegin is not legal between", 0},
        {"MotionBegin [0 1] WorldEnd WorldBegin", "MotionBegin at test.rib:2:1 is still open", 0},
        {"Basis \"cubic\" 1 \"bezier\" 3", "'cubic' is unknown", 0},
        {"@ $ %", ":2:1: error: '@' is no part of RIB", 0},
    };
    for (const auto &each : cases) {
        builder.worlds.clear();
        GraphicsStateSettings none;
        DiagnosticList list;
        ErrorPolicy policy(list);
        GraphicsState state(builder, shaders, policy, none);
        RibReader(state, policy)
            .readText(std::string("WorldBegin\n") + each.bad + "\nDisk 0 1 360\nWorldEnd\n",
                      "test.rib");
        state.finish();
        EXPECT_GE(list.count(Severity::Error), 1) << each.bad;
        EXPECT_NE(list.text().find(each.message), std::string::npos) << each.bad << "\n"
                                                                     << list.text();
        ASSERT_FALSE(builder.worlds.empty());
        EXPECT_TRUE(builder.worlds.back().ended) << each.bad;
        EXPECT_EQ(builder.worlds.back().primitives.size(), each.primitives + 1u) << each.bad << "\n"
                                                                                 << list.text();
        EXPECT_TRUE(std::holds_alternative<DiskRecord>(
            builder.worlds.back().primitives.back().record->shape))
            << each.bad;
    }
}

TEST_F(Reading, aFileMayBeginWithNonsense) {
    read("1 \"x\" [ WorldBegin Sphere 1 -1 1 360 WorldEnd");
    EXPECT_EQ(found.text(), "test.rib:1:1: error: expected the name of a request\n");
    EXPECT_EQ(builder.worlds[0].primitives.size(), 1u);
}

TEST_F(Reading, oneMistakeIsOneError) {
    world("Frobnicate 1 2 3 foo bar [4 5] \"x\" baz\nSphere 1 -1 1 360");
    EXPECT_EQ(errors(), 1);
}

TEST_F(Reading, goodParametersAroundABadOneStay) {
    auto scene = world("Sphere 1 -1 1 360 \"constant float a\" 1 \"constant float b\" [\"x\"] "
                       "\"constant float c\" [2 \"y\" [3]] \"constant float d\" 4");
    EXPECT_EQ(errors(), 2);
    ASSERT_EQ(scene.primitives.size(), 1u);
    const ParameterList &variables = scene.primitives[0].record->variables;
    EXPECT_EQ(variables.all.size(), 2u);
    EXPECT_EQ(variables.number("a", 0), 1);
    EXPECT_EQ(variables.number("d", 0), 4);
}

TEST_F(Reading, abortStopsAtTheFirstError) {
    world("Sphere 1 -1 1 360\nWorldEnd\nErrorHandler \"abort\"\nSphere 1\nWorldBegin");
    EXPECT_EQ(errors(), 1);
    EXPECT_EQ(found.count(Severity::Fatal), 1);
    EXPECT_EQ(builder.worlds.size(), 1u);
}

TEST_F(Reading, everyPrefixOfASceneIsSurvived) {
    const std::string scene =
        "##RenderMan RIB\nversion 3.04\nDeclare \"heat\" \"constant float\"\nFormat 8 8 1\n"
        "Projection \"perspective\" \"fov\" 40\nFrameBegin 1\nWorldBegin\n"
        "LightSource \"pointlight\" \"key\\\" \\101\" \"from\" [0 0 1]\n"
        "AttributeBegin\nTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]\n"
        "Basis \"b-spline\" 1 \"bezier\" 3\nSurface \"marble\" \"vein\" [1 0 .5e-1]\n"
        "ObjectBegin 1 Sphere 1 -1 1 360 \"heat\" 3 ObjectEnd\nObjectInstance 1\n"
        "MotionBegin [0 1] Rotate 1 0 0 1 Rotate 2 0 0 1 MotionEnd\n"
        "PointsGeneralPolygons [1] [3] [0 1 2] \"P\" [0 0 0 1 0 0 1 1 0] \"s\" [0 1 1]\n"
        "PatchMesh \"bilinear\" 2 \"periodic\" 2 \"nonperiodic\" \"P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n"
        "AttributeEnd\nWorldEnd\nFrameEnd\n";
    read(scene);
    ASSERT_EQ(errors(), 0) << found.text();
    for (std::size_t length = 0; length < scene.size(); ++length) {
        builder.worlds.clear();
        read(scene.substr(0, length));
        // The last word of the file may be missing in part, no more.
        bool complete = !builder.worlds.empty() && builder.worlds[0].ended;
        EXPECT_EQ(complete, length >= scene.find("WorldEnd") + 8) << length;
    }
}

TEST_F(Reading, damagedBytesAreSurvived) {
    const std::string scene =
        "WorldBegin\nAttributeBegin Color [1 0 0] Surface \"matte\" \"Kd\" .5\n"
        "Polygon \"P\" [0 0 0  1 0 0  1 1 0]\nAttributeEnd\nWorldEnd\n";
    for (std::size_t i = 0; i < scene.size(); ++i)
        for (char c : {'"', '[', ']', '#', '\\', '\n', '\0', '\xff', '-', 'E', '9'}) {
            std::string damaged = scene;
            damaged[i] = c;
            ErrorPolicy policy(found);
            GraphicsState state(builder, shaders, policy);
            RibReader(state, policy).readText(damaged, "test.rib");
            state.finish();
        }
    EXPECT_GT(errors(), 0);
}

TEST_F(Reading, deepNestingIsRefused) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 200000; ++i)
        text += "AttributeBegin\n";
    read(text);
    EXPECT_EQ(found.count(Severity::Fatal), 1);
}

TEST_F(Reading, manyBracketsAreOneMistake) {
    world("Sphere " + std::string(200000, '[') + "\nSphere 1 -1 1 360 \"constant float x\" " +
          std::string(200000, '[') + "\nDisk 0 1 360");
    EXPECT_EQ(errors(), 2);
    EXPECT_EQ(builder.worlds[0].primitives.size(), 2u);
}

} // namespace candela::testing

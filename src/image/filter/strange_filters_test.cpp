// SPDX-License-Identifier: Apache-2.0
// Filters that are not what one expects: refused with a message, or run, but never the end of all.
#include "image/filter/filter_test_support.h"

namespace candela {
namespace {

/// What the text's compilation says; a text without errors is run, too.
std::string saidOf(const std::string &text) {
    DiagnosticList diagnostics;
    if (const auto whole = filterText(text, diagnostics)) {
        ImageMaps maps = testMaps(5, 4);
        CompiledFilter filter(*whole);
        filter.run(maps);
        return diagnostics.text() + filter.diagnostics.text();
    }
    return diagnostics.text();
}

TEST(StrangeFilters, AreRefusedOrRunWithAWord) {
    const struct {
        const char *text, *says;
    } table[] = {
        {"filter f(output float z = 3; output varying color c = 1;)"
         " { z = 4; setimage(\"Ci\", 0, 0, c * z); }",
         ""},
        // Defaults are computed where the text starts.
        {"filter f(float c = image(\"Cs\", 0, 0);) { setimage(\"Ci\", 0, 0, c); }", ""},
        {"float g() { return image(\"Cs\", 0, 0); } filter f(float c = g();)"
         " { setimage(\"Ci\", 0, 0, c); }",
         ""},
        {"float g() { setimage(\"Ci\", 0, 0, 1); return 1; } filter f(float c = g();)"
         " { setimage(\"Ci\", 0, 0, c); }",
         ""},
        {"filter f() { setimage(\"Ci\", 0, 0, diffuse(normal 1)); }", "given a picture"},
        {"filter f() { setimage(\"Ci\", 0, 0, Du(xsize)); }", "given a picture"},
        {"filter f() { setimage(\"Ci\", 0, 0, trace(point 0, vector 1)); }", "given a picture"},
        {"filter f() { setimage(\"\", 0, 0, 1); }", "has a name"},
        {"filter f() { setimage(\"a\\nb\", 0, 0, 1); }", "control character"},
        {"filter f() { setimage(\"Cs\", 0, 0, 1); }", "\"Ci\""},
        {"filter f() { string s = \"a\"; if (image(\"Z\", 0, 0) > .5) s = \"b\";"
         " setimage(s, 0, 0, 1); }",
         "known when the shader is compiled"},
        {"filter f() { setimage(\"Z\", 0, 0, color 1); }", "filter \"f\" is left out"},
        {"filter f() { setimage(\"Ci\", 0, 0, image(\"nobody\", 0, 0)); }", "no map \"nobody\""},
        {"filter f() { setsize(\"m\", 2, 2); setimage(\"Ci\", 0, 0, image(\"m\", 0, 0)); }", ""},
        {"filter f() { setimage(\"Ci\", 0, 0, image(\"Cs\", 0, 0, \"channel\")); }", "value"},
        {"filter f() { setimage(\"Ci\", 0, 0, image(\"Cs\", 0, 0, \"filter\", \"x\")); }",
         "nearest"},
        {"surface f() { Ci = image(\"Cs\", 0, 0); }", "for filter shaders"},
    };
    for (const auto &[text, says] : table) {
        const std::string said = saidOf(text);
        EXPECT_EQ(said.empty(), *says == 0) << text << "\n" << said;
        EXPECT_NE(said.find(says), said.npos) << text << "\n" << said;
    }
}

/// The picture stays as it was, and no time is spent on one that cannot be.
TEST(StrangeFilters, WithoutTheirMapsAreLeftOut) {
    for (const char *size : {"1e9, 1e9", "-1, 5", "0, 0", "0 / 0, 1"}) {
        DiagnosticList diagnostics;
        const auto whole =
            filterText(std::string("filter f() { float x, y, z = xsize - xsize; setsize(\"Ci\", ") +
                           (std::string(size) == "0 / 0, 1" ? "z / z, 1" : size) +
                           "); for (y = 0; y < 1e9; y += 1) for (x = 0; x < 1e9; x += 1)"
                           " setimage(\"Ci\", x, y, 5); }",
                       diagnostics);
        ASSERT_TRUE(whole) << diagnostics.text();
        ImageMaps maps = testMaps(5, 4);
        const std::vector<float> before = maps.plane("Ci", 2);
        CompiledFilter filter(*whole);
        filter.run(maps);
        EXPECT_EQ(maps.plane("Ci", 2), before) << size;
        EXPECT_NE(filter.diagnostics.text().find("left out"), std::string::npos) << size;
    }
}

/// Beyond the border all pixels are as the border's.
TEST(StrangeFilters, LookFarBeyondTheBorder) {
    for (const char *name : {"box", "triangle", "gaussian", "catmull-rom", "bilinear", "nearest"})
        for (const char *place : {"-20, 2", "1e30, 2", "7 + 3, 2", "-1e30, 2"}) {
            DiagnosticList diagnostics;
            const auto whole = filterText(
                std::string("filter f() { setimage(\"Ci\", 0, 0, image(\"Cs\", ") + place +
                    ", \"filter\", \"" + name + "\", \"width\", 3, \"ywidth\", .001)); }",
                diagnostics);
            ASSERT_TRUE(whole) << diagnostics.text();
            ImageMaps maps = testMaps(5, 4);
            const OwnedImage given = testPicture(5, 4);
            CompiledFilter(*whole).run(maps);
            if (std::string(name) == "box" || std::string(name) == "nearest" ||
                std::string(name) == "bilinear")
                EXPECT_NEAR(maps.find("Ci")->row(0, 0)[0], given.row(0, 2)[*place == '-' ? 0 : 4],
                            1e-6)
                    << name << " " << place;
            else
                EXPECT_TRUE(std::isfinite(maps.find("Ci")->row(0, 0)[0]));
        }
}

/// Many maps in one loop: code grows with their number, and the time to make it with the code.
TEST(StrangeFilters, OfManyMapsAreCompiledInTime) {
    std::string text = "filter f() { float x, y; for (y = 0; y < ysize; y += 1)"
                       " for (x = 0; x < xsize; x += 1) {";
    for (int k = 0; k < 60; ++k) {
        const std::string name = "\"m" + std::to_string(k) + "\"";
        text += " setimage(" + name + ", x, y, color image(" + name + ", x, y) + x);";
    }
    DiagnosticList diagnostics;
    const auto whole = filterText(text + " } }", diagnostics);
    ASSERT_TRUE(whole) << diagnostics.text();
    ImageMaps expected = testMaps(37, 4), got = testMaps(37, 4);
    interpretFilter(*whole, expected, diagnostics);
    CompiledFilter(*whole).run(got);
    for (const char *name : {"m0", "m31", "m59"})
        EXPECT_EQ(got.plane(name, 1), expected.plane(name, 1)) << name;
}

} // namespace
} // namespace candela

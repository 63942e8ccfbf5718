// SPDX-License-Identifier: Apache-2.0
// What loops are pixel loops, and that those which are give what the text says.
#include "foundation/base/parallel.h"
#include "image/filter/filter_test_support.h"

#include <array>

namespace candela {
namespace {

#define ALL_PIXELS "for (y = 0; y < ysize; y += 1) for (x = 0; x < xsize; x += 1) "
#define BY_COLUMNS "for (x = 0; x < xsize; x += 1) for (y = 0; y < ysize; y += 1) "

struct Row {
    const char *name, *body;
    int loops; ///< How many of them are pixel loops.
};

const Row rows[] = {
    // One pixel to one pixel
    {"copy", ALL_PIXELS "setimage(\"Ci\", x, y, image(\"Cs\", x, y));", 1},
    {"byColumns", BY_COLUMNS "setimage(\"Ci\", x, y, 2 * image(\"Cs\", x, y));", 1},
    {"closed",
     "for (y = 0; y <= ysize - 1; y += 1) for (x = 0; x <= xsize - 1; x += 1)"
     " setimage(\"Ci\", x, y, 1 - image(\"Cs\", x, y));",
     1},
    {"part",
     "for (y = 2; y < ysize - 3; y += 1) for (x = 5; x < xsize - 1; x += 1)"
     " setimage(\"Ci\", x, y, color(x, y, 0));",
     1},
    {"beyondTheBorder",
     "for (y = -3; y < ysize + 3; y += 1) for (x = -7; x < xsize + 40; x += 1)"
     " setimage(\"Ci\", x, y, image(\"Cs\", x + 1, y - 1));",
     1},
    {"condition", ALL_PIXELS "if (image(\"Cs\", x, y) < .5) setimage(\"Ci\", x, y, 7);", 1},
    {"fractions",
     ALL_PIXELS "setimage(\"Ci\", x + .3, y - .4, image(\"Cs\", x * .5 + .25, y * .5));", 1},
    {"flip", ALL_PIXELS "setimage(\"Ci\", xsize - 1 - x, y, image(\"Cs\", x, y));", 1},
    {"transposed",
     "setsize(\"Ci\", ysize, xsize);" ALL_PIXELS "setimage(\"Ci\", y, x, image(\"Cs\", x, y));", 1},
    {"own", ALL_PIXELS "setimage(\"Ci\", x, y, .5 * color image(\"Ci\", x, y));", 1},
    {"float", ALL_PIXELS "setimage(\"Ci\", x, y, float image(\"Z\", x, y));", 1},
    {"channel", ALL_PIXELS "setimage(\"Ci\", x, y, float image(\"Cs\", x, y, \"channel\", 2));", 1},
    {"pastTheLastChannel",
     ALL_PIXELS "setimage(\"Ci\", x, y, color image(\"Cs\", x, y, \"channel\", 1));", 1},
    {"depthAsColor", ALL_PIXELS "setimage(\"Ci\", x, y, color image(\"Z\", x, y));", 1},
    // Neighbourhoods
    {"box",
     ALL_PIXELS "{ color c = 0; float i, j; for (j = -2; j <= 2; j += 1)"
                " for (i = -2; i <= 2; i += 1) c += image(\"Cs\", x + i, y + j);"
                " setimage(\"Ci\", x, y, c / 25); }",
     1},
    {"wide",
     ALL_PIXELS "{ color c = 0; float i; for (i = -45; i <= 45; i += 1)"
                " c += image(\"Cs\", x - i, y); setimage(\"Ci\", x, y, c / 91); }",
     1},
    {"halves",
     ALL_PIXELS "{ color c = 0; float i; for (i = -1.5; i <= 1.5; i += 1)"
                " c += image(\"Cs\", x + i, y + i); setimage(\"Ci\", x, y, c / 4); }",
     1},
    {"dependentPlace",
     ALL_PIXELS "{ float r = 3 * float image(\"Z\", x, y);"
                " setimage(\"Ci\", x, y, image(\"Cs\", x + r, y)); }",
     1},
    {"dependentTurns",
     ALL_PIXELS "{ float i = 0, n = 9 * float image(\"Z\", x, y); color c = 0;"
                " while (i < n) { c += image(\"Cs\", x + i, y); i += 1; }"
                " setimage(\"Ci\", x, y, c); }",
     1},
    {"filtered",
     ALL_PIXELS "setimage(\"Ci\", x, y, image(\"Cs\", x, y, \"filter\", \"gaussian\","
                " \"width\", 5));",
     1},
    {"ownArray",
     ALL_PIXELS "{ float a[9], i; for (i = 0; i < 9; i += 1)"
                " a[i] = image(\"Z\", x + i - 4, y);"
                " setimage(\"Ci\", x, y, a[floor(8 * float image(\"Z\", x, y))]); }",
     1},
    {"asks",
     ALL_PIXELS "{ float v = 3, known = option(\"nosuch\", v);"
                " setimage(\"Ci\", x, y, image(\"Cs\", x, y) + known + v); }",
     1},
    // From one loop to the next
    {"twoPasses",
     ALL_PIXELS "setimage(\"t\", x, y, image(\"Cs\", x, y) * 2);" ALL_PIXELS
                "setimage(\"Ci\", x, y, image(\"t\", x + 1, y + 1));",
     2},
    {"floatMap",
     ALL_PIXELS "setimage(\"t\", x, y, float image(\"Z\", x, y));" ALL_PIXELS
                "setimage(\"Ci\", x, y, color image(\"t\", x - 1, y));",
     2},
    {"repeated",
     "float k; for (k = 0; k < 3; k += 1) {" ALL_PIXELS
     "setimage(\"t\", x, y, image(\"Ci\", x + 1, y));" ALL_PIXELS
     "setimage(\"Ci\", x, y, image(\"t\", x, y + k)); }",
     2},
    {"table",
     "float a[40], i; for (i = 0; i < 40; i += 1) a[i] = i * i;" ALL_PIXELS
     "setimage(\"Ci\", x, y, a[floor(39 * float image(\"Z\", x, y))]);",
     1},
    {"alongRows",
     "for (y = 0; y < ysize; y += 1) { color s = 0;"
     " for (x = 0; x < xsize; x += 1) { s = .5 * s + image(\"Cs\", x, y);"
     " setimage(\"Ci\", x, y, s); } }",
     1},
    {"perRow",
     "for (y = 0; y < ysize; y += 1) { float w = y / ysize;"
     " for (x = 0; x < xsize; x += 1) setimage(\"Ci\", x, y, w); }",
     1},
    {"rowsOfTheirOwn",
     "for (y = 0; y < ysize; y += 1) { color s = 0;"
     " for (x = 0; x < xsize; x += 1) s += image(\"Ci\", x, y);"
     " for (x = 0; x < xsize; x += 1) setimage(\"Ci\", x, y, s); }",
     1},
    // Rows that do not see each other, of pixels that do
    {"inRows", ALL_PIXELS "setimage(\"Ci\", x, y, .5 * color image(\"Ci\", x - 1, y));", 1},
    {"inColumns", ALL_PIXELS "setimage(\"Ci\", x, y, .5 * color image(\"Ci\", x, y - 1));", 1},
    {"sameInRows", ALL_PIXELS "setimage(\"Ci\", floor(x / 2), y, image(\"Cs\", x, y));", 1},
    {"twoInRows", ALL_PIXELS "{ setimage(\"Ci\", x, y, 1); setimage(\"Ci\", x + 1, y, 2); }", 1},
    {"oneRow", "y = 5; for (x = 0; x < xsize; x += 1) setimage(\"Ci\", x, 3, image(\"Cs\", x, y));",
     1},
    // Sums, of whole numbers: exact in whatever order
    {"sum",
     "float s;" ALL_PIXELS "s += floor(99 * float image(\"Cs\", x, y));" ALL_PIXELS
     "setimage(\"Ci\", x, y, s);",
     2},
    {"count",
     "float n = 5;" ALL_PIXELS "if (image(\"Z\", x, y) > .5) n += 1;" ALL_PIXELS
     "setimage(\"Ci\", x, y, n);",
     2},
    {"difference",
     "float n = 5;" ALL_PIXELS "n -= floor(99 * float image(\"Z\", x, y));" ALL_PIXELS
     "setimage(\"Ci\", x, y, n);",
     2},
    {"extremes",
     "float l = 1e9, g = -1e9, h = -1;" ALL_PIXELS
     "{ float v = image(\"Z\", x, y); l = min(l, v); g = max(v, g);"
     " if (v > h) h = v; }" ALL_PIXELS "setimage(\"Ci\", x, y, color(l, g, h));",
     2},
    {"sumOfLoops",
     "float n = 0;" ALL_PIXELS "{ float i; for (i = 0; i < x; i += 1)"
     " n += floor(9 * float image(\"Z\", i, y)); }" ALL_PIXELS "setimage(\"Ci\", x, y, n);",
     2},
    // None
    {"pastTurn",
     "color s = 0;" ALL_PIXELS "{ s = .5 * s + image(\"Cs\", x, y);"
     " setimage(\"Ci\", x, y, s); }",
     0},
    {"runningSum",
     "color s = 0;" ALL_PIXELS "{ s += image(\"Cs\", x, y);"
     " setimage(\"Ci\", x, y, s); }",
     0},
    {"inPlace", ALL_PIXELS "setimage(\"Ci\", x, y, .5 * color image(\"Ci\", x - 1, y - 1));", 0},
    {"inPlaceBetween",
     ALL_PIXELS "setimage(\"Ci\", x + .4, y + .4, .5 * color image(\"Ci\", x + .4, y + .4));", 0},
    {"sameTarget", ALL_PIXELS "setimage(\"Ci\", floor(x / 2), y / 3, image(\"Cs\", x, y));", 0},
    {"smallSteps", ALL_PIXELS "setimage(\"Ci\", .5 * x, .5 * y, image(\"Cs\", x, y));", 0},
    {"twoTargets", ALL_PIXELS "{ setimage(\"Ci\", x, y, 1); setimage(\"Ci\", x + 1, y + 1, 2); }",
     0},
    {"scattered",
     ALL_PIXELS "setimage(\"Ci\", 20 * float image(\"Z\", x, y), 9 * float image(\"Z\", y, x), x);",
     0},
    {"histogram",
     "float a[16];" ALL_PIXELS "a[floor(15 * float image(\"Z\", x, y))] += 1;"
     "for (x = 0; x < xsize; x += 1) setimage(\"Ci\", x, 0, a[mod(x, 16)]);",
     1},
    {"lineBuffer",
     "float a[64];" ALL_PIXELS "{ a[x] = .5 * a[x] + float image(\"Z\", x, y);"
     " setimage(\"Ci\", x, y, a[x]); }",
     0},
    {"lastValue", "float v;" ALL_PIXELS "v = image(\"Z\", x, y); setimage(\"Ci\", 1, 1, v);", 0},
    {"counterBehind", ALL_PIXELS "setimage(\"Ci\", x, y, 3); setimage(\"Ci\", 2, 2, x);", 0},
    {"steps",
     "for (y = 0; y < ysize; y += 2) for (x = 0; x < xsize; x += 3)"
     " setimage(\"Ci\", x, y, 3);",
     0},
    {"broken", ALL_PIXELS "{ if (x > 4) break; setimage(\"Ci\", x, y, 3); }", 1},
    {"noPixels", "float s = 0;" ALL_PIXELS "s += x * y; setimage(\"Ci\", 0, 0, s);", 0},
};

std::string textOf(const Row &row) {
    return std::string("filter f() { float x, y; ") + row.body + " }";
}

/// The size, then the values of all maps.
std::vector<float> valuesOf(const ImageMaps &maps) {
    std::vector<float> all;
    for (const std::string &name : maps.names())
        for (int c = 0; c < maps.find(name)->channels(); ++c) {
            const std::vector<float> plane = maps.plane(name, c);
            all.push_back(float(maps.find(name)->width()));
            all.insert(all.end(), plane.begin(), plane.end());
        }
    return all;
}

class PixelLoops : public testing::TestWithParam<Row> {};

TEST_P(PixelLoops, AreThoseThatMayBeAndGiveWhatTheTextSays) {
    const Row &row = GetParam();
    DiagnosticList diagnostics;
    const auto whole = filterText(textOf(row), diagnostics);
    ASSERT_TRUE(whole) << diagnostics.text();
    std::map<int, std::unique_ptr<CompiledFilter>> compiled;
    for (const int width : {1, laneBlock})
        compiled[width] = std::make_unique<CompiledFilter>(*whole, width);
    EXPECT_EQ(compiled[1]->code->driver().pixelLoops.size(), std::size_t(row.loops));
    for (const auto &[columns, height] : {std::pair(37, 21), std::pair(1, 1), std::pair(3, 2),
                                          std::pair(16, 5), std::pair(100, 3)}) {
        ImageMaps expected = testMaps(columns, height);
        interpretFilter(*whole, expected, diagnostics);
        std::optional<std::vector<float>> first;
        for (auto &[width, filter] : compiled)
            for (const int threads : {1, 3}) {
                const ThreadLimit limit(threads);
                ImageMaps maps = testMaps(columns, height);
                filter->run(maps);
                const std::vector<float> got = valuesOf(maps), wanted = valuesOf(expected);
                ASSERT_EQ(got.size(), wanted.size());
                for (std::size_t k = 0; k < got.size(); ++k)
                    ASSERT_EQ(got[k], wanted[k])
                        << k << " of " << columns << " x " << height << ", " << width << " lanes";
                EXPECT_EQ(got, first.value_or(got)) << "by lanes or threads";
                first = got;
            }
    }
    EXPECT_EQ(diagnostics.text(), "");
}

INSTANTIATE_TEST_SUITE_P(Table, PixelLoops, testing::ValuesIn(rows),
                         [](const auto &info) { return std::string(info.param.name); });

/// Pictures that no cache holds are set past the caches; the next loop sees what was set, also
/// where rows do not begin on a line of the cache.
TEST(PixelLoops, LargePicturesAreSetWhole) {
    DiagnosticList diagnostics;
    const auto whole = filterText("filter f() { float x, y; " ALL_PIXELS
                                  "setimage(\"t\", x, y, 2 * color image(\"Cs\", x, y));"
                                  "for (y = 1; y < ysize; y += 1) for (x = 3; x < xsize; x += 1)"
                                  " setimage(\"Ci\", x - 3, y, color image(\"t\", x, y - 1)); }",
                                  diagnostics);
    ASSERT_TRUE(whole) << diagnostics.text();
    const int width = 2060, height = 2100;
    for (const int lanes : {1, laneBlock}) {
        ImageMaps maps;
        maps.set("Ci", testPicture(width, height));
        const OwnedImage given = testPicture(width, height);
        CompiledFilter filter(*whole, lanes);
        EXPECT_EQ(filter.code->driver().pixelLoops.size(), 2u);
        filter.run(maps);
        const OwnedImage &made = *maps.find("Ci");
        for (int c = 0; c < 3; ++c)
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    if (y == 0 || x >= width - 3)
                        ASSERT_EQ(made.row(c, y)[x], given.row(c, y)[x]) << x << " " << y;
                    else
                        ASSERT_EQ(made.row(c, y)[x], 2 * given.row(c, y - 1)[x + 3])
                            << x << " " << y;
    }
}

/// Texts that would keep the proofs busy for ever, or end their stack.
TEST(PixelLoops, LongTextsAreReadInTime) {
    std::string squares = "filter f() { float x, y, t = .5; ",
                sums = "filter f() { float x, y, s; ";
    squares += ALL_PIXELS "{ float u = t * y;";
    for (int k = 0; k < 60; ++k)
        squares += " u = u * u + t;";
    squares += " setimage(\"Ci\", x + u, y, 1); }}";
    sums += ALL_PIXELS "{ float v = image(\"Cs\", x, y);";
    for (int k = 0; k < 9000; ++k)
        sums += " s += v;";
    sums += "} setimage(\"Ci\", 0, 0, s); }";
    for (const std::string &text : {squares, sums}) {
        DiagnosticList diagnostics;
        const auto whole = filterText(text, diagnostics);
        ASSERT_TRUE(whole) << diagnostics.text();
        ImageMaps expected = testMaps(5, 3), got = testMaps(5, 3);
        interpretFilter(*whole, expected, diagnostics);
        CompiledFilter(*whole).run(got);
        EXPECT_EQ(got.plane("Ci", 1), expected.plane("Ci", 1));
    }
}

/// Many rows, of which cores take portions: a sum is what it is, and exact where a float would have
/// stopped counting.
TEST(PixelLoops, SumsDoNotStopGrowing) {
    DiagnosticList diagnostics;
    const auto whole = filterText("filter f() { float x, y, n = 0; " ALL_PIXELS "n += 1;" ALL_PIXELS
                                  "if (image(\"Cs\", x, y) < 2) n += 1;"
                                  "setimage(\"Ci\", 0, 0, n); }",
                                  diagnostics);
    ASSERT_TRUE(whole) << diagnostics.text();
    ImageMaps maps;
    maps.set("Ci", OwnedImage(6000, 3000, 3));
    CompiledFilter filter(*whole);
    filter.run(maps);
    EXPECT_GE(filter.code->driver().pixelLoops.size(), 1u);
    // The first loop reads no pixels and counts in floats, to 2^24.
    EXPECT_EQ(maps.find("Ci")->row(0, 0)[0], 16777216.f + 18000000.f);
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// texture() by closed forms: coordinates, channels, what lies beyond a picture, what numbers of
// files are, what is looked up of files that are not there.
#include "tests/textures/pictures.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Lookup {
    const char *expression;
    float expected, within;
};

/// Linear in s and t, which every filter keeps; and pictures of one colour.
void writePictures(const ScratchFolder &folder) {
    writeExr(folder, "ramps.exr", 64, 64, {"R", "G", "B", "A"}, [](int x, int y, int c) {
        const float values[] = {(float(x) + 0.5f) / 64, (float(y) + 0.5f) / 64, 0.25f, 0.5f};
        return values[c];
    });
    writeExr(folder, "grey.exr", 8, 8, {"Y"}, [](int, int, int) { return 0.3f; });
    writeExr(folder, "step.exr", 256, 256, {"Y"},
             [](int x, int, int) { return x < 128 ? 0.0f : 1.0f; });
    writeEightBit(folder, "colour.tga", 8, 8, 3, [](int, int, int c) { return c ? 188 : 10; });
    writeEightBit(folder, "mask.tga", 8, 8, 1, [](int, int, int) { return 128; });
    const Pixels half = [](int, int, int) { return 32768; };
    writeSixteenBit(folder, "sixteen.png", 8, 8, std::nullopt, half);
    writeSixteenBit(folder, "gamma.png", 8, 8, 2.0f, half);
    // Half black, half white: their mean is light's.
    writeEightBit(folder, "stripes.tga", 64, 64, 3,
                  [](int x, int, int) { return x % 2 ? 255 : 0; });
}

const std::string requests =
    "MakeTexture \"ramps.exr\" \"periodic.tx\" \"periodic\" \"periodic\" \"box\" 1 1\n"
    "MakeTexture \"ramps.exr\" \"clamp.tx\" \"clamp\" \"clamp\" \"box\" 1 1\n"
    "MakeTexture \"ramps.exr\" \"black.tx\" \"black\" \"black\" \"box\" 1 1\n"
    "MakeTexture \"ramps.exr\" \"mixed.tx\" \"black\" \"periodic\" \"gaussian\" 2 2\n"
    "MakeTexture \"colour.tga\" \"linear.tx\" \"clamp\" \"clamp\" \"box\" 1 1 "
    "\"string colorspace\" [\"linear\"]\n"
    "MakeTexture \"colour.tga\" \"decoded.tx\" \"clamp\" \"clamp\" \"box\" 1 1\n"
    "MakeTexture \"mask.tga\" \"photo.tx\" \"clamp\" \"clamp\" \"box\" 1 1 "
    "\"string colorspace\" [\"srgb\"]\n";

const Lookup lookups[] = {
    // Places: s to the right, t down, the surface's where none are given.
    {"float texture(\"ramps.exr\", .25, .75)", .25f, 1e-3f},
    {"float texture(\"ramps.exr\"[1], .25, .75)", .75f, 1e-3f},
    {"float texture(\"ramps.exr\")", .5f, 1e-3f},
    {"float texture(\"ramps.exr\"[1], .25, .25, .5, .25, .25, .75, .5, .75)", .5f, 1e-3f},
    {"float texture(\"ramps.exr\", .25, .25, .5, .25, .25, .75, .5, .75)", .375f, 1e-3f},
    // Channels.
    {"float texture(\"ramps.exr\"[2], .5, .5)", .25f, 1e-3f},
    {"float texture(\"ramps.exr\"[3], .5, .5)", .5f, 1e-3f},
    {"float texture(\"ramps.exr\"[4], .5, .5)", 0, 0},
    {"float texture(\"ramps.exr\"[4], .5, .5, \"fill\", .75)", .75f, 0},
    {"comp(color texture(\"ramps.exr\", .25, .75), 1)", .75f, 1e-3f},
    {"comp(color texture(\"ramps.exr\"[1], .25, .75), 2)", .5f, 1e-3f},
    {"comp(color texture(\"grey.exr\", .25, .75), 2)", .3f, 1e-3f},
    {"comp(color texture(\"grey.exr\"[1], .25, .75, \"fill\", .5), 2)", .5f, 1e-3f},
    // Beyond the picture.
    {"float texture(\"periodic.tx\", 1.25, -.5)", .25f, 1e-3f},
    {"float texture(\"clamp.tx\", 1.25, .5)", .9922f, 1e-3f},
    {"float texture(\"clamp.tx\"[1], .5, -7)", .0078f, 1e-3f},
    {"float texture(\"black.tx\", 1.25, .5)", 0, 0},
    {"float texture(\"mixed.tx\", .5, 3.25)", .5f, 1e-3f},
    {"float texture(\"mixed.tx\", 1.5, 3.25)", 0, 0},
    {"float texture(\"ramps.exr\", -2.75, .5)", .25f, 1e-3f},
    {"float texture(\"ramps.exr\", 1e30, 1e38 * 1e38)", .5f, .5f},
    // Filters: a ramp keeps its mean, a step is as blurred as is said.
    {"float texture(\"ramps.exr\", .5, .5, \"blur\", .25)", .5f, 1e-2f},
    {"float texture(\"step.exr\", .45, .5, \"width\", 0)", 0, 0},
    {"float texture(\"step.exr\", .45, .5, \"sblur\", .3, \"filter\", \"box\")", .333f, .08f},
    {"float texture(\"step.exr\", .25, .5, \"blur\", .1)", 0, .02f},
    {"float texture(\"stripes.tga\", .5, .5, \"blur\", .5)", .5f, .01f},
    // Footprints that are lines, blurred.
    {"float texture(\"ramps.exr\", s, .5, \"blur\", .1)", .5f, 1e-2f},
    {"float texture(\"ramps.exr\"[1], .5, .25 + s + t - 1, \"tblur\", .1)", .25f, 1e-2f},
    {"float texture(\"ramps.exr\", .5 + .3 * (s - t), .5 + .1 * (s - t), \"blur\", .1)", .5f,
     1e-2f},
    {"float texture(\"ramps.exr\", .5 + 90 * (s - t), .5 - 9 * (s - t), \"blur\", .1)", .5f, 2e-2f},
    {"float texture(\"step.exr\", .45 + .01 * (s - .5), .5, \"sblur\", .3)", .333f, .08f},
    {"Du(float texture(\"ramps.exr\", s + t - .5, s + t - .5, \"blur\", .1))", 1, .1f},
    {"comp(environment(\"grey.exr\", vector(cos(s + t), sin(s + t), 0), \"blur\", .1), 1)", .3f,
     1e-3f},
    // Numbers become light.
    {"float texture(\"colour.tga\", .5, .5)", .003035f, 1e-5f},
    {"float texture(\"colour.tga\"[1], .5, .5)", .50289f, 5e-4f},
    {"float texture(\"decoded.tx\"[1], .5, .5)", .50289f, 5e-4f},
    {"float texture(\"linear.tx\"[1], .5, .5)", .73725f, 5e-4f},
    {"float texture(\"mask.tga\", .5, .5)", .50196f, 5e-4f},
    {"float texture(\"photo.tx\", .5, .5)", .21586f, 5e-4f},
    {"float texture(\"sixteen.png\", .5, .5)", .5f, 5e-4f},
    {"float texture(\"gamma.png\", .5, .5)", .25f, 5e-4f},
};

TEST(Lookups, AreWhatThePicturesHold) {
    ScratchFolder folder;
    writePictures(folder);
    std::vector<std::string> expressions;
    for (const Lookup &lookup : lookups)
        expressions.emplace_back(lookup.expression);
    for (const char *lanes : {"1", "16"}) {
        const Told told = tell(folder, {expressions, "", requests, lanes});
        EXPECT_EQ(told.run.status, 0) << told.run.text();
        EXPECT_EQ(told.run.errBesidesLight(), "");
        ASSERT_EQ(told.values.size(), expressions.size()) << told.run.text();
        for (std::size_t k = 0; k < expressions.size(); ++k)
            EXPECT_NEAR(told.values[k], lookups[k].expected, lookups[k].within) << expressions[k];
    }
}

TEST(Lookups, ThatGoWrongAreZeroAndSaidOnce) {
    ScratchFolder folder;
    writePictures(folder);
    folder.write("broken.exr", folder.read("ramps.exr").substr(0, 900));
    folder.write("words.png", "This is no picture.");
    const std::string grey = folder.read("grey.exr");
    std::string huge = folder.read("mask.tga");
    huge.replace(12, 4, "\x30\x75\x30\x75"); // 30000 pixels square, says the head.
    folder.write("huge.tga", huge);
    const Told told = tell(
        folder,
        {{"float texture(\"missing.tx\", .5, .5)", "float texture(\"missing.tx\", .2, .5)",
          "float texture(\"\", .5, .5)", "float texture(\"words.png\", .5, .5)",
          "float texture(\"broken.exr\", .5, .5)", "float texture(\"grey.tx\", .5, .5)",
          "comp(environment(\"missing.env\", vector(0, 0, 1)), 0)", "shadow(\"missing.shd\", P)",
          "shadow(\"grey.exr\", P)", "float texture(\"grey.exr\", .5, .5, \"blurr\", 1)",
          "float texture(\"huge.tga\", .5, .5)"},
         "",
         "MakeTexture \"nothing.tif\" \"no.tx\" \"black\" \"black\" \"box\" 1 1\n"
         "MakeTexture \"words.png\" \"no.tx\" \"wavy\" \"black\" \"box\" 1 1\n"
         "MakeShadow \"grey.exr\" \"no.shd\"\n"
         "MakeTexture \"grey.exr\" \"../outside.tx\" \"black\" \"black\" \"box\" 1 1\n"
         "MakeTexture \"grey.exr\" \"grey.exr\" \"black\" \"black\" \"box\" 1 1\n"});
    EXPECT_EQ(told.values.size(), 11u) << told.run.text();
    for (std::size_t k = 0; k < told.values.size(); ++k)
        EXPECT_NEAR(told.values[k], k == 5 || k == 9 ? .3f : 0, 1e-3f) << k;
    const Outcome &run = told.run;
    EXPECT_EQ(run.status, 1) << "MakeTexture of nothing is an error";
    EXPECT_TRUE(folder.has("telling.exr"));
    EXPECT_FALSE(folder.has("no.tx") || folder.has("no.shd"));
    EXPECT_EQ(folder.read("grey.exr"), grey);
    for (const char *words :
         {"telling.sl:3: warning: texture \"missing.tx\": there is no such file",
          "texture \"words.png\": ", "texture \"broken.exr\": ",
          "texture \"grey.tx\": there is no such file; ", "texture \"missing.env\": ",
          "texture \"missing.shd\": ", "texture \"grey.exr\": ", "no parameter \"blurr\"",
          "scene.rib:1:1: error: MakeTexture: there is no picture \"nothing.tif\"",
          "scene.rib:2:1: error: MakeTexture: there is no wrap mode \"wavy\"",
          "scene.rib:3:1: error: MakeShadow: ", "need --trust",
          "huge.tga cannot be read: it claims more than can be",
          "scene.rib:5:1: error: MakeTexture: the texture would take the place of "})
        EXPECT_TRUE(run.says(words)) << words << "\n" << run.err;
    const auto first = run.err.find("\"missing.tx\"");
    EXPECT_EQ(run.err.find("\"missing.tx\"", first + 1), std::string::npos) << run.err;
    const std::string line = run.err.substr(first, run.err.find('\n', first) - first);
    EXPECT_EQ(line.find(folder.path()), line.rfind(folder.path())) << line;
}

/// Readers believe headers, and throw; or take what these claim.
TEST(Lookups, OfFilesThatClaimWhatTheyHaveNot) {
    ScratchFolder folder;
    writePictures(folder);
    folder.write("large.gif", std::string("GIF89a\xff\xff\xff\xff\x80\0\0\0\0\0\0\0\0"
                                          "\x2c\0\0\0\0\xff\xff\xff\xff\0\2",
                                          30) +
                                  std::string(5000, '\0'));
    std::string exr = folder.read("grey.exr"); // One more entry, of two gigabytes, it says.
    exr.insert(8, std::string("note\0string\0\xff\xff\xff\x7f", 16));
    folder.write("large.exr", exr);
    const Told told = tell(
        folder, {{"float texture(\"large.gif\", .5, .5)", "float texture(\"large.exr\", .5, .5)",
                  "float texture(\"grey.exr\", .5, .5)"},
                 "",
                 "MakeTexture \"large.gif\" \"no.tx\" \"black\" \"black\" \"box\" 1 1\n"
                 "MakeTexture \"large.exr\" \"no.tx\" \"black\" \"black\" \"box\" 1 1\n"});
    ASSERT_EQ(told.values.size(), 3u) << told.run.text();
    EXPECT_EQ(told.values[0], 0);
    EXPECT_EQ(told.values[1], 0);
    EXPECT_NEAR(told.values[2], .3f, 1e-3f);
    EXPECT_EQ(told.run.status, 1);
    EXPECT_TRUE(told.run.says("large.gif cannot be read: ")) << told.run.err;
    EXPECT_TRUE(told.run.says("large.exr cannot be read: it claims more")) << told.run.err;
    EXPECT_FALSE(folder.has("no.tx"));
}

/// Names are known where a loop's turns are: from a table, put together, with breaks.
TEST(Lookups, NamesMayBeChosenInLoops) {
    ScratchFolder folder;
    writePictures(folder);
    writeExr(folder, "layer1.exr", 8, 8, {"Y"}, [](int, int, int) { return 0.5f; });
    writeExr(folder, "layer2.exr", 8, 8, {"Y"}, [](int, int, int) { return 0.25f; });
    for (const char *lanes : {"1", "16"}) {
        const Told told = tell(
            folder,
            {{"sum", "made", "stopped", "nested", "same"},
             "uniform string names[3] = {\"grey.exr\", \"layer1.exr\", \"layer2.exr\"};\n"
             "uniform float i, k; float sum = 0, made = 0, stopped = 0, nested = 0, same = 0;\n"
             "for (i = 0; i < 3; i += 1) sum += float texture(names[i], .5, .5);\n"
             "for (i = 1; i <= 2; i += 1) {\n"
             "    uniform string name = concat(\"layer\", format(\"%d\", i), \".exr\");\n"
             "    made += i * float texture(name, .5, .5);\n"
             "}\n"
             "for (i = 0; i < 3; i += 1) {\n"
             "    if (stopped > .7 * s + .1) break;\n"
             "    if (i == 0) continue;\n"
             "    stopped += float texture(names[i], .5, .5);\n"
             "}\n"
             "for (i = 0; i < 3; i += 1)\n"
             "    for (k = i; k < 3; k += 1) nested += float texture(names[k], .5, .5);\n"
             "for (i = 0; i < 100; i += 1) if (names[mod(i, 3)] == \"grey.exr\") same += 1;\n",
             "",
             lanes});
        EXPECT_EQ(told.run.errBesidesLight(), "");
        ASSERT_EQ(told.values.size(), 5u) << told.run.text();
        EXPECT_NEAR(told.values[0], 1.05f, 2e-3f);
        EXPECT_NEAR(told.values[1], 1, 2e-3f);
        EXPECT_NEAR(told.values[2], .5f, 2e-3f);
        EXPECT_NEAR(told.values[3], .3f + 2 * .5f + 3 * .25f, 3e-3f);
        EXPECT_EQ(told.values[4], 34);
    }
}

TEST(Textureinfo, TellsWhatThereIs) {
    ScratchFolder folder;
    writePictures(folder);
    const Told told = tell(
        folder, {{"textureinfo(\"ramps.exr\", \"resolution\", size)", "size[0]", "size[1]",
                  "textureinfo(\"ramps.exr\", \"channels\", n)", "n",
                  "textureinfo(\"missing.tx\", \"exists\", m)", "m",
                  "textureinfo(\"grey.exr\", \"exists\", m)", "m",
                  "textureinfo(\"grey.exr\", \"viewingmatrix\", view)",
                  "textureinfo(\"grey.exr\", \"channels\", size)", "size[0]"},
                 "uniform float size[2] = {0, 0}; uniform float n = 0, m = 5; matrix view = 1;",
                 ""});
    EXPECT_EQ(told.values, (std::vector<float>{1, 64, 64, 1, 4, 1, 0, 1, 1, 0, 0, 64}))
        << told.run.text();
}

} // namespace
} // namespace candela::test

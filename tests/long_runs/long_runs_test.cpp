// SPDX-License-Identifier: Apache-2.0
// Renders that do not run from their first sample to their last in one go: killed and gone on with,
// interrupted, out of time, of chosen frames, joined from several.
#include "foundation/base/campaign.h"
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <gtest/gtest.h>
#include <random>

namespace candela::test {

namespace {

/// A lit ball on a plane, in SI units, so that every integrator has work of its own.
std::string world(int samples, const std::string &options = "") {
    return "Format 96 72 1\nPixelSamples " + std::to_string(samples) +
           " 1\nProjection \"perspective\" \"fov\" 40\n" + options +
           "WorldBegin\n"
           "AttributeBegin AreaLightSource \"arealight\" 1 \"radiance\" [9]\n"
           "Translate 0 3 6 Rotate 90 1 0 0 Disk 0 1 360 AttributeEnd\nIlluminate 1 1\n"
           "Surface \"matte\"\nTranslate 0 0 6\nSphere 1 -1 1 360\n"
           "Translate 0 -1 0\nRotate -90 1 0 0\nDisk 0 10 360\nWorldEnd\n";
}

std::string frames(int samples, const std::string &name = "f####.exr") {
    std::string rib;
    for (int frame : {1, 2, 3})
        rib += "FrameBegin " + std::to_string(frame) + "\nDisplay \"" + name +
               "\" \"openexr\" \"rgba\"\nTranslate 0 0 " + std::to_string(frame) + "\n" +
               world(samples) + "FrameEnd\n";
    return rib;
}

class LongRuns : public testing::Test {
protected:
    ScratchFolder folder_;

    Outcome run(std::vector<std::string> arguments, RunSettings settings = {}) {
        settings.folder = folder_.path();
        return runCandela(arguments, settings);
    }
    std::string told(const std::string &file, const std::string &key) {
        std::string problem;
        const auto picture = readPicture(folder_.path(file), problem);
        EXPECT_TRUE(picture) << problem;
        return picture && picture->metadata.contains(key) ? picture->metadata.at(key) : "";
    }
    /// Seconds that a run takes that is left alone.
    double secondsOf(const std::vector<std::string> &arguments) {
        const auto start = std::chrono::steady_clock::now();
        EXPECT_EQ(run(arguments).status, 0);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
};

struct Company {
    const char *name, *integrator, *options;
    int samples;
};

class Killed : public LongRuns, public testing::WithParamInterface<Company> {};

/// After whatever was written when it was killed the picture has the bytes that it would have had.
TEST_P(Killed, AtAnyMomentGivesTheBytesOfOneGo) {
    const Company &company = GetParam();
    folder_.write("scene.rib", "Display \"out.exr\" \"openexr\" \"rgba,variance,z\"\n" +
                                   world(company.samples, company.options));
    folder_.write("everythird.sl",
                  "filter everythird() { float x, y, k;\n"
                  "for (y = 0; y < ysize; y += 1) for (x = 0; x < xsize; x += 1) {\n"
                  "    color sum = 0;\n"
                  "    for (k = 0; k < 200; k += 3)\n"
                  "        sum += color image(\"samples\", x, y, \"sample\", k);\n"
                  "    setimage(\"Ci\", x, y, sum / 67); } }\n");
    std::vector<std::string> render{"scene.rib", "--integrator", company.integrator};
    const double seconds = secondsOf(render);
    const std::string whole = folder_.read("out.exr");
    ASSERT_FALSE(whole.empty());
    std::mt19937 random(7);
    render.insert(render.end(), {"--resume", "at.checkpoint", "--every", "0.03"});
    int kills = 0;
    const int rounds = 3 * int(campaignFactor());
    for (int round = 0; round < rounds; ++round) {
        std::filesystem::remove(folder_.path("out.exr"));
        std::filesystem::remove(folder_.path("at.checkpoint"));
        for (int time = 0; time < 2; ++time) {
            const double moment = std::uniform_real_distribution(0.1, 0.9)(random) * seconds;
            kills += run(render, {.sentSignal = SIGKILL, .signalAfter = moment}).signal == SIGKILL;
        }
        const Outcome last = run(render);
        EXPECT_EQ(last.status, 0) << last.text();
        EXPECT_EQ(folder_.read("out.exr"), whole) << "round " << round;
    }
    EXPECT_GT(kills, 0);
}

INSTANTIATE_TEST_SUITE_P(
    Company, Killed,
    testing::Values(Company{"Path", "path", "", 200}, Company{"Classic", "classic", "", 800},
                    Company{"Bidir", "bidir", "", 100}, Company{"Vcm", "vcm", "", 100},
                    Company{"Radiosity", "radiosity", "", 200},
                    Company{"Lobes", "path", "PixelFilter \"catmull-rom\" 4 4\n", 200},
                    Company{"Adaptive", "path", "PixelVariance 5e-5\n", 400},
                    Company{"AdaptiveLobes", "classic",
                            "PixelVariance 1e-4\nPixelFilter \"catmull-rom\" 4 4\n", 800},
                    Company{"Filtered", "path", "PushFilter \"everythird\"\n", 200}),
    [](const auto &info) { return std::string(info.param.name); });

TEST_F(LongRuns, SayHowManySamplesPixelsHave) {
    folder_.write("counts.sl", "filter counts() { float x, y;\n"
                               "for (y = 0; y < ysize; y += 1) for (x = 0; x < xsize; x += 1)\n"
                               "setimage(\"Ci\", x, y, color image(\"samples\", x, y)); }\n");
    struct Row {
        const char *integrator, *options, *spp, *range, *says;
    };
    for (const Row &row :
         {Row{"path", "", "200", "", ""}, Row{"path", "PixelVariance 0\n", "200", "", ""},
          Row{"path", "PixelVariance 1e9\n", "16", "", ""},
          Row{"path", "PixelVariance 1e9\nExposure 1e-9 1\n", "16", "", ""},
          Row{"path", "PixelVariance 1e-3\nExposure 1e9 1\n", "", "16 to 200", ""},
          Row{"path", "PixelVariance 1e-4\n", "", "16 to 200", ""},
          Row{"classic", "PixelVariance 1e-4\n", "", "16 to 200", ""},
          Row{"radiosity", "PixelVariance 1e-5\n", "", "16 to 200", ""},
          Row{"bidir", "PixelVariance 1e-4\n", "200", "",
              "PixelVariance does nothing under the integrator \"bidir\""},
          Row{"path", "PixelVariance 1e-4\nPushFilter \"counts\"\n", "200", "",
              "PixelVariance does nothing for filters that read every sample"},
          Row{"path", "PixelVariance -1\n", "200", "", "expected a number from 0 up"}}) {
        folder_.write("scene.rib",
                      "Display \"out.exr\" \"openexr\" \"rgb\"\n" + world(200, row.options));
        const Outcome outcome = run({"scene.rib", "--integrator", row.integrator});
        const std::string named = std::string(row.integrator) + " " + row.options;
        EXPECT_TRUE(outcome.says(row.says)) << named << outcome.text();
        if (!*row.says) {
            EXPECT_EQ(outcome.err, "") << named;
        }
        const std::string spp = told("out.exr", "spp");
        EXPECT_EQ(told("out.exr", "sppRange"), row.range) << named;
        if (*row.spp) {
            EXPECT_EQ(spp, row.spp) << named;
        } else {
            EXPECT_TRUE(std::stod(spp) > 17 && std::stod(spp) < 180) << named << spp;
        }
    }
    // The command line has the last word.
    folder_.write("scene.rib",
                  "Display \"out.exr\" \"openexr\" \"rgb\"\n" + world(200, "PixelVariance 1e9\n"));
    for (const auto &[words, spp] : {std::pair<std::vector<std::string>, const char *>{{}, "16"},
                                     {{"--spp", "64"}, "64"},
                                     {{"--spp", "64", "--pixel-variance", "1e9"}, "16"},
                                     {{"--pixel-variance", "0"}, "200"}}) {
        std::vector<std::string> all{"scene.rib", "--integrator", "path"};
        all.insert(all.end(), words.begin(), words.end());
        EXPECT_EQ(run(all).status, 0);
        EXPECT_EQ(told("out.exr", "spp"), spp);
    }
}

TEST_F(LongRuns, GoOnWithTheFrameThatWasUnderWay) {
    folder_.write("scene.rib", frames(300));
    const double seconds = secondsOf({"scene.rib"});
    std::vector<std::string> whole;
    for (const char *name : {"f0001.exr", "f0002.exr", "f0003.exr"}) {
        whole.push_back(folder_.read(name));
        ASSERT_FALSE(whole.back().empty());
        std::filesystem::remove(folder_.path(name));
    }
    const std::vector<std::string> render{"scene.rib", "--resume", "c", "--every", "0.05"};
    for (double share : {0.25, 0.35, 0.3})
        run(render, {.sentSignal = SIGKILL, .signalAfter = share * seconds});
    const Outcome last = run(render);
    EXPECT_EQ(last.status, 0) << last.text();
    int k = 0;
    for (const char *name : {"f0001.exr", "f0002.exr", "f0003.exr"})
        EXPECT_EQ(folder_.read(name), whole[std::size_t(k++)]) << name;
    // All has been rendered: nothing is left to do, and nothing is written again.
    std::filesystem::remove(folder_.path("f0003.exr"));
    EXPECT_EQ(run(render).status, 0);
    EXPECT_FALSE(folder_.has("f0003.exr"));
}

TEST_F(LongRuns, DoNotGoOnWithAnothersCheckpoint) {
    folder_.write("scene.rib", world(64));
    folder_.write("other.rib", world(64, "Rotate 3 0 0 1\n"));
    folder_.write("matte.sl", "surface matte() { Ci = Cs; Oi = 1; }");
    const std::string own = folder_.path() + "/own";
    folder_.write("own/matte.sl", "surface matte() { Ci = .5 * Cs; Oi = 1; }");
    ASSERT_EQ(run({"scene.rib", "--checkpoint", "c"}).status, 0);
    struct Row {
        std::vector<std::string> arguments;
        std::string says;
    };
    const Row rows[] = {
        {{"scene.rib", "--seed", "4"}, "it is of seed 0, and this render is of 4"},
        {{"scene.rib", "--spp", "65"}, "samples a pixel 64, and this render is of 65"},
        {{"scene.rib", "--integrator", "path"}, "integrator classic"},
        {{"scene.rib", "--format", "40x30"}, "resolution 96 x 72"},
        {{"scene.rib", "--crop", "0,.5,0,1"}, "crop"},
        {{"scene.rib", "--sampling", "hemisphere"}, "sampling cones"},
        {{"scene.rib", "--cpu", "v2"}, "instruction set"},
        {{"other.rib"}, "the scene is not the same"},
        {{"scene.rib", "--shader-path", own}, "the shaders are not the same"},
    };
    for (Row row : rows) {
        if (row.says == "instruction set" && run({"scene.rib", "--cpu", "v3"}).status == 2)
            continue; // This host has no other.
        row.arguments.insert(row.arguments.end(), {"--resume", "c"});
        const Outcome refused = run(row.arguments);
        EXPECT_EQ(refused.status, 1) << refused.text();
        EXPECT_TRUE(refused.says(row.says)) << row.says << "\n" << refused.text();
    }
}

TEST_F(LongRuns, SayWhatIsWrongWithACheckpoint) {
    folder_.write("scene.rib", world(16));
    ASSERT_EQ(run({"scene.rib", "--checkpoint", "c"}).status, 0);
    std::filesystem::remove(folder_.path("scene.exr"));
    std::string bytes = folder_.read("c");
    folder_.write("short", bytes.substr(0, bytes.size() / 2));
    bytes[bytes.size() / 2] ^= 1;
    folder_.write("flipped", bytes);
    folder_.write("text", "not a checkpoint");
    folder_.write("empty", "");
    for (const auto &[file, says] : {std::pair("short", "it is damaged"),
                                     {"flipped", "it is damaged"},
                                     {"text", "no checkpoint"},
                                     {"empty", "no checkpoint"},
                                     {".", "cannot"}}) {
        const Outcome refused = run({"scene.rib", "--resume", file, "--checkpoint", "d"});
        EXPECT_EQ(refused.status, 1) << file;
        EXPECT_TRUE(refused.says(says)) << refused.text();
        EXPECT_FALSE(folder_.has("scene.exr"));
    }
    const Outcome begun = run({"scene.rib", "--resume", "nothing"});
    EXPECT_EQ(begun.status, 0);
    EXPECT_TRUE(begun.says("there is no checkpoint nothing")) << begun.text();
    const Outcome nowhere = run({"scene.rib", "--checkpoint", "no/such/folder/c"});
    EXPECT_EQ(nowhere.status, 1);
    EXPECT_TRUE(nowhere.says("there can be no checkpoint")) << nowhere.text();
}

TEST_F(LongRuns, ThatAreInterruptedWriteWhatThereIs) {
    folder_.write("scene.rib", "Display \"out.exr\" \"openexr\" \"rgb\"\n" + world(200000));
    for (int signal : {SIGINT, SIGTERM}) {
        const auto start = std::chrono::steady_clock::now();
        const Outcome ended =
            run({"scene.rib"}, {.sentSignal = signal, .signalAfter = 2 * timeScale()});
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        EXPECT_EQ(ended.status, 130) << ended.text();
        EXPECT_TRUE(ended.says("of 200000 samples a pixel: the picture is written"))
            << ended.text();
        EXPECT_LT(taken.count(), 4 * timeScale());
        const double samples = std::stod(told("out.exr", "spp"));
        EXPECT_GT(samples, 0);
        EXPECT_LT(samples, 200000);
        std::filesystem::remove(folder_.path("out.exr"));
    }
}

/// A shader that does not come back is left behind; what there is of the picture is written.
TEST_F(LongRuns, EndInSpiteOfAShaderThatDoesNot) {
    folder_.write("endless.sl",
                  "surface endless() { float x = s; while (x < 2) x = sin(x); Ci = x; }");
    folder_.write("scene.rib", "Display \"out.exr\" \"openexr\" \"rgb\"\nFormat 64 64 1\n"
                               "Option \"shading\" \"integer loopturns\" [2147483647]\nWorldBegin\n"
                               "Translate 0 0 5\nSurface \"endless\"\nDisk 0 1 360\nWorldEnd\n");
    constexpr double until = 2;
    const auto start = std::chrono::steady_clock::now();
    const Outcome ended = run({"scene.rib", "--spp", "4"},
                              {.sentSignal = SIGTERM, .signalAfter = until * timeScale()});
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
    EXPECT_EQ(ended.status, 130) << ended.text();
    EXPECT_LT(taken.count(), (until + 2) * timeScale());
}

TEST_F(LongRuns, EndWhenTheirTimeIsUp) {
    folder_.write("scene.rib", frames(200000));
    const Outcome ended = run({"scene.rib", "--time-limit", "1.5"});
    EXPECT_EQ(ended.status, 0) << ended.text();
    EXPECT_TRUE(ended.says("the time is up after")) << ended.text();
    EXPECT_TRUE(ended.says("2 frames that follow are not rendered")) << ended.text();
    EXPECT_TRUE(folder_.has("f0001.exr"));
    EXPECT_FALSE(folder_.has("f0002.exr"));
    folder_.write("short.rib", world(4));
    EXPECT_EQ(run({"short.rib", "--time-limit", "1000"}).err, "");
    const Outcome none = run({"scene.rib", "--time-limit", "0.001"});
    EXPECT_TRUE(none.says("before there was any sample: no picture is written") ||
                none.says("of 200000 samples"))
        << none.text();
}

/// What an ended run has of each pixel is its own mean: it can be merged, and gone on with.
TEST_F(LongRuns, ThatEndEarlyGoOnToTheSameBytes) {
    const auto render = [&](const char *output, std::vector<std::string> more) {
        std::vector<std::string> arguments{"scene.rib", "-o", output};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return run(arguments);
    };
    folder_.write("scene.rib", world(1500));
    ASSERT_EQ(render("whole.exr", {}).status, 0);
    const Outcome part = render("part.exr", {"--checkpoint", "c", "--time-limit", "0.5"});
    ASSERT_EQ(part.status, 0) << part.text();
    ASSERT_TRUE(part.says("the time is up")) << part.text();
    EXPECT_EQ(render("part.exr", {"--resume", "c"}).status, 0);
    EXPECT_EQ(folder_.read("part.exr"), folder_.read("whole.exr"));
}

TEST_F(LongRuns, RenderTheFramesThatAreWanted) {
    folder_.write("scene.rib", frames(4, "f#.exr"));
    struct Row {
        const char *frames;
        std::vector<int> rendered;
        std::string says;
    };
    for (const Row &row : {Row{"1", {1}, ""}, Row{"2-3", {2, 3}, ""}, Row{"3,1", {1, 3}, ""},
                           Row{"1-10,20", {1, 2, 3}, "there is no frame 20"},
                           Row{"7-9", {}, "there is no frame of 7 to 9"}}) {
        const Outcome outcome = run({"scene.rib", "--frames", row.frames});
        EXPECT_EQ(outcome.status, 0) << outcome.text();
        if (row.says.empty())
            EXPECT_EQ(outcome.err, "");
        else
            EXPECT_TRUE(outcome.says(row.says)) << outcome.text();
        for (int frame : {1, 2, 3}) {
            const std::string name = "f" + std::to_string(frame) + ".exr";
            const bool wanted = std::ranges::find(row.rendered, frame) != row.rendered.end();
            EXPECT_EQ(folder_.has(name), wanted) << row.frames << " " << frame;
            std::filesystem::remove(folder_.path(name));
        }
    }
    for (const char *wrong : {"", "a", "1-", "-", "3-1", "1,", "1 2", ",1", "1--2x"})
        EXPECT_EQ(run({"scene.rib", "--frames", wrong}).status, 2) << wrong;
}

TEST_F(LongRuns, WriteWhereTheCommandLineSays) {
    folder_.write("scene.rib", "Display \"a.exr\" \"openexr\" \"rgb\"\n"
                               "Display \"+b.exr\" \"openexr\" \"z\"\n" +
                                   world(1));
    const Outcome outcome = run({"scene.rib", "-o", "x.png", "--output-dir", "elsewhere"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_TRUE(folder_.read("x.png").starts_with("\x89PNG"));
    EXPECT_TRUE(folder_.has("elsewhere/b.exr"));
    EXPECT_FALSE(folder_.has("elsewhere/a.exr"));
    EXPECT_NE(outcome.out.find("wrote "), std::string::npos) << outcome.out;
    EXPECT_EQ(run({"scene.rib", "-o", "x.png", "--quiet"}).out, "");
    // Maps of depths, which other frames read, stay where they were.
    folder_.write("shadow.rib", "Display \"map\" \"zfile\" \"z\"\n" + world(1));
    EXPECT_EQ(run({"shadow.rib", "-o", "y.exr"}).status, 0);
    EXPECT_TRUE(folder_.has("map"));
    EXPECT_FALSE(folder_.has("y.exr"));
    folder_.write("frames.rib", frames(1));
    EXPECT_TRUE(run({"frames.rib", "-o", "z.exr"}).says("one over the other"));
    EXPECT_EQ(run({"frames.rib", "-o", "z##.exr"}).err, "");
    EXPECT_TRUE(folder_.has("z02.exr"));
    EXPECT_EQ(run({"scene.rib", "-o", "no/../../made/x.exr"}).status, 0);
}

TEST_F(LongRuns, ReadSeveralFilesAsOne) {
    folder_.write("options.rib", "PixelSamples 2 1\nDisplay \"two.exr\" \"openexr\" \"rgb\"\n");
    folder_.write("world.rib", "WorldBegin\nWorldEnd\n");
    EXPECT_EQ(run({"options.rib", "world.rib"}).status, 0);
    EXPECT_EQ(told("two.exr", "spp"), "2");
    const Outcome lost = run({"options.rib", "missing.rib", "world.rib"});
    EXPECT_EQ(lost.status, 1);
    EXPECT_TRUE(lost.says("missing.rib")) << lost.text();
    EXPECT_TRUE(folder_.has("two.exr"));
}

TEST_F(LongRuns, OfSeveralSeedsAreMerged) {
    folder_.write("scene.rib", world(16));
    for (const char *seed : {"1", "2", "3"})
        ASSERT_EQ(run({"scene.rib", "--seed", seed, "-o", std::string(seed) + ".exr"}).status, 0);
    const Outcome merged = run({"merge", "1.exr", "2.exr", "3.exr", "-o", "all.exr"});
    ASSERT_EQ(merged.status, 0) << merged.text();
    EXPECT_EQ(told("all.exr", "spp"), "48");
    EXPECT_EQ(told("all.exr", "seed"), "1 2 3");
    const Outcome again = run({"merge", "all.exr", "2.exr", "-o", "no.exr"});
    EXPECT_EQ(again.status, 1);
    EXPECT_TRUE(again.says("it is of seed 2, as all.exr is")) << again.text();
    EXPECT_FALSE(folder_.has("no.exr"));
    EXPECT_EQ(run({"merge", "1.exr", "nothing.exr", "-o", "no.exr"}).status, 1);
    EXPECT_EQ(run({"merge", "1.exr"}).status, 2);
}

} // namespace

} // namespace candela::test

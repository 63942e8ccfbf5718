// SPDX-License-Identifier: Apache-2.0
// Lines in, lines out: formats, what is wrong with them, many of them; grids and their pictures.
#include "image/picture_file.h"
#include "tests/probing/probing.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {

namespace {

/// 1 lx at the origin, 1/h^2 at height 1 - h.
const std::string candle =
    siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 1] \"intensity\" [0.00558659217877095]\n");
const std::string room = CANDELA_SOURCE_DIR "/examples/probe/globillum.rib";

std::vector<std::string> linesOf(const std::string &text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

} // namespace

TEST(Lines, NumbersStandBetweenAnything) {
    const Probed probed = probe(candle, "0 0 0 0 0 1\n"
                                        "  0\t0\t0\t0\t0\t1\t\r\n"
                                        "# a remark\n"
                                        "\n"
                                        "0,0,0,0,0,1\n"
                                        "0; 0; 0; 0; 0; 1e3\n"
                                        "-0. .0 0e9 +0 0 +.5");
    EXPECT_EQ(probed.run.status, 0) << probed.run.text();
    ASSERT_EQ(probed.answers.size(), 5u) << probed.run.text();
    for (const Answer &a : probed.answers)
        EXPECT_EQ(a.photometric, 1);
}

TEST(Lines, CsvHasNamesAndPoints) {
    const Probed probed = probe(candle, "x,y,z,nx,ny,nz\n0,0,0.5,0,0,2\n", {"--csv"});
    const std::vector<std::string> lines = linesOf(probed.run.out);
    ASSERT_EQ(lines.size(), 2u) << probed.run.text();
    EXPECT_EQ(lines[0], "x,y,z,nx,ny,nz,E_R,E_G,E_B,E_total,lx,lx_half_width,samples");
    EXPECT_EQ(lines[1].substr(0, 14), "0,0,0.5,0,0,2,");
    EXPECT_NE(lines[1].find(",4,0,256"), std::string::npos) << lines[1];
}

TEST(Lines, ThoseThatAreNoPointsAreNamedAndTheRestIsAnswered) {
    const std::vector<std::pair<std::string, std::string>> flaws{
        {"foo", ":1:1: error: expected six numbers"},
        {"1 2 3", ":1:6: error: expected six numbers, a point and a direction: x y z dx dy dz; "
                  "there are 3"},
        {"1 2 3 4 5 6 7", ":1:13: error: expected six numbers"},
        {"1 2 3x 4 5 6", ":1:5: error: expected six numbers"},
        {"1,,3,4,5,6", ":1:3: error: expected six numbers"},
        {"0 0 0 0 0 0", ":1:1: error: the direction is 0 0 0: give the normal"},
        {"nan 0 0 0 0 1", ":1:1: error: expected a number within"},
        {"0 0 0 0 0 inf", ":1:11: error: expected a number within"},
        {"0 0 1e16 0 0 1", ":1:5: error: expected a number within"},
        {"0 0 1e999 0 0 1", ":1:5: error: expected a number within"},
        {std::string(100000, '7'), ":1:1: error: expected a number within"},
    };
    for (const auto &[line, message] : flaws) {
        const Probed probed = probe(candle, line + "\n0 0 0 0 0 1\n");
        EXPECT_EQ(probed.run.status, 1);
        EXPECT_TRUE(probed.run.says("points.txt" + message)) << line << "\n" << probed.run.text();
        ASSERT_EQ(probed.answers.size(), 2u) << probed.run.text();
        EXPECT_TRUE(std::isnan(probed.answers[0].photometric));
        EXPECT_EQ(probed.answers[1].photometric, 1);
    }
}

TEST(Lines, PointsInWallsAreNamed) {
    const std::string world = siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 4]\n"
                                      "Surface \"matte\"\nSphere 1 -1 1 360\n");
    const Probed probed = probe(world, "0 0 2 0 0 1\n0 0 .5 0 0 1\n0 0 -3 0 0 1\n");
    EXPECT_EQ(probed.run.status, 1);
    EXPECT_TRUE(probed.run.says("points.txt:2: error: no light comes to (0, 0, 0.5) from any side"))
        << probed.run.text();
    EXPECT_FALSE(probed.run.says("points.txt:3")) << "It lies in a shadow, under an open sky.";
    ASSERT_EQ(probed.answers.size(), 3u);
    EXPECT_EQ(probed.answers[1].photometric, 0);
}

/// Dark, but in a room where light is.
TEST(Lines, PointsInShadowAreInOrder) {
    const std::string world =
        siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 4]\nSurface \"matte\" \"Kd\" [0]\n"
                "Sphere 1 -1 1 360\nSphere 9 -9 9 360\n");
    const Probed probed = probe(world, "0 0 -3 0 0 1\n");
    EXPECT_EQ(probed.run.status, 0) << probed.run.text();
}

TEST(Files, ThatAreNotThereOrHoldNothing) {
    ScratchFolder folder;
    const std::string scene = folder.write("scene.rib", candle), empty = folder.write("none", "");
    const Outcome missing = runCandela({"probe", scene, folder.path("nowhere")});
    EXPECT_EQ(missing.status, 1);
    EXPECT_TRUE(missing.says("nowhere: error: No such file or directory")) << missing.text();
    const Outcome nothing = runCandela({"probe", scene, empty});
    EXPECT_EQ(nothing.status, 1);
    EXPECT_TRUE(nothing.says("none: error: holds no points: write one a line")) << nothing.text();
    const Outcome isFolder = runCandela({"probe", scene, folder.path()});
    EXPECT_EQ(isFolder.status, 1);
    EXPECT_TRUE(isFolder.says("error: Is a directory")) << isFolder.text();
    EXPECT_EQ(runCandela({"probe", folder.path("nowhere.rib"), empty}).status, 1);
    EXPECT_EQ(runCandela({"probe", "-", "-"}).status, 2);
}

TEST(Files, StandardInputIsRead) {
    ScratchFolder folder;
    RunSettings settings;
    settings.input = folder.write("points", "0 0 0 0 0 1\n");
    const Outcome run =
        runCandela({"probe", folder.write("scene.rib", candle), "--spp", "16"}, settings);
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.out, "0.005586592 0.005586592 0.005586592 0.005586592 1 0 16\n");
}

/// More lines than are held at once, in their order, with their flaws in between.
TEST(Lines, ManyComeInOrder) {
    std::string points;
    const int count = 20000;
    for (int k = 0; k < count; ++k)
        points += k % 1000 == 7 ? "?\n" : "0 0 -" + std::to_string(k) + " 0 0 1\n";
    const Probed probed = probe(candle, points, {"--spp", "16"});
    EXPECT_EQ(probed.run.status, 1);
    ASSERT_EQ(int(probed.answers.size()), count);
    for (int k = 0; k < count; ++k) {
        const double expected = 1 / (1.0 + k) / (1.0 + k), lx = probed.answers[k].photometric;
        if (k % 1000 == 7)
            EXPECT_TRUE(std::isnan(lx));
        else
            EXPECT_NEAR(lx, expected, 2e-4 * expected) << k;
    }
}

/// What stands in shaders' printf() is not among the answers.
TEST(Lines, AnswersAreAllThereIsOnStandardOutput) {
    ScratchFolder folder;
    folder.write("chatty.sl", "surface chatty() { printf(\"hello\\n\"); Ci = .5 * diffuse(N); }\n");
    const std::string world = siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 1]\n"
                                      "Surface \"chatty\"\nSphere 3 -3 3 360\n");
    const Probed probed =
        probe(world, "0 0 0 0 0 1\n", {"--spp", "16", "--shader-path", folder.path()});
    EXPECT_EQ(probed.run.status, 0) << probed.run.text();
    EXPECT_EQ(linesOf(probed.run.out).size(), 1u) << probed.run.out;
    EXPECT_TRUE(probed.run.says("hello"));
}

TEST(Until, TheAccuracyIsReachedOrItIsSaid) {
    const Outcome reached = runCandela({"probe", room, "--until", "5%", "--plane",
                                        "0,0,0,0,0,6,10,0,0", "--grid", "4x4", "--csv"});
    EXPECT_EQ(reached.status, 0) << reached.text();
    for (const std::string &line : linesOf(reached.out)) {
        double lx = 0, half = 0;
        int samples = 0;
        std::string blanks = line;
        for (char &c : blanks)
            c = c == ',' ? ' ' : c;
        if (std::sscanf(blanks.c_str(), "%*f %*f %*f %*f %*f %*f %*f %*f %*f %*f %lf %lf %d", &lx,
                        &half, &samples) != 3)
            continue;
        EXPECT_GT(lx, 0);
        EXPECT_LE(half, .05 * lx);
        EXPECT_EQ(samples % 16, 0);
        EXPECT_EQ((samples / 16) & (samples / 16 - 1), 0) << samples;
    }
    const Outcome refused = runCandela({"probe", room, "--until", ".01%", "--spp", "64", "--plane",
                                        "0,0,0,0,0,6,10,0,0", "--grid", "2x2"});
    EXPECT_EQ(refused.status, 0) << refused.text();
    EXPECT_TRUE(refused.says("4 of 4 points did not come within 0.01 % in 64 samples; --spp allows "
                             "more"))
        << refused.text();
}

TEST(Grid, TableAndPicturesShowThePlane) {
    ScratchFolder folder;
    const std::string scene = folder.write("scene.rib", candle);
    const std::vector<std::string> grid{"probe",  scene,     "--plane", "0,0,0,2,0,0,0,1,0",
                                        "--grid", "128x100", "--spp",   "16"};
    const auto run = [&](std::vector<std::string> options) {
        options.insert(options.begin(), grid.begin(), grid.end());
        const Outcome outcome = runCandela(options);
        EXPECT_EQ(outcome.status, 0) << outcome.text();
        return outcome.out;
    };
    const std::vector<std::string> table = linesOf(run({}));
    ASSERT_EQ(table.size(), 101u);
    EXPECT_TRUE(table.back().starts_with("mean 0.3")) << table.back();
    run({"-o", folder.path("grid.exr")});
    run({"-o", folder.path("grid.png")});
    std::string problem;
    const std::optional<Picture> values = readPicture(folder.path("grid.exr"), problem);
    ASSERT_TRUE(values) << problem;
    const PictureChannel *lx = values->find("illuminance");
    ASSERT_TRUE(lx);
    // The last row is the nearest one to the corner, and begins over it.
    EXPECT_NEAR(lx->values[99 * 128], 1, 1e-3);
    EXPECT_LT(lx->values[0], .5);
    const std::optional<Picture> shown = readPicture(folder.path("grid.png"), problem);
    ASSERT_TRUE(shown) << problem;
    EXPECT_GT(shown->window.columns(), shown->window.rows()); // As wide as the plane, and a legend.
    EXPECT_EQ(runCandela({"probe", scene, "--plane", "0,0,0,1,0,0,2,0,0", "--grid", "2x2"}).status,
              2);
}

/// The picture, seen against itself, by numbers: the whole answer of any threads and lanes.
TEST(Sameness, ThreadsAndLanesChangeNoByte) {
    ScratchFolder folder;
    std::string points;
    for (int k = 0; k < 150; ++k)
        points += std::to_string(.06 * k + .5) + " 0 2.5 0 1 0\n";
    const std::string file = folder.write("points", points);
    for (const char *quantity : {"--irradiance", "--radiance"}) {
        std::string first;
        for (const char *threads : {"1", "2", "7"})
            for (const char *lanes : {"16", "1"}) {
                const Outcome run =
                    runCandela({"probe", room, file, quantity, "--threads", threads, "--lanes",
                                lanes, "--until", "10%", "--spp", "1024"});
                EXPECT_EQ(run.status, 0) << run.text();
                first = first.empty() ? run.out : first;
                EXPECT_EQ(run.out, first) << quantity << " " << threads << " " << lanes;
            }
    }
}

} // namespace candela::test

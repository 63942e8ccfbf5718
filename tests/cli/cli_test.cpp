// SPDX-License-Identifier: Apache-2.0
// The face of the program: options, verbs, displays and where files are looked for.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// A white disc on black; `settings` are further options.
std::string scene(const std::string &settings) {
    return "Format 16 12 1\nPixelFilter \"box\" 1 1\n" + settings +
           "WorldBegin\nSurface \"constant\"\nTranslate 0 0 5\nDisk 0 .6 360\nWorldEnd\n";
}

class CommandLine : public testing::Test {
protected:
    ScratchFolder folder_;

    /// Renders into the scratch folder; all has to go well.
    Outcome render(const std::string &rib, const std::vector<std::string> &more = {}) {
        std::vector<std::string> arguments{folder_.write("scene.rib", rib), "--output-dir",
                                           folder_.path()};
        arguments.insert(arguments.end(), more.begin(), more.end());
        Outcome run = runCandela(arguments);
        EXPECT_EQ(run.status, 0) << run.text();
        return run;
    }

    Picture read(const std::string &name) {
        std::string problem;
        std::optional<Picture> picture = readPicture(folder_.path(name), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }

    std::vector<std::string> channelsOf(const std::string &name) {
        std::vector<std::string> names;
        for (const PictureChannel &channel : read(name).channels)
            names.push_back(channel.name);
        std::sort(names.begin(), names.end());
        return names;
    }

    float middle(const Picture &picture, const std::string &channel) {
        const PictureChannel *found = picture.find(channel);
        EXPECT_TRUE(found) << channel;
        const FrameWindow &w = picture.window;
        return found ? found->values[(w.rows() / 2) * w.columns() + w.columns() / 2] : -1;
    }

    int diff(const std::string &a, const std::string &b, std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{"diff", folder_.path(a), folder_.path(b)};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return runCandela(arguments).status;
    }
};

using Names = std::vector<std::string>;
const std::string exr = "Display \"out.exr\" \"openexr\" \"rgb\"\n";

} // namespace

TEST_F(CommandLine, HelpNamesEveryOption) {
    Outcome run = runCandela({"--help"});
    EXPECT_EQ(run.status, 0);
    for (const char *option :
         {"--spp", "--threads", "--seed", "--integrator", "--crop", "--format", "--output-dir",
          "--shader-path", "--archive-path", "--texture-path", "--quiet", "--lanes", "--cpu",
          "--sampling", "--stats", "--trust", "--version", "compile", "diff"})
        EXPECT_NE(run.out.find(option), std::string::npos) << option;
}

TEST_F(CommandLine, Version) {
    Outcome run = runCandela({"--version"});
    EXPECT_EQ(run.status, 0);
    EXPECT_EQ(run.out.rfind("candela ", 0), 0u) << run.out;
}

TEST_F(CommandLine, DiffHelp) {
    Outcome run = runCandela({"diff", "--help"});
    EXPECT_EQ(run.status, 0);
    EXPECT_NE(run.out.find("--tolerance"), std::string::npos);
}

TEST_F(CommandLine, DiffComparesSeeds) {
    std::vector<std::string> same{"diff"}, half{"diff"};
    for (const char *seed : {"1", "2", "3"}) {
        const std::string name = std::string("s") + seed + ".exr", dim = "half" + name;
        render(scene("Display \"" + name + "\" \"openexr\" \"rgb\"\n"), {"--seed", seed});
        render(scene("Display \"" + dim + "\" \"openexr\" \"rgb\"\nExposure .5 1\n"),
               {"--seed", std::string("1") + seed});
        same.push_back(folder_.path(name)), half.push_back(folder_.path(dim));
    }
    for (std::vector<std::string> *list : {&same, &half}) {
        list->push_back("--against");
        for (const char *seed : {"1", "2", "3"})
            list->push_back(folder_.path(std::string("s") + seed + ".exr"));
    }
    EXPECT_EQ(runCandela(same).status, 0);
    half.insert(half.end(), {"-o", folder_.path("z.png")});
    const Outcome run = runCandela(half);
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_NE(run.out.find("(-50"), std::string::npos) << run.out;
    EXPECT_TRUE(folder_.has("z.png"));
    EXPECT_EQ(runCandela({"diff", folder_.path("s1.exr")}).status, 2);
    EXPECT_EQ(diff("s1.exr", "halfs1.exr", {"--flip", "-o", folder_.path("d.exr")}), 1);
    EXPECT_TRUE(folder_.has("d.exr"));
}

TEST_F(CommandLine, DiffTellsBySaysAndStatus) {
    render(scene(exr));
    render(scene("Display \"half.exr\" \"openexr\" \"rgb\"\nExposure .5 1\n"));
    render(scene("Display \"small.exr\" \"openexr\" \"rgb\"\n"), {"--format", "8x6"});
    EXPECT_EQ(diff("out.exr", "out.exr"), 0);
    EXPECT_EQ(diff("out.exr", "half.exr"), 1);
    EXPECT_EQ(diff("out.exr", "half.exr", {"--tolerance", "0.51"}), 0);
    EXPECT_EQ(diff("out.exr", "half.exr", {"--relative", "0.51"}), 0);
    EXPECT_EQ(diff("out.exr", "small.exr"), 2);
    EXPECT_EQ(diff("out.exr", "nosuch.exr"), 2);
    Outcome run = runCandela({"diff", folder_.path("out.exr"), folder_.path("half.exr")});
    EXPECT_NE(run.out.find("0.5"), std::string::npos) << run.text();
    run = runCandela({"diff", folder_.path("out.exr"), folder_.path("half.exr"), "--quiet"});
    EXPECT_EQ(run.out, "");
    EXPECT_EQ(run.status, 1);
}

TEST_F(CommandLine, FormatReplacesTheFilesResolution) {
    render(scene(exr), {"--format", "20x10"});
    FrameWindow window = read("out.exr").window;
    EXPECT_EQ(window.width, 20);
    EXPECT_EQ(window.height, 10);
    EXPECT_EQ(window.pixels(), 200u);
}

// --format stands for Format: the frame of another shape still lies inside it, as RI has it.
TEST_F(CommandLine, FormatHoldsTheFrameOfTheFilesAspectRatio) {
    render(scene(exr + "FrameAspectRatio 2\n"), {"--format", "40x40"});
    FrameWindow window = read("out.exr").window;
    EXPECT_EQ(window.width, 40);
    EXPECT_EQ(window.height, 20);
    EXPECT_NE(runCandela({"--help"}).out.find("FrameAspectRatio"), std::string::npos);
}

TEST_F(CommandLine, NullHiderComputesNoPixels) {
    EXPECT_EQ(render(scene(exr + "Hider \"null\"\n")).err, "");
    EXPECT_FALSE(folder_.has("out.exr"));
}

// Pixels x with ceil(.25 * 16) <= x <= ceil(.75 * 16 - 1), as RI has it.
TEST_F(CommandLine, CropKeepsItsPlaceInTheFrame) {
    render(scene(exr), {"--crop", "0.25,0.75,0,0.5"});
    FrameWindow window = read("out.exr").window;
    EXPECT_EQ(window, (FrameWindow{16, 12, 4, 12, 0, 6}));
}

TEST_F(CommandLine, SamplesReplacePixelSamplesAndAreWrittenDown) {
    render(scene(exr + "PixelSamples 3 3\n"));
    EXPECT_EQ(read("out.exr").metadata["spp"], "9");
    render(scene(exr), {"--spp", "5", "--seed", "7"});
    EXPECT_EQ(read("out.exr").metadata["spp"], "5");
    EXPECT_EQ(read("out.exr").metadata["seed"], "7");
}

TEST_F(CommandLine, IntegratorOfTheOptionWins) {
    render(scene(exr), {"--integrator", "path"});
    EXPECT_EQ(read("out.exr").metadata["integrator"], "path");
    render(scene(exr + "Option \"render\" \"string integrator\" [\"path\"]\n"),
           {"--integrator", "classic"});
    EXPECT_EQ(read("out.exr").metadata["integrator"], "classic");
}

TEST_F(CommandLine, UnitsStandInTheFile) {
    render(scene(exr));
    EXPECT_EQ(read("out.exr").metadata["units"], "relative");
    EXPECT_FALSE(read("out.exr").metadata.contains("luminousEfficacy"));
    render(scene(exr + "Option \"radiometry\" \"string units\" \"si\"\n"));
    EXPECT_EQ(read("out.exr").metadata["units"], "W m^-2 sr^-1");
    EXPECT_EQ(read("out.exr").metadata["luminousEfficacy"], "179 lm/W");
}

TEST_F(CommandLine, AScenesOwnNameIsItsPicturesWhereItNamesNone) {
    render(scene(""));
    EXPECT_TRUE(folder_.has("scene.exr"));
    for (const char *name : {"two.words.rib", "packed.rib.gz", "none"}) {
        const Outcome run =
            runCandela({folder_.write(name, scene("")), "--output-dir", folder_.path()});
        EXPECT_EQ(run.status, 0) << run.text();
    }
    for (const char *picture : {"two.words.exr", "packed.exr", "none.exr"})
        EXPECT_TRUE(folder_.has(picture)) << picture;
}

TEST_F(CommandLine, PicturesGoToTheCurrentFolderUnlessToldOtherwise) {
    std::string rib = folder_.write("scene.rib", scene(exr));
    RunSettings there;
    there.folder = folder_.path();
    EXPECT_EQ(runCandela({rib}, there).status, 0);
    EXPECT_TRUE(folder_.has("out.exr"));
    EXPECT_EQ(runCandela({rib, "--output-dir", folder_.path("new/folder")}).status, 0);
    EXPECT_TRUE(folder_.has("new/folder/out.exr"));
}

TEST_F(CommandLine, StandardInput) {
    RunSettings piped;
    piped.input = folder_.write("scene.rib", scene(exr));
    EXPECT_EQ(runCandela({"-", "--output-dir", folder_.path()}, piped).status, 0);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 1);
}

TEST_F(CommandLine, DisplayModes) {
    const std::vector<std::pair<std::string, Names>> modes{{"rgb", {"B", "G", "R"}},
                                                           {"rgba", {"A", "B", "G", "R"}},
                                                           {"a", {"A"}},
                                                           {"z", {"Z"}},
                                                           {"rgbaz", {"A", "B", "G", "R", "Z"}},
                                                           {"N", {"N.X", "N.Y", "N.Z"}},
                                                           {"id", {"id"}}};
    for (const auto &[mode, names] : modes) {
        render(scene("Display \"out.exr\" \"openexr\" \"" + mode + "\"\n"));
        EXPECT_EQ(channelsOf("out.exr"), names) << mode;
    }
}

TEST_F(CommandLine, ChannelsHoldWhatTheyAreCalled) {
    render(scene("Display \"out.exr\" \"openexr\" \"rgbaz,N\"\n"));
    Picture picture = read("out.exr");
    EXPECT_FLOAT_EQ(middle(picture, "R"), 1);
    EXPECT_FLOAT_EQ(middle(picture, "A"), 1);
    EXPECT_FLOAT_EQ(middle(picture, "Z"), 5);
    EXPECT_FLOAT_EQ(picture.find("A")->values[0], 0);
}

TEST_F(CommandLine, SeveralDisplays) {
    render(scene("Display \"a.exr\" \"openexr\" \"rgb\"\nDisplay \"+b.png\" \"png\" \"rgb\"\n"
                 "Display \"+c.exr\" \"file\" \"z\"\nDisplay \"+d.png\" \"file\" \"rgba\"\n"));
    EXPECT_EQ(channelsOf("a.exr"), (Names{"B", "G", "R"}));
    EXPECT_EQ(channelsOf("c.exr"), (Names{"Z"}));
    EXPECT_EQ(folder_.read("b.png").substr(1, 3), "PNG");
    EXPECT_EQ(folder_.read("d.png").substr(1, 3), "PNG");
}

// A display without + takes the place of those before it.
TEST_F(CommandLine, DisplayReplacesDisplays) {
    render(scene("Display \"a.exr\" \"openexr\" \"rgb\"\nDisplay \"b.exr\" \"openexr\" \"rgb\"\n"));
    EXPECT_FALSE(folder_.has("a.exr"));
    EXPECT_TRUE(folder_.has("b.exr"));
}

// Frames come in order, and what one sets is gone with it.
TEST_F(CommandLine, FramesOfAFile) {
    const auto frame = [](int number, const std::string &options) {
        std::string n = std::to_string(number);
        return "FrameBegin " + n + "\nDisplay \"frame" + n + ".exr\" \"openexr\" \"rgb\"\n" +
               options +
               "WorldBegin\nSurface \"constant\"\nTranslate 0 0 5\nDisk 0 .6 360\n"
               "WorldEnd\nFrameEnd\n";
    };
    render("Format 16 12 1\nPixelFilter \"box\" 1 1\n" + frame(1, "") +
           frame(2, "Exposure .25 1\n") + frame(3, ""));
    EXPECT_FLOAT_EQ(middle(read("frame1.exr"), "R"), 1);
    EXPECT_FLOAT_EQ(middle(read("frame2.exr"), "R"), 0.25f);
    EXPECT_EQ(folder_.read("frame1.exr"), folder_.read("frame3.exr"));
}

TEST_F(CommandLine, ArchivesAreFoundByTheSearchPaths) {
    const std::string world = "WorldBegin\nReadArchive \"ball.rib\"\nWorldEnd\n";
    const std::string head = "Format 16 12 1\nPixelFilter \"box\" 1 1\n" + exr;
    const std::string ball = "Surface \"constant\"\nTranslate 0 0 5\nDisk 0 .6 360\n";
    folder_.write("archives/ball.rib", ball);
    EXPECT_EQ(runCandela({folder_.write("scene.rib", head + world), "--output-dir", folder_.path()})
                  .status,
              1);
    render(head + world, {"--archive-path", folder_.path("archives")});
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 1);
    render(head + "Option \"searchpath\" \"string archive\" [\"" + folder_.path("archives") +
           "\"]\n" + world);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 1);
    folder_.write("ball.rib", ball); // beside the scene
    render(head + world);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 1);
}

TEST_F(CommandLine, ShadersAreFoundByTheSearchPaths) {
    folder_.write("mine/fifth.sl", "surface fifth() { Ci = .2; Oi = 1; }\n");
    std::string rib = scene(exr);
    rib.replace(rib.find("constant"), 8, "fifth");
    render(rib, {"--shader-path", folder_.path("mine")});
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 0.2f);
    render("Option \"searchpath\" \"string shader\" [\"" + folder_.path("mine") + "\"]\n" + rib);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 0.2f);
    folder_.write("fifth.sl", "surface fifth() { Ci = .4; Oi = 1; }\n"); // beside the scene
    render(rib);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 0.4f);
}

TEST_F(CommandLine, CompiledNamesMeanTheirSource) {
    std::string rib = scene(exr);
    rib.replace(rib.find("constant"), 8, "constant.slo");
    render(rib);
    EXPECT_FLOAT_EQ(middle(read("out.exr"), "R"), 1);
}

TEST_F(CommandLine, QuietSaysNothing) {
    Outcome run = render(scene(exr), {"--quiet"});
    EXPECT_EQ(run.err, "");
    EXPECT_EQ(run.out, "");
}

TEST_F(CommandLine, StatisticsAreJson) {
    render(scene(exr), {"--stats", folder_.path("stats.json")});
    std::string text = folder_.read("stats.json");
    EXPECT_EQ(text.front(), '{');
    EXPECT_NE(text.find("\"transport.cameraRays\": "), std::string::npos) << text;
    EXPECT_NE(text.find("\"process.cpuSeconds\": "), std::string::npos) << text;
}

} // namespace candela::test

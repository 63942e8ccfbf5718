// SPDX-License-Identifier: Apache-2.0
// `candela filter`: stacks on stored pictures.
#include "tests/filters/filtered.h"

#include <cmath>
#include <csignal>
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace candela::test {

using Names = std::vector<std::string>;

namespace {

const std::string shaders = CANDELA_SOURCE_DIR "/tests/filters/shaders";

/// A frame with raw radiance and what a display shows of it behind the filters.
std::string frameWith(const std::string &filters) {
    return smallFrame(filters + "Display \"raw.exr\" \"openexr\" \"radiance,a,z,N,albedo,id\"\n"
                                "Display \"+online.exr\" \"openexr\" \"rgb\"\n") +
           ballWorld("LightSource \"pointlight\" 1 \"point from\" [0 3 2]\n"
                     "Color .2 .4 .8 Surface \"glow\"");
}

} // namespace

TEST_F(Filtered, offlineIsOnlineToTheBit) {
    struct Case {
        const char *requests;
        Names words;
    };
    const Case table[] = {
        {"PushFilter \"double\" PushFilter \"plusone\"", {"-f", "double", "-f", "plusone"}},
        {"PushFilter \"plusone\" PushFilter \"double\"", {"-f", "plusone", "double"}},
        {"PushFilter \"double\" \"factor\" [.3] \"tint\" [1 .5 .25]",
         {"-f", "double", "factor=.3", "tint=1,.5,0.25"}},
        {"PushFilter \"show\" \"string what\" \"albedo\"", {"-f", "show", "what=albedo"}},
        {"PushFilter \"show\" \"string what\" \"Z\"", {"-f", "show", "what=Z"}},
        {"PushFilter \"smaller\"", {"-f", "smaller"}},
    };
    for (const Case &test : table) {
        run(frameWith(std::string(test.requests) + "\n"), {"--spp", "4"});
        const Outcome outcome = filter("raw.exr", "offline.exr", test.words);
        EXPECT_EQ(outcome.status, 0) << test.requests << outcome.text();
        const Picture online = read("online.exr"), offline = read("offline.exr");
        for (const char *name : {"R", "G", "B"}) {
            ASSERT_TRUE(offline.find(name)) << test.requests;
            EXPECT_EQ(offline.find(name)->values, online.find(name)->values) << test.requests;
        }
        EXPECT_EQ(offline.metadata.at("filters"), online.metadata.at("filters"));
    }
}

TEST_F(Filtered, allChannelsAndMetadataGoThrough) {
    run(frameWith(""), {"--spp", "4"});
    const Picture before = read("raw.exr");
    const Outcome outcome =
        filter("raw.exr", "out.exr", {"-f", "double", "-f", "makes", "--quiet"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.err + outcome.out, "");
    const Picture after = read("out.exr");
    for (const PictureChannel &channel : before.channels) {
        ASSERT_TRUE(after.find(channel.name)) << channel.name;
        EXPECT_EQ(after.find(channel.name)->values, channel.values) << channel.name;
    }
    EXPECT_EQ(after.channels.size(), before.channels.size() + 3); // R, G, B.
    for (const auto &[name, value] : before.metadata)
        EXPECT_EQ(after.metadata.at(name), value);
    EXPECT_EQ(after.metadata.at("filters"), "double; makes");
    EXPECT_EQ(after.window, before.window);
    EXPECT_TRUE(after.worldToNdc);
    filter("out.exr", "out.exr", {"-f", "plusone"});
    EXPECT_EQ(read("out.exr").metadata.at("filters"), "double; makes; plusone");
    EXPECT_EQ(at("out.exr", "R", 0, 0), 1);
}

TEST_F(Filtered, withoutAFilterThePictureIsWrittenAsItIs) {
    run(frameWith(""), {"--spp", "1"});
    EXPECT_EQ(filter("raw.exr", "copy.exr", {}).status, 0);
    const Picture before = read("raw.exr"), after = read("copy.exr");
    EXPECT_EQ(after.metadata, before.metadata);
    for (const PictureChannel &channel : before.channels)
        EXPECT_EQ(after.find(channel.name)->values, channel.values) << channel.name;
    EXPECT_EQ(filter("raw.exr", "copy.png", {}).status, 0);
    EXPECT_TRUE(read("copy.png").hasDisplayValues);
}

/// A PNG picture holds display values by the curve of sRGB: filters are given light.
TEST_F(Filtered, aPngPictureIsReadAsLight) {
    run(frameWith(""), {"--spp", "4"});
    EXPECT_EQ(filter("raw.exr", "plain.exr", {"-f", "show", "what=Cs"}).status, 0);
    EXPECT_EQ(filter("raw.exr", "first.png", {"-f", "show", "what=Cs"}).status, 0);
    EXPECT_EQ(filter("first.png", "light.exr", {"-f", "show", "what=Cs"}).status, 0);
    EXPECT_EQ(filter("first.png", "second.png", {"-f", "show", "what=Cs"}).status, 0);
    const Picture plain = read("plain.exr"), light = read("light.exr");
    const Picture first = read("first.png"), second = read("second.png");
    for (const char *name : {"R", "G", "B"}) {
        ASSERT_TRUE(plain.find(name) && light.find(name) && second.find(name)) << name;
        for (std::size_t k = 0; k < plain.find(name)->values.size(); ++k) {
            const float value = plain.find(name)->values[k];
            if (first.find(name)->values[k] < .99f) { // Else it is brighter than what covers it.
                EXPECT_NEAR(light.find(name)->values[k], value, .02f * value + .002f) << name << k;
            }
            EXPECT_NEAR(second.find(name)->values[k], first.find(name)->values[k], 1.01f / 255);
        }
    }
}

TEST_F(Filtered, whatIsNotFiniteIsToldOf) {
    run(frameWith(""));
    const Outcome outcome = filter("raw.exr", "out.exr", {"-f", "ward94", "L_dmax=0"});
    EXPECT_TRUE(outcome.says("not finite")) << outcome.text();
    for (const float value : read("out.exr").find("G")->values)
        EXPECT_TRUE(std::isfinite(value));
}

TEST_F(Filtered, mapsOfFiltersAreWrittenWhereTheyAreAskedFor) {
    run(frameWith(""));
    EXPECT_EQ(filter("raw.exr", "out.exr", {"-f", "makes"}).status, 0);
    EXPECT_FALSE(read("out.exr").find("mine"));
    EXPECT_EQ(filter("raw.exr", "out.exr", {"-f", "makes", "--keep", "mine"}).status, 0);
    EXPECT_TRUE(read("out.exr").find("mine"));
}

TEST_F(Filtered, valuesAreCheckedAgainstTheShader) {
    run(frameWith(""));
    struct Case {
        Names words;
        const char *message; ///< Empty: it is right.
    };
    const Case table[] = {
        {{"-f", "double", "tint=[1 0 0]"}, ""},
        {{"-f", "double", "tint=.5", "factor=-1e2"}, ""},
        {{"-f", "double", "factor=1", "factor=2"}, ""}, // The last one counts.
        {{"-f", "double", "factr=2"},
         "has no parameter 'factr'; did you mean 'factor'?; it has "
         "float factor, color tint"},
        {{"-f", "plusone", "x=2"}, "has no parameter 'x'; it has none"},
        {{"-f", "double", "factor=two"}, "takes float factor, which 'two' is not"},
        {{"-f", "double", "factor=2x"}, "takes float factor"},
        {{"-f", "double", "factor="}, "takes float factor"},
        {{"-f", "double", "factor=1,2"}, "takes float factor"},
        {{"-f", "double", "factor=inf"}, "takes float factor"},
        {{"-f", "double", "factor=nan"}, "takes float factor"},
        {{"-f", "double", "tint=1,2"}, "takes color tint"},
        {{"-f", "tint=1"}, "stands before any filter's name"},
        {{"-f", "nowhere", "x=1"}, "no shader \"nowhere\""},
        {{"-f", "broken"}, "broken"},
        {{"-f", "glow"}, "glow"},
    };
    for (const Case &test : table) {
        const Outcome outcome = filter("raw.exr", "out.exr", test.words);
        const bool right = !*test.message;
        EXPECT_EQ(outcome.status, right ? 0 : 1) << outcome.text();
        EXPECT_TRUE(outcome.says(test.message)) << test.message << outcome.text();
        EXPECT_EQ(folder_.has("out.exr"), right) << test.message;
        ::unlink(folder_.path("out.exr").c_str());
    }
}

TEST_F(Filtered, whatCannotBeReadOrWrittenLeavesNothing) {
    run(frameWith(""));
    folder_.write("text.exr", "no picture");
    folder_.write("broken.exr", folder_.read("raw.exr").substr(0, 700));
    const auto fails = [&](const std::string &in, const std::string &out) {
        const Outcome outcome = filter(in, out, {"-f", "double"});
        return outcome.status == 1 && !outcome.err.empty() && !folder_.has(out);
    };
    for (const char *in : {"nothing.exr", "text.exr", "broken.exr", "."})
        EXPECT_TRUE(fails(in, "out.exr")) << in;
    EXPECT_TRUE(fails("raw.exr", "nowhere/out.exr"));
    const Outcome depth = [&] {
        run(smallFrame("Display \"z.exr\" \"openexr\" \"z\"\n") + plainWorld());
        return filter("z.exr", "out.exr", {"-f", "double"});
    }();
    EXPECT_EQ(depth.status, 1);
    EXPECT_TRUE(depth.says("no colours")) << depth.text();
}

TEST_F(Filtered, commandLinesThatMakeNoSenseAreTwo) {
    for (const Names &words :
         std::vector<Names>{{"filter"},
                            {"filter", "a.exr"},
                            {"filter", "a.exr", "b.exr", "-f"},
                            {"filter", "a.exr", "b.exr", "-x"},
                            {"filter", "a", "b", "-f", "x", "--exposure", "1"},
                            {"filter", "a", "b", "-f", "x", "--exposure", "1", "0"},
                            {"filter", "a", "b", "-f", "x", "--threads", "0"}})
        EXPECT_EQ(runCandela(words).status, 2);
    const Outcome help = runCandela({"filter", "--help"});
    EXPECT_EQ(help.status, 0);
    EXPECT_NE(help.out.find("Exit status"), std::string::npos);
}

TEST_F(Filtered, pngGetsTheCurveOfSrgbOrAnExposure) {
    render(smallFrame("Display \"raw.exr\" \"openexr\" \"rgbaz\"\n") + plainWorld());
    EXPECT_EQ(filter("raw.exr", "a.png", {"-f", "double"}).status, 0);
    EXPECT_EQ(channelsOf("a.png"), (Names{"A", "B", "G", "R"}));
    // .5 of light is 187.5 on the curve, and dither moves it by half a level.
    EXPECT_NEAR(at("a.png", "R", 3, 3) * 255, 187.5f, 1.01f);
    EXPECT_EQ(filter("raw.exr", "b.PNG", {"-f", "double", "--exposure", "1", "1"}).status, 0);
    EXPECT_NEAR(at("b.PNG", "R", 3, 3) * 255, 127.5f, 1.01f);
    EXPECT_EQ(filter("raw.exr", "c.exr", {"-f", "double", "--exposure", "8", "2"}).status, 0);
    EXPECT_EQ(everywhere("c.exr", "R"), 2);
    EXPECT_EQ(everywhere("c.exr", "A"), 1);
}

/// The same bytes for any number of threads and lane width.
TEST_F(Filtered, offlineDependsOnNothingElse) {
    run(frameWith(""), {"--spp", "4"});
    std::string first;
    for (const Names &more :
         std::vector<Names>{{"--threads", "1"}, {"--threads", "3"}, {"--lanes", "1"}}) {
        Names words{"-f", "double", "factor=.7", "-f", "show", "what=N"};
        words.insert(words.end(), more.begin(), more.end());
        EXPECT_EQ(filter("raw.exr", "out.exr", words).status, 0);
        const std::string bytes = folder_.read("out.exr");
        EXPECT_EQ(bytes, first.empty() ? bytes : first);
        first = bytes;
    }
}

TEST_F(Filtered, listNamesFiltersAndTheirParameters) {
    const Outcome outcome = runCandela({"filter", "--list", "--shader-path", shaders});
    EXPECT_NE(outcome.out.find("double(float factor, color tint)"), std::string::npos)
        << outcome.text();
    EXPECT_NE(outcome.out.find("show(string what)"), std::string::npos) << outcome.text();
    EXPECT_EQ(outcome.out.find("glow"), std::string::npos) << outcome.text();
}

namespace {

/// Starts the program, and Ctrl-C comes after so many seconds: the exit status, or minus a signal.
int interruptedAfter(double seconds, const Names &arguments) {
    const pid_t child = ::fork();
    if (child == 0) {
        const int null = ::open("/dev/null", O_RDWR);
        ::dup2(null, 1);
        ::dup2(null, 2);
        std::signal(SIGINT, SIG_DFL);
        std::vector<char *> words{const_cast<char *>("candela")};
        for (const std::string &word : arguments)
            words.push_back(const_cast<char *>(word.c_str()));
        words.push_back(nullptr);
        ::execv(candelaProgram().c_str(), words.data());
        ::_exit(126);
    }
    ::usleep(useconds_t(seconds * 1e6));
    ::kill(child, SIGINT);
    int status = 0;
    ::waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

/// The same once the filter is at work: before, the signal ends the program.
int interrupted(const Names &arguments) {
    int status = -SIGINT;
    for (double seconds = 0.5; status == -SIGINT && seconds < 40 * timeScale(); seconds *= 2)
        status = interruptedAfter(seconds, arguments);
    return status;
}

} // namespace

TEST_F(Filtered, ctrlCEndsAFilterAndNothingIsWritten) {
    run(frameWith(""));
    EXPECT_EQ(interrupted({"filter", folder_.path("raw.exr"), folder_.path("out.exr"),
                           "--shader-path", shaders, "-f", "double", "-f", "forever"}),
              130);
    EXPECT_FALSE(folder_.has("out.exr"));
}

/// A frame has cost its render: the picture is written as the last whole filter left it.
TEST_F(Filtered, ctrlCEndsAFrameWithWhatThereIs) {
    const std::string rib = folder_.write(
        "endless.rib", "FrameBegin 1\n" +
                           smallFrame("PushFilter \"double\"\nPushFilter \"forever\"\n"
                                      "Display \"a.exr\" \"openexr\" \"rgb\"\n") +
                           plainWorld() + "FrameEnd\nFrameBegin 2\n" +
                           smallFrame("Display \"b.exr\" \"openexr\" \"rgb\"\n") + plainWorld() +
                           "FrameEnd\n");
    EXPECT_EQ(interrupted({rib, "--output-dir", folder_.path(), "--shader-path", shaders}), 130);
    EXPECT_EQ(everywhere("a.exr", "R"), .5f);
    EXPECT_EQ(read("a.exr").metadata.at("filters"), "double");
    EXPECT_FALSE(folder_.has("b.exr"));
}

} // namespace candela::test

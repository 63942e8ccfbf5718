// SPDX-License-Identifier: Apache-2.0
// Windows, where there is no screen and where SDL pretends that there is one.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <cstdlib>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string scene = "Format 16 12 1 WorldBegin LightSource \"ambientlight\" 1\n"
                          "Surface \"constant\" Translate 0 0 2 Sphere 1 -1 1 360 WorldEnd\n";

/// Without a screen, or with one that nobody sees.
class ScreenTest : public testing::Test {
protected:
    enum class Screen { None, Dummy };
    Outcome run(Screen screen, const std::vector<std::string> &arguments) {
        for (const char *variable : {"DISPLAY", "WAYLAND_DISPLAY", "SDL_VIDEODRIVER"})
            unsetenv(variable);
        if (screen == Screen::Dummy)
            setenv("SDL_VIDEODRIVER", "dummy", 1);
        RunSettings settings;
        settings.folder = folder_.path();
        return runCandela(arguments, settings);
    }
    ~ScreenTest() override { unsetenv("SDL_VIDEODRIVER"); }

    const ScratchFolder folder_;
};

TEST_F(ScreenTest, withoutOneFramebuffersBecomeFiles) {
    folder_.write("a.rib", "Display \"seen\" \"framebuffer\" \"rgb\"\n" + scene);
    const Outcome outcome = run(Screen::None, {"--quiet", "a.rib"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_TRUE(outcome.says("there is no window for the display type \"framebuffer\": it will be "
                             "the OpenEXR file \"seen.exr\""))
        << outcome.text();
    EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.text();
    EXPECT_TRUE(folder_.has("seen.exr"));
}

TEST_F(ScreenTest, withOneTheyBecomeNone) {
    folder_.write("a.rib", "Display \"seen\" \"framebuffer\" \"rgb\"\n" + scene);
    const Outcome outcome = run(Screen::Dummy, {"--quiet", "a.rib"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.err, "");
    EXPECT_FALSE(folder_.has("seen.exr"));
}

TEST_F(ScreenTest, viewShowsAndWritesWhatIsAskedForAlone) {
    folder_.write("a.rib", "Display \"a.exr\" \"openexr\" \"rgba\"\n" + scene);
    Outcome outcome = run(Screen::Dummy, {"view", "--quiet", "a.rib"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.err, "");
    EXPECT_FALSE(folder_.has("a.exr"));
    outcome = run(Screen::Dummy, {"view", "--quiet", "a.rib", "-o", "b.exr"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_TRUE(folder_.has("b.exr"));
    EXPECT_EQ(run(Screen::None, {"--quiet", "a.rib"}).status, 0);
    EXPECT_EQ(folder_.read("a.exr"), folder_.read("b.exr"));
    outcome = run(Screen::Dummy, {"view", "a.exr", "b.exr"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.err, "");
}

TEST_F(ScreenTest, viewSaysWhatItCannotShow) {
    folder_.write("a.rib", scene);
    folder_.write("bad.exr", "no picture");
    const struct {
        Screen screen;
        std::vector<std::string> arguments;
        int status;
        const char *message;
    } cases[] = {
        {Screen::None, {"view", "a.rib"}, 1, "there is no window"},
        {Screen::None, {"view", "a.exr"}, 1, "there is no window"},
        {Screen::Dummy, {"view", "none.exr"}, 1, "none.exr"},
        {Screen::Dummy, {"view", "bad.exr"}, 1, "bad.exr"},
        {Screen::Dummy, {"view", "a.rib", "a.exr"}, 2, "not both at once"},
        {Screen::Dummy, {"view"}, 2, "files"},
    };
    for (const auto &each : cases) {
        const Outcome outcome = run(each.screen, each.arguments);
        EXPECT_EQ(outcome.status, each.status) << outcome.text();
        EXPECT_TRUE(outcome.says(each.message)) << outcome.text();
    }
}

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// A window's thread, with a driver that only pretends.
#include "image/view/picture_window.h"

#include <atomic>
#include <deque>
#include <gtest/gtest.h>

namespace candela {
namespace {

using Kind = ViewEvent::Kind;
using Purpose = PictureWindow::Purpose;
using Interest = DisplayTaker::Interest;

/// What the driver is asked for, and what the user does.
struct Desk {
    std::mutex mutex;
    std::deque<ViewEvent> events;
    std::vector<std::string> titles;
    std::array<int, 2> revealed{0, 0};
    std::atomic<bool> hasOnlooker{false};
} desk;

class PretendedWindow final : public WindowDriver {
public:
    void reveal(int width, int height) override {
        std::lock_guard lock(desk.mutex);
        desk.revealed = {width, height};
    }
    void setTitle(const std::string &title) override {
        std::lock_guard lock(desk.mutex);
        desk.titles.push_back(title);
    }
    void show(std::span<const std::uint32_t> pixels, int width, int height) override {
        EXPECT_EQ(pixels.size(), std::size_t(width) * std::size_t(height));
    }
    std::optional<ViewEvent> wait(int milliseconds) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds > 0));
        std::lock_guard lock(desk.mutex);
        if (desk.events.empty())
            return std::nullopt;
        const ViewEvent event = desk.events.front();
        desk.events.pop_front();
        return event;
    }
    bool hasOnlooker() const override { return desk.hasOnlooker; }
};

std::unique_ptr<WindowDriver> pretend(std::string &) { return std::make_unique<PretendedWindow>(); }
std::unique_ptr<WindowDriver> fail(std::string &problem) {
    problem = "no screen";
    return nullptr;
}

void does(const ViewEvent &event) {
    std::lock_guard lock(desk.mutex);
    desk.events.push_back(event);
}

Picture grey() {
    Picture picture;
    picture.window = {100, 70, 0, 100, 0, 70};
    picture.channels = {{"R", std::vector<float>(7000, .5f)}};
    return picture;
}

template <class Condition> bool comesTrue(Condition condition) {
    for (int i = 0; i < 5000 && !condition(); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return condition();
}

class Window : public testing::Test {
protected:
    Window() {
        desk.events.clear(), desk.titles.clear();
        desk.revealed = {0, 0}, desk.hasOnlooker = false;
    }
};

TEST_F(Window, takesWhatItsPurposeSays) {
    const struct {
        WindowOpener opener;
        Purpose purpose;
        const char *type;
        Interest interest;
    } cases[] = {
        {&pretend, Purpose::Framebuffers, "framebuffer", Interest::Instead},
        {&pretend, Purpose::Framebuffers, "openexr", Interest::None},
        {&pretend, Purpose::Viewer, "openexr", Interest::Instead},
        {&pretend, Purpose::Viewer, "shadow", Interest::None},
        {&fail, Purpose::Framebuffers, "framebuffer", Interest::None},
        {&fail, Purpose::Viewer, "openexr", Interest::None},
    };
    for (const auto &each : cases) {
        PictureWindow window(each.purpose, each.opener);
        EXPECT_FALSE(window.wantsUnfinished());
        EXPECT_EQ(window.interestIn(each.type), each.interest) << each.type;
        EXPECT_EQ(window.wantsUnfinished(), each.interest == Interest::Instead);
    }
    std::string problem;
    EXPECT_FALSE(PictureWindow(Purpose::Viewer, &fail).open(problem));
    EXPECT_EQ(problem, "no screen");
}

TEST_F(Window, showsAllThatComesBeforeItEnds) {
    {
        PictureWindow window(Purpose::Viewer, &pretend);
        window.interestIn("openexr");
        window.take("seen", grey(), false);
        window.take("seen", grey(), true);
    }
    EXPECT_EQ(desk.revealed, (std::array<int, 2>{100, 70}));
    ASSERT_FALSE(desk.titles.empty());
    EXPECT_EQ(desk.titles.back(), "seen: R");
}

TEST_F(Window, staysUntilItIsClosed) {
    desk.hasOnlooker = true;
    std::atomic<bool> gone{false};
    std::thread program([&] {
        PictureWindow window(Purpose::Framebuffers, &pretend);
        window.interestIn("framebuffer");
        window.take("seen", grey(), true);
    });
    std::thread watcher([&] { program.join(), gone = true; });
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    EXPECT_FALSE(gone);
    does({Kind::Key, 0, 0, "q"});
    watcher.join();
    EXPECT_TRUE(gone);
}

TEST_F(Window, closedByTheUserEndsWhatItIsToEnd) {
    for (const Purpose purpose : {Purpose::Framebuffers, Purpose::Viewer}) {
        PictureWindow window(purpose, &pretend);
        window.interestIn("framebuffer");
        window.take("seen", grey(), false);
        EXPECT_FALSE(window.wantsEnd());
        does({Kind::Close});
        EXPECT_TRUE(comesTrue([&] { return !window.wantsUnfinished(); }));
        EXPECT_EQ(window.wantsEnd(), purpose == Purpose::Viewer);
        window.take("seen", grey(), true); // Nobody sees it.
    }
}

TEST_F(Window, isDismissedByItsProgram) {
    desk.hasOnlooker = true;
    PictureWindow window(Purpose::Framebuffers, &pretend);
    window.interestIn("framebuffer");
    window.take("seen", grey(), true);
    window.close(); // Else the test would wait here.
}

} // namespace
} // namespace candela

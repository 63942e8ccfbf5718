// SPDX-License-Identifier: Apache-2.0
// A window that shows the pictures of displays while they are made, in a thread of its own.
#pragma once

#include "image/display_taker.h"
#include "image/view/view.h"
#include "image/view/window_driver.h"

#include <condition_variable>
#include <mutex>
#include <thread>

namespace candela {

class PictureWindow final : public DisplayTaker {
public:
    /// Which displays it shows: those of type "framebuffer", and closing it leaves the render
    /// alone; or all but maps of depths, and closing it ends the render.
    enum class Purpose { Framebuffers, Viewer };

    /// It opens when there is something to show.
    explicit PictureWindow(Purpose, WindowOpener = &openWindow);
    /// What is on a screen stays there until the user closes it.
    ~PictureWindow() override;

    /// None, too, if there is no screen.
    Interest interestIn(const std::string &type) override;
    void take(const std::string &display, Picture, bool isFinished) override;
    bool wantsUnfinished() const override;
    bool wantsEnd() const override;

    /// False, and `problem` says why, if there is no screen.
    bool open(std::string &problem);
    /// Nobody need look any more.
    void close();

private:
    enum class State { Unopened, Open, Closed, Failed };
    void run();
    /// All that the user has done by now; true if that changes what is seen.
    bool handleEvents(WindowDriver &, std::optional<ViewEvent> first);

    const WindowOpener opener_;
    const Purpose purpose_;
    mutable std::mutex mutex_;
    std::condition_variable opened_;
    State state_ = State::Unopened;
    std::string problem_;
    View view_;
    std::optional<std::array<int, 2>> size_; ///< To reveal it in; once.
    bool isNew_ = false;                     ///< There is something to paint.
    bool isOver_ = false;                    ///< Nothing more will come.
    bool isDismissed_ = false;
    std::thread thread_; ///< Last: it uses all the others.
};

} // namespace candela

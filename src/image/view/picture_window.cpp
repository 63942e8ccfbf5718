// SPDX-License-Identifier: Apache-2.0
#include "image/view/picture_window.h"

#include <utility>

namespace candela {

namespace {

/// How long a window may be late, in milliseconds.
constexpr int glance = 20;
/// More than a screen has is cut to it.
constexpr std::array<int, 2> largestWindow{4096, 4096};

} // namespace

PictureWindow::PictureWindow(Purpose purpose, WindowOpener opener)
    : opener_(opener), purpose_(purpose) {}

PictureWindow::~PictureWindow() {
    {
        std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    if (thread_.joinable())
        thread_.join();
}

void PictureWindow::close() {
    std::lock_guard lock(mutex_);
    isDismissed_ = true;
}

bool PictureWindow::open(std::string &problem) {
    std::unique_lock lock(mutex_);
    if (state_ == State::Unopened && !thread_.joinable())
        thread_ = std::thread([this] { run(); });
    opened_.wait(lock, [&] { return state_ != State::Unopened; });
    problem = problem_;
    return state_ == State::Open || state_ == State::Closed;
}

DisplayTaker::Interest PictureWindow::interestIn(const std::string &type) {
    const bool isMap = type == "zfile" || type == "shadow";
    const bool wanted = purpose_ == Purpose::Viewer ? !isMap : type == "framebuffer";
    std::string problem;
    return wanted && open(problem) ? Interest::Instead : Interest::None;
}

void PictureWindow::take(const std::string &display, Picture picture, bool isFinished) {
    std::lock_guard lock(mutex_);
    if (state_ != State::Open)
        return;
    if (!size_)
        size_ = View::sizeFor(picture, largestWindow);
    view_.show(display, std::move(picture), isFinished);
    isNew_ = true;
}

bool PictureWindow::wantsUnfinished() const {
    std::lock_guard lock(mutex_);
    return state_ == State::Open;
}

bool PictureWindow::wantsEnd() const {
    std::lock_guard lock(mutex_);
    return purpose_ == Purpose::Viewer && state_ == State::Closed;
}

bool PictureWindow::handleEvents(WindowDriver &driver, std::optional<ViewEvent> event) {
    bool changed = false;
    for (; event; event = driver.wait(0))
        changed = view_.handle(*event) || changed;
    return changed;
}

void PictureWindow::run() {
    std::string problem;
    const std::unique_ptr<WindowDriver> driver = opener_(problem);
    std::unique_lock lock(mutex_);
    problem_ = problem;
    state_ = driver ? State::Open : State::Failed;
    opened_.notify_all();
    bool revealed = false;
    while (driver && !view_.isClosed() && !isDismissed_) {
        if (isOver_ && !isNew_ && !(size_ && driver->hasOnlooker()))
            break;
        lock.unlock();
        std::optional<ViewEvent> event = driver->wait(glance);
        lock.lock();
        if (size_ && !std::exchange(revealed, true)) {
            driver->reveal((*size_)[0], (*size_)[1]);
            view_.handle({ViewEvent::Kind::Resize, (*size_)[0], (*size_)[1]});
        }
        const bool changed = handleEvents(*driver, std::move(event));
        if (revealed && (std::exchange(isNew_, false) || changed)) {
            driver->setTitle(view_.title());
            driver->show(view_.paint(), view_.width(), view_.height());
        }
    }
    if (driver)
        state_ = State::Closed;
}

} // namespace candela

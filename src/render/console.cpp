// SPDX-License-Identifier: Apache-2.0
#include "render/console.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace candela {

namespace {

std::string durationText(double seconds) {
    char text[32];
    int whole = int(std::lround(seconds));
    if (whole < 60)
        std::snprintf(text, sizeof text, "%d s", whole);
    else if (whole < 3600)
        std::snprintf(text, sizeof text, "%d:%02d min", whole / 60, whole % 60);
    else
        std::snprintf(text, sizeof text, "%d:%02d h", whole / 3600, whole / 60 % 60);
    return text;
}

std::string barOf(double done) {
    constexpr int width = 30;
    const int filled = int(done * width);
    char percent[16];
    std::snprintf(percent, sizeof percent, " %3d %%", int(done * 100));
    return "[" + std::string(filled, '#') + std::string(width - filled, '.') + "]" + percent;
}

} // namespace

Console::Console(Words words)
    : showProgress_(words != Words::Messages && isatty(STDERR_FILENO)),
      tellResults_(words == Words::Results && !showProgress_) {}

Console::~Console() {
    clearLine();
    for (const Diagnostic &note : limit_.rest())
        std::fprintf(stderr, "%s\n", format(note).c_str());
}

void Console::clearLine() {
    if (lineShown_)
        std::fputs("\r\033[K", stderr);
    lineShown_ = false;
}

void Console::report(const Diagnostic &diagnostic) {
    std::lock_guard lock(mutex_);
    if (diagnostic.severity >= Severity::Error)
        failed_ = true;
    if (!limit_.admits(diagnostic))
        return;
    clearLine();
    std::fprintf(stderr, "%s\n", format(diagnostic).c_str());
}

void Console::begin(const std::string &task) {
    std::lock_guard lock(mutex_);
    task_ = task;
    start_ = lastShown_ = Clock::now();
    done_ = 0;
}

void Console::progress(double done) {
    if (!showProgress_)
        return;
    std::lock_guard lock(mutex_);
    done_ = std::max(done_, done);
    if (done_ > 0)
        show(task_ + " " + barOf(done_) + ", " + durationText(elapsed() * (1 - done_) / done_) +
             " left");
}

void Console::step(const std::string &name, double done) {
    if (!showProgress_)
        return;
    std::lock_guard lock(mutex_);
    const std::string known = done >= 0 ? " " + barOf(std::min(done, 1.0)) : "";
    show(name + known + ", " + durationText(elapsed()));
}

double Console::elapsed() const {
    return std::chrono::duration<double>(Clock::now() - start_).count();
}

void Console::show(const std::string &line) {
    const auto now = Clock::now();
    if (now - lastShown_ < std::chrono::milliseconds(100))
        return;
    lastShown_ = now;
    std::fprintf(stderr, "\r\033[K%s", line.c_str());
    lineShown_ = true;
}

void Console::remark(const std::string &words) {
    std::lock_guard lock(mutex_);
    if ((!showProgress_ && !tellResults_) || !remarks_.insert(words).second)
        return;
    clearLine();
    std::fprintf(showProgress_ ? stderr : stdout, "note: %s\n", words.c_str());
}

void Console::end(const std::string &summary) {
    std::lock_guard lock(mutex_);
    clearLine();
    if (showProgress_)
        std::fprintf(stderr, "%s (%.2f s)\n", summary.c_str(), elapsed());
    if (tellResults_)
        std::printf("%s\n", summary.c_str()); // Without the time: the same for the same render.
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "render/console.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

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

} // namespace

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
    auto now = Clock::now();
    if (now - lastShown_ < std::chrono::milliseconds(100) || done_ <= 0)
        return;
    lastShown_ = now;
    double elapsed = std::chrono::duration<double>(now - start_).count();
    constexpr int width = 30;
    int filled = int(done_ * width);
    std::string bar = std::string(filled, '#') + std::string(width - filled, '.');
    std::fprintf(stderr, "\r\033[K%s [%s] %3d %%, %s left", task_.c_str(), bar.c_str(),
                 int(done_ * 100), durationText(elapsed * (1 - done_) / done_).c_str());
    lineShown_ = true;
}

void Console::end(const std::string &summary) {
    std::lock_guard lock(mutex_);
    clearLine();
    double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
    if (showProgress_)
        std::fprintf(stderr, "%s (%.2f s)\n", summary.c_str(), elapsed);
}

} // namespace candela

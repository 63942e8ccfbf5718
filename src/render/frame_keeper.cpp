// SPDX-License-Identifier: Apache-2.0
#include "render/frame_keeper.h"

#include "foundation/base/whole_file.h"

#include <algorithm>
#include <new>
#include <optional>
#include <system_error>

namespace candela {

namespace {

using namespace std::chrono_literals;

/// Between two looks at signals and clock: nobody notices it.
constexpr auto glance = 50ms;
/// From one look to the next, and how many times longer than a look.
constexpr auto betweenLooks = 250ms;
constexpr int lookShare = 20;
/// Samples in flight end within a fraction of it, unless a shader does not end.
constexpr auto grace = 1500ms;

/// A thread takes memory, and counts as that.
template <class Work> std::thread started(Work work) {
    try {
        return std::thread(std::move(work));
    } catch (const std::system_error &) {
        throw std::bad_alloc();
    }
}

} // namespace

FrameKeeper::FrameKeeper(const FrameKeeping &keeping, FrameProgress &progress,
                         const ResumableSink &sink, Duties duties, DiagnosticSink &diagnostics)
    : keeping_(keeping), progress_(progress), sink_(sink), duties_(std::move(duties)),
      diagnostics_(diagnostics), thread_(started([this] { watch(); })) {}

FrameKeeper::~FrameKeeper() { leave(); }

void FrameKeeper::leave() {
    if (!thread_.joinable())
        return;
    {
        std::lock_guard lock(mutex_);
        isOver_ = true;
    }
    changed_.notify_all();
    thread_.join();
}

FrameEnd FrameKeeper::reasonToEnd() const {
    return duties_.isInterrupted()            ? FrameEnd::Interrupted
           : Clock::now() > keeping_.deadline ? FrameEnd::OutOfTime
                                              : FrameEnd::Whole;
}

void FrameKeeper::watch() {
    const auto between = std::chrono::duration<double>(keeping_.secondsBetween);
    const auto saveLater = [&] {
        return Clock::now() + std::chrono::duration_cast<Clock::duration>(between);
    };
    auto nextSave = saveLater();
    auto nextLook = Clock::now() + betweenLooks;
    std::optional<Clock::time_point> lastMoment;
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, glance, [&] { return isOver_; })) {
        if (lastMoment && Clock::now() > *lastMoment) {
            progress_.close();
            duties_.takeOver(end_);
        }
        if (lastMoment)
            continue;
        if (const FrameEnd reason = reasonToEnd(); reason != FrameEnd::Whole) {
            end_ = reason;
            progress_.stop();
            lastMoment = Clock::now() + grace;
        } else if (!keeping_.checkpointFile.empty() && Clock::now() > nextSave) {
            lock.unlock();
            save();
            lock.lock();
            nextSave = saveLater();
        } else if (duties_.look && Clock::now() > nextLook) {
            lock.unlock();
            nextLook = look();
            lock.lock();
        }
    }
}

FrameKeeper::Clock::time_point FrameKeeper::look() {
    const auto begin = Clock::now();
    progress_.hold([&](const FramePosition *) { duties_.look(); });
    const auto end = Clock::now();
    return end + std::max<Clock::duration>(betweenLooks, lookShare * (end - begin));
}

void FrameKeeper::save() {
    std::string bytes, problem;
    try {
        progress_.hold([&](const FramePosition *position) {
            if (position)
                bytes = encodeCheckpoint({keeping_.frame, false, keeping_.identity, *position, {}},
                                         &sink_);
        });
        if (bytes.empty() || writeWholeFile(keeping_.checkpointFile, bytes, problem))
            return;
    } catch (const std::bad_alloc &) {
        problem = "there is not enough memory for it";
    }
    if (failed_)
        return;
    failed_ = true;
    diagnostics_.error({}, "the checkpoint cannot be written, and the render goes on without: " +
                               problem);
}

} // namespace candela

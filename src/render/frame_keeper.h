// SPDX-License-Identifier: Apache-2.0
// Watches over a frame while it is rendered: ends it when it shall end, and saves it now and then.
#pragma once

#include "foundation/base/diagnostics.h"
#include "render/checkpoint.h"

#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace candela {

/// How a frame came to its end. Refused: its checkpoint is of another.
enum class FrameEnd { Whole, Interrupted, OutOfTime, Refused };

/// What is to become of a frame that is not done in one go.
struct FrameKeeping {
    using Clock = std::chrono::steady_clock;

    bool heedsSignals = false; ///< SIGINT and SIGTERM end the frame, not the program.
    Clock::time_point deadline = Clock::time_point::max();
    std::string checkpointFile;       ///< Empty = none.
    double secondsBetween = 60;       ///< From one checkpoint to the next.
    int frame = 0;                    ///< As Checkpoint has it.
    FrameIdentity identity{};         ///< Of the frame.
    std::optional<Checkpoint> from{}; ///< Where it goes on.
    FrameIdentity solution{};         ///< What radiosity's solution is of; see solution_keeping.h.
};

class FrameKeeper {
public:
    struct Duties {
        std::function<bool()> isInterrupted;
        /// Looks at what there is by now, while nothing comes; now and then, for a small share of
        /// the time. Nobody looks if it is empty.
        std::function<void()> look;
        /// Called by the keeper's thread, and is not to return: work that was to end a while ago
        /// has not (a shader that does not come back). Nothing comes into the sink any more.
        std::function<void(FrameEnd)> takeOver;
    };
    /// All must outlive it.
    FrameKeeper(const FrameKeeping &, FrameProgress &, const ResumableSink &, Duties,
                DiagnosticSink &);
    ~FrameKeeper();

    /// The frame's work has ended: it is watched no longer.
    void leave();
    FrameEnd end() const { return end_; }
    /// Writes the checkpoint; not amid light paths, when the last one stays. What goes wrong is
    /// reported once.
    void save();

private:
    using Clock = FrameKeeping::Clock;
    void watch();
    /// Has the duty look; when it may again.
    Clock::time_point look();
    /// Whether it is to end now, and why.
    FrameEnd reasonToEnd() const;

    const FrameKeeping &keeping_;
    FrameProgress &progress_;
    const ResumableSink &sink_;
    const Duties duties_;
    DiagnosticSink &diagnostics_;
    std::atomic<FrameEnd> end_{FrameEnd::Whole};
    bool failed_ = false; ///< To save; said.
    std::mutex mutex_;
    std::condition_variable changed_;
    bool isOver_ = false;
    std::thread thread_; ///< Last: it uses all the others.
};

} // namespace candela

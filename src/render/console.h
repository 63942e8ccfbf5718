// SPDX-License-Identifier: Apache-2.0
// Standard error: diagnostics as they come (of each kind no more than are worth reading), and a
// line of progress below them.
#pragma once

#include "foundation/base/diagnostic_limit.h"
#include "foundation/base/diagnostics.h"

#include <atomic>
#include <chrono>
#include <mutex>
#include <set>
#include <string>

namespace candela {

class Console : public DiagnosticSink {
public:
    /// What is printed beside diagnostics: nothing (--quiet); progress, where standard error is a
    /// terminal; and what has been made, on standard output where it is none.
    enum class Words { Messages, Progress, Results };
    explicit Console(Words);
    /// Says how many more there were of what was too much to print.
    ~Console() override;

    void report(const Diagnostic &) override;
    /// True once an error has been reported, printed or not.
    bool failed() const { return failed_; }

    /// A new task, named for the progress line; its clock starts.
    void begin(const std::string &task);
    /// The share of it that is done, in [0,1]; from any thread.
    void progress(double done);
    /// What a task of several steps is at, and the share of that step that is done; negative where
    /// nobody knows it. The clock goes on.
    void step(const std::string &name, double done);
    /// What users may like to know of what has been made; the same words are said once.
    void remark(const std::string &);
    /// Ends the task and leaves a line of what it was and how long it took.
    void end(const std::string &summary);

private:
    using Clock = std::chrono::steady_clock;
    void clearLine();
    /// Puts a line into the place of the last one, if that has stood for a while.
    void show(const std::string &line);
    double elapsed() const; ///< Seconds of the task.

    const bool showProgress_, tellResults_;
    std::atomic<bool> failed_{false};
    std::mutex mutex_;
    DiagnosticLimit limit_;
    std::string task_;
    std::set<std::string> remarks_; ///< That have been made.
    Clock::time_point start_, lastShown_;
    double done_ = 0;
    bool lineShown_ = false;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// A program that answers each line with RIB, up to a byte of 0377 or its end (RunProgram:
// RI 3.2, 5.7). Private to the room.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <sys/types.h>
#include <vector>

namespace candela {

/// What an answer may take.
struct AnswerLimits {
    double secondsOfSilence = 60;
    double seconds = 600;
    std::size_t bytes = std::size_t(1) << 30;
};

class AnsweringProgram {
public:
    /// Starts the file that the first word names, with the others as its arguments. Null if it
    /// cannot be started; `why` then says so.
    static std::unique_ptr<AnsweringProgram> start(const std::vector<std::string> &words,
                                                   const AnswerLimits &, std::string &why);
    /// Ends it, and all that it has started.
    ~AnsweringProgram();

    /// Sends a line. False if it takes none; `why` then says so.
    bool ask(const std::string &line, std::string &why);
    /// Some bytes of the answer, as ByteSource::Read.
    std::size_t read(char *to, std::size_t most, std::string &failure);
    /// It has ended, or broken a limit: it can be asked no more.
    bool isDone() const { return done_; }
    /// It has broken a limit.
    bool isBad() const { return bad_; }
    /// Waits for it to end. How it did, if that was in error; empty if not.
    std::string verdict();

private:
    using Clock = std::chrono::steady_clock;
    AnsweringProgram(pid_t, int input, int output, const AnswerLimits &);
    /// Waits until it can be read from or written to; false after too long.
    bool wait(int file, short events, std::string &why);
    bool waitForEnd(double seconds);
    std::size_t broken(std::string &failure, const std::string &how);

    pid_t process_;
    int input_, output_;
    AnswerLimits limits_;
    Clock::time_point asked_;
    std::size_t bytes_ = 0; ///< Of the answer so far.
    bool done_ = false, bad_ = false;
};

} // namespace candela

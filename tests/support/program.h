// SPDX-License-Identifier: Apache-2.0
// Runs the candela program as a user would, and keeps what it said.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

struct RunSettings {
    std::string program{};    ///< Another copy of candela; empty = candelaProgram().
    std::string folder{};     ///< The current folder of the run; empty = that of the test.
    std::string input{};      ///< Path of standard input; empty = /dev/null.
    long fileSizeLimit = -1;  ///< Largest file it may write, bytes (RLIMIT_FSIZE); -1 = any.
    long memoryLimit = -1;    ///< Most address space it may take, bytes (RLIMIT_AS); -1 = any.
    int secondsAllowed = 120; ///< Times timeScale().
    int sentSignal = 0;       ///< A signal that is sent to it; 0 = none.
    double signalAfter = 0;   ///< Seconds of wall clock from its start to then.
};

struct Outcome {
    int status = -1;      ///< The exit status; -1 if a signal ended it.
    int signal = 0;       ///< That signal (SIGALRM: it took longer than it was allowed).
    std::string out, err; ///< Standard output and standard error.

    bool says(const std::string &text) const { return err.find(text) != std::string::npos; }
    /// Standard error but for what it says of black pictures and of lights that do nothing or more
    /// than they say: where they are meant to be so.
    std::string errBesidesLight() const;
    /// All of it, for the message of a failed test.
    std::string text() const;
};

/// Path of build/bin/candela.
std::string candelaProgram();

/// $CANDELA_TIME_SCALE, else 1: how much slower than usual programs may be, for emulators and
/// sanitizers.
double timeScale();

/// Runs candela with these arguments and waits for it. $CANDELA_LAUNCHER, words between blanks,
/// comes before the program: an emulator does not follow its child into the programs it starts.
Outcome runCandela(const std::vector<std::string> &arguments, const RunSettings & = {});

} // namespace candela::test

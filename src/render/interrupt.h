// SPDX-License-Identifier: Apache-2.0
// Ctrl-C (or SIGTERM) while something is at work that can end soon and leave all in order.
#pragma once

#include <csignal>

namespace candela {

/// While it lives SIGINT and SIGTERM are noted, once: a second one ends the program, as one does
/// without it. A program that was started to ignore SIGINT goes on ignoring it. No two may live at
/// once.
class Interrupt {
public:
    Interrupt();
    ~Interrupt();
    Interrupt(const Interrupt &) = delete;
    Interrupt &operator=(const Interrupt &) = delete;

    bool asked() const;

private:
    struct sigaction interruptBefore_, terminateBefore_;
};

/// The exit status of a program that was interrupted, as shells have it.
inline constexpr int statusOfInterrupt = 128 + SIGINT;

} // namespace candela

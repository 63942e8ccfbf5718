// SPDX-License-Identifier: Apache-2.0
#include "render/interrupt.h"

#include <atomic>

namespace candela {

namespace {

std::atomic<bool> noted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // Else a handler may not touch it.

/// The next one, of either kind, is not for us.
void note(int) {
    noted = true;
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

void noteUnlessIgnored(int signal, struct sigaction &before) {
    sigaction(signal, nullptr, &before);
    if (before.sa_handler == SIG_IGN)
        return;
    struct sigaction once {};
    once.sa_handler = note;
    once.sa_flags = SA_RESTART;
    sigaction(signal, &once, nullptr);
}

} // namespace

Interrupt::Interrupt() {
    noted = false;
    noteUnlessIgnored(SIGINT, interruptBefore_);
    noteUnlessIgnored(SIGTERM, terminateBefore_);
}

Interrupt::~Interrupt() {
    sigaction(SIGINT, &interruptBefore_, nullptr);
    sigaction(SIGTERM, &terminateBefore_, nullptr);
}

bool Interrupt::asked() const { return noted; }

} // namespace candela

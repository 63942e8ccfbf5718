// SPDX-License-Identifier: Apache-2.0
#include "render/interrupt.h"

#include <atomic>

namespace candela {

namespace {

std::atomic<bool> noted{false};
static_assert(std::atomic<bool>::is_always_lock_free); // Else a handler may not touch it.

void note(int) { noted = true; }

} // namespace

Interrupt::Interrupt() {
    noted = false;
    sigaction(SIGINT, nullptr, &before_);
    if (before_.sa_handler == SIG_IGN)
        return;
    struct sigaction once {};
    once.sa_handler = note;
    once.sa_flags = int(SA_RESETHAND | SA_RESTART);
    sigaction(SIGINT, &once, nullptr);
}

Interrupt::~Interrupt() { sigaction(SIGINT, &before_, nullptr); }

bool Interrupt::asked() const { return noted; }

} // namespace candela

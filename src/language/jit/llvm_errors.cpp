// SPDX-License-Identifier: Apache-2.0
#include "language/jit/llvm_errors.h"

#include <llvm/Support/ErrorHandling.h>

#include <csetjmp>
#include <cstdio>
#include <new>

namespace candela {

namespace {

struct Guard {
    std::jmp_buf back;
    char message[512] = "";
};

thread_local Guard *innermost = nullptr;

/// LLVM is built without exceptions, so that only a jump leads out of it.
void leave(void *, const char *reason, bool) {
    if (!innermost)
        return; // LLVM goes on to say it and to end the process.
    std::snprintf(innermost->message, sizeof innermost->message, "%s", reason);
    std::longjmp(innermost->back, 1);
}

void installHandlers() {
    static const bool installed = [] {
        llvm::install_fatal_error_handler(leave);
        llvm::install_bad_alloc_error_handler(leave);
        return true;
    }();
    (void)installed;
}

} // namespace

std::string runGuarded(const std::function<void()> &work) {
    installHandlers();
    Guard guard;
    Guard *const outer = innermost;
    innermost = &guard;
    std::string memory;
    if (setjmp(guard.back) == 0) {
        try {
            work();
        } catch (const std::bad_alloc &) {
            memory = "out of memory";
        }
    }
    innermost = outer;
    return memory.empty() ? guard.message : memory;
}

} // namespace candela

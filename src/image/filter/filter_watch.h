// SPDX-License-Identifier: Apache-2.0
// How far a stack of filters is, and whether it is to go on.
#pragma once

#include "image/filter/filter_stack.h"

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>

namespace candela {

/// Tells listeners about all filters of a stack, some times a second, from one thread at a time.
class FilterWatch {
public:
    explicit FilterWatch(const FilterListeners &listeners) : listeners_(listeners) {}

    void begin(const std::string &filter, int done);
    /// What part of the filter is done; < 0: not known.
    void progress(double part);
    /// Whether the stack goes on. From any thread.
    bool goesOn();
    bool isInterrupted() const { return interrupted_; }

private:
    bool isTime();

    const FilterListeners &listeners_;
    std::mutex mutex_;
    std::string filter_;
    int done_ = 0;
    std::atomic<std::int64_t> nextTime_{0};
    std::atomic<bool> interrupted_{false};
};

} // namespace candela

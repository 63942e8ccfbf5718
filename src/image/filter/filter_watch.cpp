// SPDX-License-Identifier: Apache-2.0
#include "image/filter/filter_watch.h"

#include <chrono>

namespace candela {

void FilterWatch::begin(const std::string &filter, int done) {
    filter_ = filter;
    done_ = done;
    progress(-1);
}

/// True some times a second.
bool FilterWatch::isTime() {
    using namespace std::chrono;
    constexpr std::int64_t interval = 100'000'000; // Nanoseconds.
    const std::int64_t now = steady_clock::now().time_since_epoch() / 1ns;
    std::int64_t next = nextTime_;
    return now >= next && nextTime_.compare_exchange_strong(next, now + interval);
}

void FilterWatch::progress(double part) {
    if (!isTime())
        return;
    std::lock_guard lock(mutex_);
    if (listeners_.progress)
        listeners_.progress(filter_, done_, part);
    if (listeners_.interrupted && listeners_.interrupted())
        interrupted_ = true;
}

bool FilterWatch::goesOn() {
    progress(-1);
    return !interrupted_;
}

} // namespace candela

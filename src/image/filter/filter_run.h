// SPDX-License-Identifier: Apache-2.0
// One filter at work: its maps, its pixel loops on all cores, what it asks while it runs.
#pragma once

#include "image/filter/filter_stack.h"

#include <atomic>
#include <mutex>
#include <optional>

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

/// Runs the filter: "Cs" is what `maps` has as "Ci", which becomes what the filter makes of it.
/// Places and maps that it cannot have are reported, and the maps then stay as they are.
void runFilter(const FilterCode &, ImageMaps &maps, FilterWatch &, DiagnosticSink &);

} // namespace candela

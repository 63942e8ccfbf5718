// SPDX-License-Identifier: Apache-2.0
// Shaders that answer NaN or infinity: said once, with shader, pixel and sample, then counted.
#pragma once

#include "foundation/base/diagnostics.h"
#include "light/path/settings.h"

#include <mutex>
#include <set>
#include <string>

namespace candela {

class NonFiniteReporter {
public:
    NonFiniteReporter(TransportStatistics &statistics, DiagnosticSink &diagnostics)
        : statistics_(statistics), diagnostics_(diagnostics) {}

    void found(const std::string &shader, int x, int y, int sample) {
        ++statistics_.nonFiniteSamples;
        std::lock_guard lock(mutex_);
        if (reported_.insert(shader).second)
            diagnostics_.warning({}, "shader \"" + shader +
                                         "\" gave a value that is not finite at pixel (" +
                                         std::to_string(x) + ", " + std::to_string(y) +
                                         "), sample " + std::to_string(sample) +
                                         "; it counts as black, further ones are not reported");
    }

private:
    TransportStatistics &statistics_;
    DiagnosticSink &diagnostics_;
    std::mutex mutex_;
    std::set<std::string> reported_;
};

} // namespace candela

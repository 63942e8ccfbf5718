// SPDX-License-Identifier: Apache-2.0
// Shaders that answer NaN or infinity: said once, with shader and place, then counted.
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

    /// `place`: "pixel (3, 4), sample 5".
    void found(const std::string &shader, const std::string &place) {
        ++statistics_.nonFiniteSamples;
        std::lock_guard lock(mutex_);
        if (reported_.insert(shader).second)
            diagnostics_.warning({}, "shader \"" + shader +
                                         "\" gave a value that is not finite at " + place +
                                         "; it counts as black, further ones are not reported");
    }

private:
    TransportStatistics &statistics_;
    DiagnosticSink &diagnostics_;
    std::mutex mutex_;
    std::set<std::string> reported_;
};

} // namespace candela

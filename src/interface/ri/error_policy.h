// SPDX-License-Identifier: Apache-2.0
// RiErrorHandler: what becomes of what is found wrong.
#pragma once

#include "foundation/base/diagnostics.h"

#include <atomic>
#include <string>

namespace candela {

/// Hands diagnostics on as RiErrorHandler says. Under "ignore", warnings and errors are dropped;
/// under "abort" the first error stops the reading; a fatal error always does. The one of a run is
/// for all of its parts to report to.
class ErrorPolicy : public DiagnosticSink {
public:
    enum class Mode { Ignore, Print, Abort };

    explicit ErrorPolicy(DiagnosticSink &next) : next_(next) {}
    void report(const Diagnostic &) override;
    void setMode(Mode mode) { mode_ = mode; }
    bool stopped() const { return stopped_; }

private:
    DiagnosticSink &next_;
    std::atomic<Mode> mode_ = Mode::Print;
    std::atomic<bool> stopped_ = false;
};

} // namespace candela

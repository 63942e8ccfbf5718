// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/error_policy.h"

namespace candela {

void ErrorPolicy::report(const Diagnostic &diagnostic) {
    bool fatal = diagnostic.severity == Severity::Fatal;
    bool error = diagnostic.severity == Severity::Error;
    if (mode_ == Mode::Ignore && !fatal)
        return;
    next_.report(diagnostic);
    bool abort = error && mode_ == Mode::Abort;
    if (fatal || abort) {
        bool first = !stopped_.exchange(true);
        if (abort && first)
            next_.report({Severity::Fatal,
                          diagnostic.where,
                          "stopped at the first error, as ErrorHandler \"abort\" asks",
                          {},
                          1});
    }
}

} // namespace candela

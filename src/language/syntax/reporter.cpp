// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/reporter.h"

namespace candela::sl {

bool Reporter::isNew(const Place &where, const std::string &message) {
    return said_.emplace(where.file, where.line, where.column, message).second;
}

void Reporter::error(const Place &where, std::string message) {
    if (hopeless() || !isNew(where, message))
        return;
    sink_.report(diagnosticAt(Severity::Error, where, std::move(message)));
    if (++errors_ == errorLimit)
        sink_.report(
            diagnosticAt(Severity::Error, where, "too many errors; the rest is not shown"));
}

void Reporter::warning(const Place &where, std::string message) {
    if (hopeless() || warnings_ >= warningLimit || !isNew(where, message))
        return;
    sink_.report(diagnosticAt(Severity::Warning, where, std::move(message)));
    if (++warnings_ == warningLimit)
        sink_.report(
            diagnosticAt(Severity::Warning, where, "too many warnings; the rest is not shown"));
}

void Reporter::warnOnce(const Place &where, const std::string &message) {
    if (saidOnce_.insert(message).second)
        warning(where, message);
}

void Reporter::hint(const Place &where, std::string message) {
    if (tellsHints_)
        warning(where, std::move(message));
}

} // namespace candela::sl

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/messages.h"

namespace candela::ir {

void Messages::error(const sl::Place &where, const std::string &message) {
    if (!closed_ && reported_.insert(where.location().text() + message).second)
        sink_.report(sl::diagnosticAt(Severity::Error, where, message));
}

void Messages::warning(const sl::Place &where, const std::string &message) {
    if (!closed_ && warned_.insert(where.location().text() + message).second)
        sink_.report(sl::diagnosticAt(Severity::Warning, where, message));
}

} // namespace candela::ir

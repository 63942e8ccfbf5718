// SPDX-License-Identifier: Apache-2.0
// What only the lowering finds wrong.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/semantics/typed_ast.h"

#include <set>
#include <string>

namespace candela::ir {

/// Reports each message at a place once, for functions and loop conditions are lowered repeatedly.
class Messages {
public:
    explicit Messages(DiagnosticSink &sink) : sink_(sink) {}

    void error(const sl::Place &, const std::string &message);
    void warning(const sl::Place &, const std::string &message);
    /// No more are reported: they would follow from the last.
    void close() { closed_ = true; }
    /// Whether there was an error.
    bool failed() const { return !reported_.empty(); }

private:
    DiagnosticSink &sink_;
    std::set<std::string> reported_, warned_;
    bool closed_ = false;
};

} // namespace candela::ir

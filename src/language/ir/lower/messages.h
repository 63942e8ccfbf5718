// SPDX-License-Identifier: Apache-2.0
// Errors that only the lowering finds.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/semantics/typed_ast.h"

#include <set>
#include <string>

namespace candela::ir {

/// Reports each error at a place once, for functions and loop conditions are lowered repeatedly.
class Messages {
public:
    explicit Messages(DiagnosticSink &sink) : sink_(sink) {}

    void error(const sl::Place &, const std::string &message);
    /// Whether there was an error.
    bool failed() const { return !reported_.empty(); }

private:
    DiagnosticSink &sink_;
    std::set<std::string> reported_;
};

} // namespace candela::ir

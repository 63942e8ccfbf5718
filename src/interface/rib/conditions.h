// SPDX-License-Identifier: Apache-2.0
// The conditional blocks that are open, one inside the other. Private to the room.
#pragma once

#include "foundation/base/diagnostics.h"

#include <functional>
#include <vector>

namespace candela {

class Conditions {
public:
    explicit Conditions(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {}

    /// True where a condition does not hold.
    bool skip() const { return !blocks_.empty() && !blocks_.back().runs; }

    // The requests. `holds` is asked only where it counts.
    void begin(const SourceLocation &, const std::function<bool()> &holds);
    void elseIf(const SourceLocation &, const char *request, const std::function<bool()> &holds);
    void end(const SourceLocation &);

    std::size_t depth() const { return blocks_.size(); }
    /// At the end of a file that began at that depth: what is open is reported and closed.
    void closeTo(std::size_t depth);

private:
    struct Block {
        SourceLocation where;
        bool runs;           ///< This branch.
        bool wasRun = false; ///< An earlier one, or the block stands in what is skipped.
        bool sawElse = false;
    };
    DiagnosticSink &diagnostics_;
    std::vector<Block> blocks_;
    int uncounted_ = 0; ///< Blocks beyond what may be nested, all skipped.
};

} // namespace candela

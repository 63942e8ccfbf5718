// SPDX-License-Identifier: Apache-2.0
// Keeps a mistake that a file makes ten thousand times from being told ten thousand times.
#pragma once

#include "foundation/base/diagnostics.h"

#include <map>
#include <string>
#include <vector>

namespace candela {

/// What messages that differ by their numbers and quoted names alone have in common.
std::string kindOf(const Diagnostic &);

/// Counts the messages of each kind. Not for several threads at once.
class DiagnosticLimit {
public:
    /// So many of a kind are worth reading.
    static constexpr int most = 20;
    /// So many bytes are, of all kinds: what a program writes can be wrong in ever new ways.
    static constexpr std::size_t mostBytes = 256 << 10;

    /// True if it is still one of those to be told.
    bool admits(const Diagnostic &);
    /// A note for each kind that had more than were told: how many more, and the first of those
    /// as an example; one for all that came when enough had been told. Starts counting anew.
    std::vector<Diagnostic> rest();

private:
    struct Kind {
        int number = 0; ///< In the order of their coming.
        std::size_t count = 0;
        std::string example;
    };
    std::map<std::string, Kind> kinds_;
    std::size_t toldBytes_ = 0;
    std::size_t untold_ = 0; ///< Of kinds that came too late to be told at all.
};

} // namespace candela

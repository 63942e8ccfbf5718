// SPDX-License-Identifier: Apache-2.0
// The regular expressions of match(): POSIX extended ones over bytes, without back references.
// Patterns and subjects may come from a RIB, so the time is bounded: at most linear in the subject,
// whatever the pattern (std::regex tries paths one by one and recurses for each letter).
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

class RegularExpression {
public:
    /// Nothing if the pattern is malformed or too large (it counts to more than a few thousand).
    static std::optional<RegularExpression> parse(const std::string &pattern);

    /// Whether it matches any part of the subject.
    bool foundIn(const std::string &subject) const;

    using Bytes = std::bitset<256>;
    enum class Kind { Bytes, Fork, AtStart, AtEnd, Found };
    /// A state of the machine that reads the subject.
    struct State {
        Kind kind = Kind::Found;
        Bytes bytes;    ///< Kind::Bytes: those that lead on to `next`.
        int next = 0;   ///< Where it goes on.
        int second = 0; ///< Kind::Fork: where it goes on as well.
    };

private:
    std::vector<State> states_; ///< The first starts; the last is Found.
};

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Points for `candela probe`, a line each, from a file of any length in little memory.
#pragma once

#include "light/probe/probe.h"

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// The lines of an open file, one after the other.
class LineReader {
public:
    /// Longer ones come cut off, as no list of numbers is so long.
    static constexpr std::size_t longestLine = 4096;

    explicit LineReader(int file) : file_(file) {}
    /// The next line, without its end; nothing at the end of the file, or where reading fails.
    std::optional<std::string_view> next();
    /// Of the line that came last, from 1.
    int number() const { return number_; }
    /// Why reading has failed; empty if it has not.
    const std::string &problem() const { return problem_; }

private:
    bool fill();

    int file_, number_ = 0;
    std::string buffer_, line_, problem_;
    std::size_t at_ = 0;
};

/// What stands in a line.
struct PointLine {
    enum class Kind { Point, Nothing, Flawed };
    Kind kind = Kind::Nothing;
    ProbePoint point{};
    std::string flaw{}; ///< What is wrong, and what to do.
    int column = 0;     ///< Where, from 1.
};

/// "x y z dx dy dz", between them blanks, tabs, a comma or a semicolon. Lines that are blank or
/// begin with # hold nothing, nor does a first line of names (CSV).
PointLine readPointLine(std::string_view line, int number);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// How much a text may ask of the compiler and of the machine (docs/compiler-limits.md). Whoever
// writes instructions does it with a Builder, which counts them; a pass that stands where the count
// has been exceeded leaves off, and whoever asked for it names the place.
#pragma once

#include <cstddef>

namespace candela::ir {

/// Instructions of a function. Passes that could multiply them keep something shorter instead (a
/// loop as it is, fewer cones).
inline constexpr std::size_t mostInstructions = 1 << 16;
/// Instructions of functions' bodies that are in the text already: each call writes another copy.
inline constexpr std::size_t mostCopied = 1 << 15;
/// Numbers in all arrays of a function: each is one a lane on the stack.
inline constexpr std::size_t mostArrayNumbers = 1 << 16;
/// Characters of a string that concat() or format() makes, and of all strings together.
inline constexpr std::size_t mostCharacters = 1 << 16, mostCharactersTogether = 1 << 22;
/// Turns of a loop for a point, unless an option says another number (Function::mostTurns).
inline constexpr int mostLoopTurns = 1 << 20;

/// What is left of a limit; without a number there is none.
class Budget {
public:
    explicit Budget(std::size_t most = std::size_t(-1)) : left_(most) {}

    /// Takes an instruction of the source's line `line` (0: none of its own). False, and nothing is
    /// taken, if none is left.
    bool spend(int line) {
        if (exceeded_)
            return false;
        exceeded_ = left_ == 0;
        left_ -= exceeded_ ? 0 : 1;
        line_ = line > 0 ? line : line_;
        return !exceeded_;
    }
    std::size_t left() const { return left_; }
    bool exceeded() const { return exceeded_; }
    /// Where it was exceeded, or spent from last.
    int line() const { return line_; }

private:
    std::size_t left_;
    bool exceeded_ = false;
    int line_ = 0;
};

} // namespace candela::ir

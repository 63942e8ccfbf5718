// SPDX-License-Identifier: Apache-2.0
// Shaders whose compilation grows faster than their text, or has a long text.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace candela::budgets {

enum class Outcome : char {
    Compiles,
    Refused, ///< With an error that names the place, the limit and a way out.
};

struct LargeShader {
    std::string name;
    Outcome outcome;
    std::string text;
    /// Refused: part of the message.
    std::string says = {};
    /// Code is generated too, in the same time.
    bool generates = false;

    friend std::ostream &operator<<(std::ostream &out, const LargeShader &shader) {
        return out << shader.name;
    }
};

/// In the order of the table that docs/compiler-limits.md explains.
std::vector<LargeShader> largeShaders();

} // namespace candela::budgets

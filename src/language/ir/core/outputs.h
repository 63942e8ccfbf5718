// SPDX-License-Identifier: Apache-2.0
// Names of what functions write.
#pragma once

#include <compare>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace candela::ir {

/// The rows of outputs.def, and what a shader's text calls otherwise.
enum class OutputKind : std::uint8_t {
#define OUTPUT(name, components, text, ended, meaning) name,
#define CONE_OUTPUT OUTPUT
#include "language/ir/core/outputs.def"
#undef CONE_OUTPUT
#undef OUTPUT
    Parameter, ///< An output parameter, or a bound of the paper's ("DCiDu").
};

/// Planes of an output of outputs.def, where colors have so many samples.
int componentsOf(OutputKind, int colorSamples);

/// What it holds at points where a loop had to be ended (budget.h); also of parameters.
float valueWhenEnded(OutputKind);

/// What an output is of.
struct OutputName {
    OutputName(OutputKind k, int coneNumber = 0) : kind(k), cone(coneNumber) {}
    /// Of a shader's own parameter, whatever it is called.
    static OutputName ofParameter(std::string_view name);
    /// As text() spells it; what no row of outputs.def is called, a parameter.
    OutputName(std::string_view);
    OutputName(const std::string &text) : OutputName(std::string_view(text)) {}
    OutputName(const char *text) : OutputName(std::string_view(text)) {}

    /// "Ci", "cone 0 axis", the parameter's name.
    std::string text() const;
    auto operator<=>(const OutputName &) const = default;

    OutputKind kind;
    int cone = 0;          ///< Which, of a cone's outputs.
    std::string parameter; ///< Of OutputKind::Parameter.
};

/// What an output plane holds.
struct OutputSlot {
    OutputName name;
    int component = 0;
    float whenEnded = 0; ///< As valueWhenEnded().
};

/// Index of the plane that holds it; -1 if none does.
int slotOf(const std::vector<OutputSlot> &, const OutputName &, int component = 0);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/outputs.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace candela::ir {

namespace {

struct OutputRow {
    int components;
    std::string_view text;
    float ended;
    bool ofCone;
};

constexpr int Color = 0;
constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float endless = std::numeric_limits<float>::infinity();
constexpr OutputRow rows[] = {
#define OUTPUT(name, components, text, ended, meaning) {components, text, ended, false},
#define CONE_OUTPUT(name, components, text, ended, meaning) {components, text, ended, true},
#include "language/ir/core/outputs.def"
#undef CONE_OUTPUT
#undef OUTPUT
};

constexpr std::string_view coneStarts = "cone ";

/// The number behind "cone ", which is taken off the text; -1 if the text does not start so.
int takeCone(std::string_view &text) {
    if (!text.starts_with(coneStarts))
        return -1;
    int cone = -1;
    const char *end = text.data() + text.size();
    const auto read = std::from_chars(text.data() + coneStarts.size(), end, cone);
    if (read.ec != std::errc() || read.ptr == end || *read.ptr != ' ')
        return -1;
    text = {read.ptr + 1, std::size_t(end - read.ptr - 1)};
    return cone;
}

} // namespace

int componentsOf(OutputKind kind, int colorSamples) {
    const int components = rows[int(kind)].components;
    return components == Color ? colorSamples : components;
}

float valueWhenEnded(OutputKind kind) {
    return kind == OutputKind::Parameter ? 0 : rows[int(kind)].ended;
}

OutputName::OutputName(std::string_view text) : kind(OutputKind::Parameter) {
    std::string_view rest = text;
    const int number = takeCone(rest);
    const auto row = std::find_if(std::begin(rows), std::end(rows), [&](const OutputRow &r) {
        return r.ofCone == (number >= 0) && r.text == rest;
    });
    if (row == std::end(rows)) {
        parameter = text;
        return;
    }
    kind = OutputKind(row - std::begin(rows));
    cone = std::max(number, 0);
}

OutputName OutputName::ofParameter(std::string_view name) {
    OutputName output(OutputKind::Parameter);
    output.parameter = name;
    return output;
}

std::string OutputName::text() const {
    if (kind == OutputKind::Parameter)
        return parameter;
    const OutputRow &row = rows[int(kind)];
    const std::string text(row.text);
    return row.ofCone ? std::string(coneStarts) + std::to_string(cone) + " " + text : text;
}

int slotOf(const std::vector<OutputSlot> &slots, const OutputName &name, int component) {
    const auto found = std::find_if(slots.begin(), slots.end(), [&](const OutputSlot &slot) {
        return slot.name == name && slot.component == component;
    });
    return found == slots.end() ? -1 : int(found - slots.begin());
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/primitive_variables.h"

#include "foundation/units/color.h"
#include "interface/ri/declarations.h"

#include <algorithm>
#include <cmath>

namespace candela {

static int floatsPerValue(const Declaration &declaration) {
    return declaration.type == ValueType::String ? 0 : std::max(0, declaration.components());
}

static bool allFinite(const std::vector<float> &values) {
    return std::ranges::all_of(values, [](float x) { return std::isfinite(x); });
}

static bool isPosition(const std::string &name) {
    return name == "P" || name == "Pw" || name == "Pz";
}

/// Floats in one value of the variables that have a meaning of their own; 0 for all others.
static int floatsExpected(const std::string &name) {
    if (name == "N" || name == "Np")
        return 3;
    if (name == "Cs" || name == "Os")
        return colorSamples;
    return name == "st" ? 2 : name == "s" || name == "t" ? 1 : 0;
}

/// What is wrong with a variable; empty if nothing is.
static std::string defectOf(const Parameter &parameter, int components) {
    const int expected = floatsExpected(parameter.name);
    if (expected != 0 && components != expected)
        return "is a " + textOf(parameter.declaration) + ", which has " +
               std::to_string(components) + " numbers where " + std::to_string(expected) +
               " are expected";
    if (parameter.floats.empty() || parameter.floats.size() % components != 0)
        return "has the wrong number of floats";
    return allFinite(parameter.floats) ? "" : "is not finite";
}

/// Every second float of "st", from `first` on, as the variable `name`.
static NumericVariable halfOf(const Parameter &st, std::string name, int first) {
    NumericVariable half{std::move(name), {st.declaration.storage, ValueType::Float, 1}, 1, {}};
    half.values.reserve(st.floats.size() / 2);
    for (std::size_t i = first; i < st.floats.size(); i += 2)
        half.values.push_back(st.floats[i]);
    return half;
}

std::vector<NumericVariable> numericVariables(const PrimitiveRecord &record,
                                              DiagnosticSink &diagnostics) {
    std::vector<NumericVariable> result;
    auto add = [&](NumericVariable variable) {
        if (std::ranges::find(result, variable.name, &NumericVariable::name) == result.end())
            result.push_back(std::move(variable));
    };
    for (const Parameter &parameter : record.variables.all) {
        int components = floatsPerValue(parameter.declaration);
        if (components == 0 || isPosition(parameter.name))
            continue;
        if (std::string defect = defectOf(parameter, components); !defect.empty()) {
            diagnostics.error(record.where, "the primitive variable \"" + parameter.name + "\" " +
                                                defect + "; it is left out");
            continue;
        }
        if (parameter.name == "st") {
            add(halfOf(parameter, "s", 0));
            add(halfOf(parameter, "t", 1));
        } else {
            add({parameter.name, parameter.declaration, components, parameter.floats});
        }
    }
    return result;
}

void reportWrongCount(const NumericVariable &variable, long expected, const SourceLocation &where,
                      DiagnosticSink &diagnostics) {
    diagnostics.warning(where, "the primitive variable \"" + variable.name + "\" has " +
                                   std::to_string(variable.count()) + " values where " +
                                   std::to_string(expected) + " are expected; it is ignored");
}

std::vector<float> homogeneousPoints(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    for (const Parameter &parameter : record.variables.all) {
        if (parameter.name != "P" && parameter.name != "Pw")
            continue;
        int size = parameter.name == "P" ? 3 : 4;
        std::vector<float> points;
        points.reserve(parameter.floats.size() / size * 4);
        bool good = parameter.floats.size() % size == 0 && allFinite(parameter.floats);
        for (std::size_t i = 0; good && i < parameter.floats.size(); i += size) {
            const float *p = &parameter.floats[i];
            float w = size == 4 ? p[3] : 1;
            good = w > 0;
            points.insert(points.end(), {p[0], p[1], p[2], w});
        }
        if (!good) {
            diagnostics.error(record.where,
                              "\"" + parameter.name + "\" must hold finite points of " +
                                  std::to_string(size) +
                                  (size == 4 ? " floats with positive w" : " floats") +
                                  "; the primitive is dropped");
            return {};
        }
        return points;
    }
    diagnostics.error(record.where, "the primitive has no \"P\"; it is dropped");
    return {};
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/primitive_checks.h"

#include "interface/ri/bad_faces.h"
#include "interface/ri/declarations.h"
#include "interface/ri/variable_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace candela {

namespace {

bool isPosition(const Parameter &p) { return p.name == "P" || p.name == "Pw" || p.name == "Pz"; }

/// Its faces name points by their numbers.
bool namesPoints(const ShapeRecord &shape) {
    return std::holds_alternative<PolygonsRecord>(shape) ||
           std::holds_alternative<SubdivisionRecord>(shape);
}

bool needsPosition(const ShapeRecord &shape) {
    return namesPoints(shape) || std::holds_alternative<PatchMeshRecord>(shape) ||
           std::holds_alternative<NuPatchRecord>(shape) ||
           std::holds_alternative<PointsRecord>(shape) ||
           std::holds_alternative<CurvesRecord>(shape);
}

/// Patches may give their vertices as "Pw" or, over the unit square, "Pz", NURBS as "Pw".
const Parameter *positionOf(const ShapeRecord &shape, const ParameterList &variables) {
    const bool isMesh = std::holds_alternative<PatchMeshRecord>(shape);
    const Parameter *found = variables.find("P");
    if (!found && (isMesh || std::holds_alternative<NuPatchRecord>(shape)))
        found = variables.find("Pw");
    return found || !isMesh ? found : variables.find("Pz");
}

int valuesIn(const Parameter &p) {
    return int((p.floats.size() + p.strings.size()) / std::max(1, p.declaration.components()));
}

bool hasWholeValues(const Parameter &p) {
    return (p.floats.size() + p.strings.size()) % std::max(1, p.declaration.components()) == 0;
}

bool allFinite(const Parameter &p) {
    return std::ranges::all_of(p.floats, [](float value) { return std::isfinite(value); });
}

/// What is wrong with a variable on a shape with these counts; empty if nothing is.
std::string variableDefect(const Parameter &variable, const VariableCounts &counts) {
    const StorageClass storage = variable.declaration.storage;
    int expected = counts.of(storage);
    if (counts.mayHaveFourCorners && storage == StorageClass::Varying && valuesIn(variable) == 4)
        expected = 4;
    if (!hasWholeValues(variable) || valuesIn(variable) != expected)
        return "'" + variable.name + "' (" + textOf(variable.declaration) + ") needs " +
               std::to_string(std::int64_t(expected) * variable.declaration.components()) +
               " numbers here, found " +
               std::to_string(variable.floats.size() + variable.strings.size());
    if (!allFinite(variable))
        return "'" + variable.name + "' has values that are infinite or not a number";
    return {};
}

/// Widths by the wrong number are still better than none: a surplus is dropped, and the last one
/// serves for what is missing. What is said of it; empty if their number is right or 0.
std::string fitWidths(Parameter &variable, const VariableCounts &counts) {
    const std::size_t given = variable.floats.size();
    const std::size_t expected = std::size_t(std::max(0, counts.of(variable.declaration.storage)));
    const bool isWidth = variable.name == "width" || variable.name == "constantwidth";
    if (!isWidth || variable.declaration.components() != 1 || given == 0 || given == expected)
        return {};
    variable.floats.resize(expected, variable.floats.back());
    return "'" + variable.name + "' has " + std::to_string(given) + " numbers and needs " +
           std::to_string(expected) +
           (given > expected ? ": the first ones count" : ": the last one serves for the rest");
}

} // namespace

std::shared_ptr<const PrimitiveRecord> checkedPrimitive(const char *request, ShapeRecord shape,
                                                        ParameterList variables,
                                                        const Attributes &attributes,
                                                        RequestDiagnostics &diagnostics) {
    const SourceLocation &where = variables.where;
    auto leaveOut = [&](const std::string &why) {
        diagnostics.error(where, request, why + "; the primitive is left out");
        return nullptr;
    };
    const Parameter *position = positionOf(shape, variables);
    if (needsPosition(shape) && !position)
        return leaveOut("it has no \"P\"");
    if (auto *const polygons = std::get_if<PolygonsRecord>(&shape))
        if (const std::string found = leaveOutBadFaces(*polygons, variables); !found.empty())
            diagnostics.error(where, request, found);
    if (std::string defect = defectOf(shape, attributes); !defect.empty())
        return leaveOut(defect);
    std::int64_t vertices = verticesNeeded(shape, attributes);
    if (namesPoints(shape)) {
        const int points = valuesIn(*position);
        if (vertices > points && hasWholeValues(*position))
            return leaveOut("there is no vertex " + std::to_string(vertices - 1) +
                            ": \"P\" holds " + std::to_string(points) + " points, counted from 0");
        vertices = points; // Those that no face uses do no harm.
    }
    VariableCounts counts = countsOf(shape, attributes, int(vertices));
    ParameterList kept{where, {}};
    for (Parameter &variable : variables.all) {
        if (const std::string fitted = fitWidths(variable, counts); !fitted.empty())
            diagnostics.warning(where, request, fitted);
        std::string defect = variableDefect(variable, counts);
        if (variable.name == "Os")
            diagnostics.clampOpacity(where, "\"Os\"", variable.floats);
        if (defect.empty())
            kept.all.push_back(std::move(variable));
        else if (needsPosition(shape) && isPosition(variable))
            return leaveOut(defect);
        else
            diagnostics.error(where, request, defect + "; the variable is left out");
    }
    return std::make_shared<const PrimitiveRecord>(
        PrimitiveRecord{std::move(shape), std::move(kept), where, {}});
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Geometric primitives (RI 3.2, section 5).
#include "interface/ri/state_handlers.h"
#include "interface/ri/variable_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace candela {

namespace {

bool isPosition(const Parameter &p) { return p.name == "P" || p.name == "Pw" || p.name == "Pz"; }

bool needsPosition(const ShapeRecord &shape) {
    return std::holds_alternative<PolygonsRecord>(shape) ||
           std::holds_alternative<PatchMeshRecord>(shape);
}

/// Patches may give their vertices as "Pw" or, over the unit square, "Pz".
const Parameter *positionOf(const ShapeRecord &shape, const ParameterList &variables) {
    const Parameter *found = variables.find("P");
    if (found || !std::holds_alternative<PatchMeshRecord>(shape))
        return found;
    found = variables.find("Pw");
    return found ? found : variables.find("Pz");
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
    int expected = counts.of(variable.declaration.storage);
    if (!hasWholeValues(variable) || valuesIn(variable) != expected)
        return "'" + variable.name + "' (" + textOf(variable.declaration) + ") needs " +
               std::to_string(std::int64_t(expected) * variable.declaration.components()) +
               " numbers here, found " +
               std::to_string(variable.floats.size() + variable.strings.size());
    if (!allFinite(variable))
        return "'" + variable.name + "' has values that are infinite or not a number";
    return {};
}

} // namespace

ParameterList StateHandlers::primitiveVariables(const SourceLocation &where, const char *request,
                                                const TokenList &tokens) {
    ParameterList result{where, {}};
    for (const TokenValue &value : tokens.all) {
        auto token = tokenOf(value, request);
        if (!token)
            continue;
        auto declaration = token->declaration;
        if (!declaration)
            declaration = dictionary_.declaredByUser(token->name);
        if (!declaration)
            declaration = Dictionary::standard(token->name);
        if (!declaration) {
            warnOnce(value.where, "variable:" + token->name,
                     std::string(request) + ": primitive variable '" + token->name +
                         "' has not been declared, so that its class is unknown; it is left out");
            continue;
        }
        if (result.find(token->name))
            error(value.where, request, "'" + token->name + "' is given twice; the first counts");
        else if (auto p = typedParameter(value, *token, *declaration, request, diagnostics_))
            result.all.push_back(std::move(*p));
    }
    return result;
}

void StateHandlers::emit(const SourceLocation &where, const char *request, ShapeRecord shape,
                         const TokenList &tokens) {
    const Attributes &attributes = *attributes_;
    auto leaveOut = [&](const std::string &why) {
        error(where, request, why + "; the primitive is left out");
    };
    ParameterList variables = primitiveVariables(where, request, tokens);
    const Parameter *position = positionOf(shape, variables);
    if (needsPosition(shape) && !position)
        return leaveOut("it has no \"P\"");
    if (std::string defect = defectOf(shape, attributes); !defect.empty())
        return leaveOut(defect);
    std::int64_t vertices = verticesNeeded(shape, attributes);
    if (std::holds_alternative<PolygonsRecord>(shape)) {
        const int points = valuesIn(*position);
        if (vertices > points && hasWholeValues(*position))
            return leaveOut("there is no vertex " + std::to_string(vertices - 1) +
                            ": \"P\" holds " + std::to_string(points) + " points, counted from 0");
        vertices = points; // Those that no polygon uses do no harm.
    }
    VariableCounts counts = countsOf(shape, attributes, int(vertices));
    ParameterList kept{where, {}};
    for (Parameter &variable : variables.all) {
        std::string defect = variableDefect(variable, counts);
        if (variable.name == "Os")
            clampOpacity(where, "\"Os\"", variable.floats);
        if (defect.empty())
            kept.all.push_back(std::move(variable));
        else if (needsPosition(shape) && isPosition(variable))
            return leaveOut(defect);
        else
            error(where, request, defect + "; the variable is left out");
    }
    if (isFlat(where, request, "the primitive"))
        return;
    auto record = std::make_shared<const PrimitiveRecord>(
        PrimitiveRecord{std::move(shape), std::move(kept), where});
    tell({std::move(record), -1, currentAttributes(), currentTransform()});
}

void StateHandlers::sphere(const SourceLocation &where, float radius, float zMin, float zMax,
                           float thetaMax, const TokenList &tokens) {
    emit(where, "Sphere", SphereRecord{radius, zMin, zMax, thetaMax}, tokens);
}

void StateHandlers::cone(const SourceLocation &where, float height, float radius, float thetaMax,
                         const TokenList &tokens) {
    emit(where, "Cone", ConeRecord{height, radius, thetaMax}, tokens);
}

void StateHandlers::cylinder(const SourceLocation &where, float radius, float zMin, float zMax,
                             float thetaMax, const TokenList &tokens) {
    emit(where, "Cylinder", CylinderRecord{radius, zMin, zMax, thetaMax}, tokens);
}

void StateHandlers::hyperboloid(const SourceLocation &where, float x1, float y1, float z1, float x2,
                                float y2, float z2, float thetaMax, const TokenList &tokens) {
    emit(where, "Hyperboloid", HyperboloidRecord{{x1, y1, z1}, {x2, y2, z2}, thetaMax}, tokens);
}

void StateHandlers::paraboloid(const SourceLocation &where, float rMax, float zMin, float zMax,
                               float thetaMax, const TokenList &tokens) {
    emit(where, "Paraboloid", ParaboloidRecord{rMax, zMin, zMax, thetaMax}, tokens);
}

void StateHandlers::disk(const SourceLocation &where, float height, float radius, float thetaMax,
                         const TokenList &tokens) {
    emit(where, "Disk", DiskRecord{height, radius, thetaMax}, tokens);
}

void StateHandlers::torus(const SourceLocation &where, float majorRadius, float minorRadius,
                          float phiMin, float phiMax, float thetaMax, const TokenList &tokens) {
    emit(where, "Torus", TorusRecord{majorRadius, minorRadius, phiMin, phiMax, thetaMax}, tokens);
}

/// Values of the vertex points in a list whose shape does not say how many there are.
static int pointsIn(const TokenList &tokens) {
    for (const TokenValue &value : tokens.all)
        if (auto token = parseToken(value.token); token && token->name == "P")
            return int(value.floats.size() / 3);
    return 0;
}

static std::vector<int> ascending(int count) {
    std::vector<int> result(count);
    std::iota(result.begin(), result.end(), 0);
    return result;
}

void StateHandlers::polygon(const SourceLocation &where, const TokenList &tokens) {
    int count = pointsIn(tokens);
    emit(where, "Polygon", PolygonsRecord{{1}, {count}, ascending(count)}, tokens);
}

void StateHandlers::generalPolygon(const SourceLocation &where, const Integers &vertexCounts,
                                   const TokenList &tokens) {
    int count = pointsIn(tokens);
    emit(where, "GeneralPolygon",
         PolygonsRecord{{int(vertexCounts.size())}, vertexCounts, ascending(count)}, tokens);
}

void StateHandlers::pointsPolygons(const SourceLocation &where, const Integers &vertexCounts,
                                   const Integers &vertices, const TokenList &tokens) {
    emit(where, "PointsPolygons",
         PolygonsRecord{Integers(vertexCounts.size(), 1), vertexCounts, vertices}, tokens);
}

void StateHandlers::pointsGeneralPolygons(const SourceLocation &where, const Integers &loopCounts,
                                          const Integers &vertexCounts, const Integers &vertices,
                                          const TokenList &tokens) {
    emit(where, "PointsGeneralPolygons", PolygonsRecord{loopCounts, vertexCounts, vertices},
         tokens);
}

static std::optional<bool> isBicubic(const std::string &type) {
    if (type == "bicubic" || type == "bilinear")
        return type == "bicubic";
    return std::nullopt;
}

void StateHandlers::patch(const SourceLocation &where, const std::string &type,
                          const TokenList &tokens) {
    auto bicubic = isBicubic(type);
    if (!bicubic)
        return error(where, "Patch",
                     "'" + type +
                         "' is unknown: expected \"bilinear\" or "
                         "\"bicubic\"; the primitive is left out");
    int across = *bicubic ? 4 : 2;
    emit(where, "Patch", PatchMeshRecord{*bicubic, across, across, false, false}, tokens);
}

/// "nowrap" is what some exporters write for "nonperiodic".
static std::optional<bool> isPeriodic(const std::string &wrap) {
    if (wrap == "periodic" || wrap == "nonperiodic" || wrap == "nowrap")
        return wrap == "periodic";
    return std::nullopt;
}

void StateHandlers::patchMesh(const SourceLocation &where, const std::string &type, int uVertices,
                              const std::string &uWrap, int vVertices, const std::string &vWrap,
                              const TokenList &tokens) {
    auto bicubic = isBicubic(type);
    auto uPeriodic = isPeriodic(uWrap), vPeriodic = isPeriodic(vWrap);
    if (!bicubic || !uPeriodic || !vPeriodic)
        return error(where, "PatchMesh",
                     "expected \"bilinear\" or \"bicubic\", and \"periodic\" or \"nonperiodic\" "
                     "twice, found '" +
                         type + "', '" + uWrap + "', '" + vWrap + "'; the primitive is left out");
    emit(where, "PatchMesh",
         PatchMeshRecord{*bicubic, uVertices, vVertices, *uPeriodic, *vPeriodic}, tokens);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Geometric primitives (RI 3.2, section 5).
#include "interface/ri/primitive_checks.h"
#include "interface/ri/state_handlers.h"

#include <numeric>

namespace candela {

void StateHandlers::emit(const SourceLocation &where, const char *request, ShapeRecord shape,
                         const TokenList &tokens) {
    auto primitive =
        checkedPrimitive(request, std::move(shape), parameters_.ofPrimitive(where, tokens, request),
                         *state_.attributes, diagnostics_);
    if (!primitive || isFlat(where, request, "the primitive"))
        return;
    if (motion_)
        motion_->primitives.push_back(std::move(primitive));
    else
        tellPrimitive(std::move(primitive));
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
        return diagnostics_.error(where, "Patch",
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
        return diagnostics_.error(
            where, "PatchMesh",
            "expected \"bilinear\" or \"bicubic\", and \"periodic\" or \"nonperiodic\" "
            "twice, found '" +
                type + "', '" + uWrap + "', '" + vWrap + "'; the primitive is left out");
    emit(where, "PatchMesh",
         PatchMeshRecord{*bicubic, uVertices, vVertices, *uPeriodic, *vPeriodic}, tokens);
}

/// A spline has at least as many vertices as its order (RI 3.2, 5.2): else its order is as many.
static SplineRecord splineOf(int vertices, int order, const Floats &knots, float low, float high) {
    SplineRecord spline{vertices, order, knots, low, high};
    const int excess = order - vertices;
    if (vertices >= 2 && excess > 0 && int(knots.size()) == vertices + order) {
        spline.order = vertices;
        spline.knots.assign(knots.begin() + excess / 2, knots.begin() + excess / 2 + 2 * vertices);
    }
    return spline;
}

void StateHandlers::nuPatch(const SourceLocation &where, int uVertices, int uOrder,
                            const Floats &uKnots, float uMin, float uMax, int vVertices, int vOrder,
                            const Floats &vKnots, float vMin, float vMax, const TokenList &tokens) {
    emit(where, "NuPatch",
         NuPatchRecord{splineOf(uVertices, uOrder, uKnots, uMin, uMax),
                       splineOf(vVertices, vOrder, vKnots, vMin, vMax)},
         tokens);
}

void StateHandlers::geometry(const SourceLocation &where, const std::string &type,
                             const TokenList &tokens) {
    // PRMan's shapes for area lights, of unit size; they shine along z, and those that are far
    // away have none.
    if (type == "spherelight")
        return sphere(where, .5f, -.5f, .5f, 360, tokens);
    if (type == "disklight")
        return disk(where, 0, .5f, 360, tokens);
    if (type == "rectlight")
        return patch(where, "bilinear",
                     {{{"vertex point P",
                        where,
                        {-.5f, -.5f, 0, .5f, -.5f, 0, -.5f, .5f, 0, .5f, .5f, 0},
                        {}}}});
    if (type == "envsphere" || type == "distantlight")
        return;
    if (type != "teapot")
        return diagnostics_.warnOnce(where, "geometry " + type,
                                     "Geometry: \"" + type +
                                         "\" is not known here: it is not drawn");
    emit(where, "Geometry", GeometryRecord{type}, tokens);
}

void StateHandlers::points(const SourceLocation &where, const TokenList &tokens) {
    emit(where, "Points", PointsRecord{pointsIn(tokens)}, tokens);
}

void StateHandlers::blobby(const SourceLocation &where, int leaves, const Integers &codes,
                           const Floats &floats, const Strings &strings, const TokenList &tokens) {
    emit(where, "Blobby", BlobbyRecord{leaves, codes, floats, strings}, tokens);
}

void StateHandlers::curves(const SourceLocation &where, const std::string &type,
                           const Integers &vertexCounts, const std::string &wrap,
                           const TokenList &tokens) {
    auto periodic = isPeriodic(wrap);
    if ((type != "linear" && type != "cubic") || !periodic)
        return diagnostics_.error(where, "Curves",
                                  "expected \"linear\" or \"cubic\", and \"periodic\" or "
                                  "\"nonperiodic\", found '" +
                                      type + "' and '" + wrap + "'; the primitive is left out");
    emit(where, "Curves", CurvesRecord{type == "cubic", *periodic, vertexCounts}, tokens);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_strokes.h"

#include "world/geometry/curves_surface.h"
#include "world/geometry/points_surface.h"

#include <algorithm>

namespace candela {

namespace {

/// The variables of a primitive, those that make its form taken out.
struct StrokeVariables {
    NumericVariable width{"width", {StorageClass::Constant, ValueType::Float, 1}, 1, {1}};
    std::optional<NumericVariable> normal;
    std::vector<NumericVariable> others;
};

bool isWidth(const NumericVariable &variable) {
    return (variable.name == "width" || variable.name == "constantwidth") &&
           variable.components == 1;
}

/// Those with as many values as `valuesOf` says of their class; others are reported.
template <class Counts>
StrokeVariables variablesOf(const PrimitiveRecord &record, Counts valuesOf,
                            DiagnosticSink &diagnostics) {
    StrokeVariables result;
    for (NumericVariable &variable : numericVariables(record, diagnostics)) {
        const int expected = valuesOf(variable.declaration.storage);
        if (variable.count() != expected) {
            reportWrongCount(variable, expected, record.where, diagnostics);
        } else if (variable.name == "N" || (variable.name == "Np" && !result.normal)) {
            result.normal = std::move(variable);
        } else if (variable.name != "Np") {
            if (isWidth(variable)) {
                result.width = variable;
                for (float &width : result.width.values)
                    width = std::max(width, 0.0f);
            }
            result.others.push_back(std::move(variable));
        }
    }
    return result;
}

/// "P" as it is, "Pw" projected.
std::vector<Vec3> positionsOf(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    const std::vector<float> homogeneous = homogeneousPoints(record, diagnostics);
    std::vector<Vec3> points(homogeneous.size() / 4);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float *p = &homogeneous[4 * i];
        points[i] = Vec3{p[0], p[1], p[2]} / p[3];
    }
    return points;
}

std::vector<std::shared_ptr<const Surface>> refuse(const char *what, const PrimitiveRecord &record,
                                                   DiagnosticSink &diagnostics) {
    diagnostics.error(record.where, std::string("the ") + what + "; the primitive is dropped");
    return {};
}

/// Beyond this squares of lengths leave the range of floats.
constexpr float largestExtent = 1e12f;

bool isComputable(const Box3 &bound) {
    const Vec3 extent = bound.extent();
    return std::max({extent.x, extent.y, extent.z}) < largestExtent;
}

} // namespace

std::vector<std::shared_ptr<const Surface>> makePoints(const PointsRecord &,
                                                       const PrimitiveRecord &record,
                                                       const Attributes &attributes,
                                                       DiagnosticSink &diagnostics) {
    const std::vector<Vec3> positions = positionsOf(record, diagnostics);
    if (positions.empty())
        return {};
    auto valuesOf = [&](StorageClass storage) {
        return storage == StorageClass::Constant || storage == StorageClass::Uniform
                   ? 1
                   : int(positions.size());
    };
    StrokeVariables variables = variablesOf(record, valuesOf, diagnostics);
    std::vector<std::array<float, 4>> knots;
    knots.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        knots.push_back({positions[i].x, positions[i].y, positions[i].z,
                         variables.width.values[variables.width.count() == 1 ? 0 : i] / 2});
    if (std::ranges::all_of(knots, [](const auto &knot) { return !(knot[3] > 0); }))
        return refuse("points have no width", record, diagnostics);
    auto surface =
        std::make_shared<PointsSurface>(std::move(knots), std::move(variables.others),
                                        std::move(variables.normal), attributes.textureCoordinates);
    if (!isComputable(surface->bound()))
        return refuse("points are farther apart than can be computed with", record, diagnostics);
    return {std::move(surface)};
}

std::vector<std::shared_ptr<const Surface>> makeCurves(const CurvesRecord &curves,
                                                       const PrimitiveRecord &record,
                                                       const Attributes &attributes,
                                                       DiagnosticSink &diagnostics) {
    const std::vector<Vec3> points = positionsOf(record, diagnostics);
    if (points.empty())
        return {};
    CurveLayout layout(curves, attributes.vBasis);
    auto valuesOf = [&](StorageClass storage) { return layout.valuesOf(storage); };
    StrokeVariables variables = variablesOf(record, valuesOf, diagnostics);
    NumericVariable position{"P", {StorageClass::Vertex, ValueType::Point, 1}, 3, {}};
    position.values.reserve(3 * points.size());
    for (Vec3 point : points)
        position.values.insert(position.values.end(), {point.x, point.y, point.z});
    if (variables.normal && std::ranges::count(variables.normal->values, 0.0f) ==
                                std::ptrdiff_t(variables.normal->values.size()))
        variables.normal.reset(); // They face nowhere: tubes.
    if (std::ranges::all_of(variables.width.values, [](float width) { return !(width > 0); }))
        return refuse("curves have no width", record, diagnostics);
    auto surface = std::make_shared<CurvesSurface>(
        std::move(layout), std::move(position), std::move(variables.width),
        std::move(variables.others), std::move(variables.normal), attributes.textureCoordinates);
    if (!isComputable(surface->bound()))
        return refuse("curves are larger than can be computed with", record, diagnostics);
    return {std::move(surface)};
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Triangles of a PolygonsRecord, with everything that is known of each corner.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/primitive_variables.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

struct PolygonMesh {
    std::vector<Vec3> points;
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< Into points.
    std::vector<std::uint32_t> face;                     ///< Of each triangle.
    /// Of each triangle, places in PolygonsRecord::vertices: what facevarying values count by.
    std::vector<std::array<std::uint32_t, 3>> faceVertices;
    int faceCount = 0;
    std::size_t vertexCount = 0; ///< Of PolygonsRecord::vertices.
};

/// Checks the record and triangulates it. Faces without area are left out and holes that do not fit
/// filled, with one report for the primitive. Nothing if no triangle is left.
std::optional<PolygonMesh> triangulateFaces(const PolygonsRecord &, const PrimitiveRecord &,
                                            DiagnosticSink &);

/// A primitive variable on the triangles of a mesh: one value for all, one a triangle, or one a
/// corner to interpolate.
struct PolygonVariable {
    enum class Rate { Mesh, Face, Corner };
    Rate rate = Rate::Mesh;
    int components = 1;
    /// Places of values: by triangle for Face, by corner (three a triangle) for Corner.
    std::vector<std::uint32_t> places;
    std::vector<float> values;

    /// The component's value at each corner of the triangle.
    std::array<float, 3> corners(std::uint32_t triangle, int component) const {
        auto at = [&](std::size_t place) { return values[place * components + component]; };
        if (rate == Rate::Mesh)
            return {at(0), at(0), at(0)};
        if (rate == Rate::Face)
            return {at(places[triangle]), at(places[triangle]), at(places[triangle])};
        const std::uint32_t *p = &places[std::size_t(triangle) * 3];
        return {at(p[0]), at(p[1]), at(p[2])};
    }
};

/// The variable on the mesh, or nothing, with a warning, if its count is wrong.
std::optional<PolygonVariable> onPolygons(const NumericVariable &, const PolygonMesh &,
                                          const SourceLocation &, DiagnosticSink &);

} // namespace candela

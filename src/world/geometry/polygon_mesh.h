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
    /// The last of `points`, where sides of a face cross: between two places in
    /// PolygonsRecord::vertices, and the points there. Places of their own count on from these.
    struct MadePoint {
        std::array<std::uint32_t, 2> places, points;
        float share;
    };
    std::vector<MadePoint> made;
    int faceCount = 0;
    std::size_t vertexCount = 0; ///< Of PolygonsRecord::vertices.
};

/// The record's points; empty if it has none that are sound.
std::vector<Vec3> pointsOf(const PrimitiveRecord &, DiagnosticSink &);

/// Appends those that are made to the record's points, which are of a mesh's number.
void addMadePoints(PolygonMesh &);

/// Checks the record and triangulates it. Faces without area are left out and holes that do not fit
/// filled, with one report for the primitive. Nothing if no triangle is left.
std::optional<PolygonMesh> triangulateFaces(const PolygonsRecord &, const PrimitiveRecord &,
                                            DiagnosticSink &);

/// A primitive variable on the triangles of a mesh.
struct PolygonVariable {
    /// What there is a value for; those of points and corners are interpolated.
    enum class Rate { Mesh, Face, Point, Corner };
    Rate rate = Rate::Mesh;
    int components = 1;
    std::vector<float> values;

    /// The component's value at each corner of the triangle.
    std::array<float, 3> corners(const PolygonMesh &mesh, std::uint32_t triangle,
                                 int component) const {
        auto at = [&](std::size_t place) { return values[place * components + component]; };
        auto all = [](float value) { return std::array<float, 3>{value, value, value}; };
        switch (rate) {
        case Rate::Mesh: return all(at(0));
        case Rate::Face: return all(at(mesh.face[triangle]));
        default: break;
        }
        const auto &places =
            rate == Rate::Point ? mesh.triangles[triangle] : mesh.faceVertices[triangle];
        return {at(places[0]), at(places[1]), at(places[2])};
    }
};

/// The variable on the mesh, or nothing, with a warning, if its count is wrong.
std::optional<PolygonVariable> onPolygons(const NumericVariable &, const PolygonMesh &,
                                          const SourceLocation &, DiagnosticSink &);

} // namespace candela

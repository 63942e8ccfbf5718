// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_patch_mesh.h"

#include "world/geometry/assemble_patches.h"
#include "world/geometry/patch_basis.h"

#include <algorithm>
#include <cmath>

namespace candela {

/// x and y run with u and v over the mesh, from 0 to 1; z has the polynomials of the heights.
static PatchPolynomials heightField(const PatchTopology &topology, std::span<const float> heights) {
    PatchPolynomials z = convertVertices(topology, heights, 1);
    PatchPolynomials result{z.degree, 3};
    const PatchGrid &grid = topology.grid;
    int size = z.coefficientCount(), powerOfU = z.degree + 1;
    for (int patch = 0; patch < grid.patches(); ++patch) {
        std::array<float, 16> x{}, y{};
        x[0] = float(patch % grid.u.patches) / float(grid.u.patches);
        x[powerOfU] = 1 / float(grid.u.patches);
        y[0] = float(patch / grid.u.patches) / float(grid.v.patches);
        y[1] = 1 / float(grid.v.patches);
        const float *planes[] = {x.data(), y.data(), z.of(patch, 0)};
        for (const float *c : planes)
            result.coefficients.insert(result.coefficients.end(), c, c + size);
    }
    return result;
}

static VertexBasis vertexBasis(const PatchTopology &topology) {
    return {topology.vertices(), [&](std::span<const float> values, int components) {
                return convertVertices(topology, values, components);
            }};
}

/// The positions and, unless they are heights, the sides; or nothing and a report.
static std::optional<PatchPolynomials> positionsOf(const PatchTopology &topology,
                                                   const PrimitiveRecord &record, MeshSides &sides,
                                                   DiagnosticSink &diagnostics) {
    auto wrongCount = [&](std::size_t count) {
        diagnostics.error(record.where,
                          "the patch mesh has " + std::to_string(count) + " control points where " +
                              std::to_string(topology.vertices()) + " are expected; it is dropped");
        return std::nullopt;
    };
    auto pz = std::ranges::find(record.variables.all, "Pz", &Parameter::name);
    if (pz != record.variables.all.end()) {
        if (pz->floats.size() != std::size_t(topology.vertices()))
            return wrongCount(pz->floats.size());
        if (std::ranges::all_of(pz->floats, [](float z) { return std::isfinite(z); }))
            return heightField(topology, pz->floats);
        diagnostics.error(record.where,
                          "a height of \"Pz\" is not finite; the patch mesh is dropped");
        return std::nullopt;
    }
    std::vector<float> points = homogeneousPoints(record, diagnostics);
    if (points.empty())
        return std::nullopt;
    if (points.size() != std::size_t(topology.vertices()) * 4)
        return wrongCount(points.size() / 4);
    sides = sideCurves(topology, points);
    return fromHomogeneous(points, vertexBasis(topology));
}

SurfaceList makePatchMesh(const PatchMeshRecord &mesh, const PrimitiveRecord &record,
                          const Attributes &attributes, DiagnosticSink &diagnostics) {
    std::string why;
    auto topology = patchTopology(mesh, attributes, why);
    if (!topology) {
        diagnostics.error(record.where, "the patch mesh " + why + "; it is dropped");
        return {};
    }
    MeshSides sides;
    auto positions = positionsOf(*topology, record, sides, diagnostics);
    if (!positions)
        return {};
    const VertexBasis basis = vertexBasis(*topology);
    const auto surface = assemblePatches(
        {"patch mesh", record, attributes, topology->grid, mesh.bicubic ? &basis : nullptr},
        std::move(*positions), std::move(sides), diagnostics);
    return surface ? SurfaceList{surface} : SurfaceList{};
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_patch_mesh.h"

#include "world/geometry/patch_surface.h"

#include <algorithm>
#include <cmath>

namespace candela {

/// x and y run with u and v over the mesh, from 0 to 1; z has the polynomials of the heights.
static PatchPolynomials heightField(const PatchTopology &topology, std::span<const float> heights) {
    PatchPolynomials z = convertVertices(topology, heights, 1);
    PatchPolynomials result{z.degree, 3, false, {}};
    const PatchGrid &grid = topology.grid;
    int size = z.coefficientCount(), powerOfU = z.degree + 1;
    for (int patch = 0; patch < grid.patches(); ++patch) {
        std::array<float, 16> x{}, y{};
        x[0] = float(patch % grid.patchesU) / float(grid.patchesU);
        x[powerOfU] = 1 / float(grid.patchesU);
        y[0] = float(patch / grid.patchesU) / float(grid.patchesV);
        y[1] = 1 / float(grid.patchesV);
        const float *planes[] = {x.data(), y.data(), z.of(patch, 0)};
        for (const float *c : planes)
            result.coefficients.insert(result.coefficients.end(), c, c + size);
    }
    return result;
}

/// Homogeneous floats by four as they are, or by three where every weight is 1.
static PatchPolynomials fromHomogeneous(const PatchTopology &topology,
                                        const std::vector<float> &points) {
    bool rational = false;
    for (std::size_t i = 3; i < points.size(); i += 4)
        rational |= points[i] != 1;
    if (rational)
        return convertVertices(topology, points, 4);
    std::vector<float> plain;
    plain.reserve(points.size() / 4 * 3);
    for (std::size_t i = 0; i < points.size(); i += 4)
        plain.insert(plain.end(), {points[i], points[i + 1], points[i + 2]});
    return convertVertices(topology, plain, 3);
}

/// The positions and, unless they are heights, the sides; or nothing and a report.
static std::optional<PatchPolynomials> positionsOf(const PatchTopology &topology,
                                                   const PrimitiveRecord &record,
                                                   std::array<std::vector<SideCurve>, 4> &sides,
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
    return fromHomogeneous(topology, points);
}

/// Sizes beyond which products of lengths leave the range of floats.
static bool hasUsableSize(const Box3 &box) {
    double size = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z),
                            std::abs(box.high.x), std::abs(box.high.y), std::abs(box.high.z)});
    return size <= 1e12 && length(box.extent()) >= 1e-12;
}

std::vector<std::shared_ptr<const Surface>> makePatchMesh(const PatchMeshRecord &mesh,
                                                          const PrimitiveRecord &record,
                                                          const Attributes &attributes,
                                                          DiagnosticSink &diagnostics) {
    auto refuse = [&](const std::string &why) {
        diagnostics.error(record.where, "the patch mesh " + why + "; it is dropped");
        return std::vector<std::shared_ptr<const Surface>>{};
    };
    std::string why;
    auto topology = patchTopology(mesh, attributes, why);
    if (!topology)
        return refuse(why);
    std::array<std::vector<SideCurve>, 4> sides;
    auto positions = positionsOf(*topology, record, sides, diagnostics);
    if (!positions)
        return {};
    std::vector<PatchBounds> bounds;
    for (int patch = 0; patch < topology->grid.patches(); ++patch) {
        bounds.push_back(patchBounds(*positions, patch));
        if (!bounds.back().valid)
            return refuse("has weights in \"Pw\" that are not positive under its basis");
        if (!hasUsableSize(bounds.back().box) && !(length(bounds.back().box.extent()) == 0))
            return refuse("is too large or too small to be computed with");
    }
    VertexBasis basis{topology->vertices(), [&](std::span<const float> values, int components) {
                          return convertVertices(*topology, values, components);
                      }};
    GridVariables variables(record, attributes, topology->grid, mesh.bicubic ? &basis : nullptr,
                            diagnostics);
    auto surface =
        std::make_shared<PatchSurface>(*topology, std::move(*positions), std::move(bounds),
                                       std::move(sides), std::move(variables));
    if (!surface->hasArea())
        return refuse("has no area");
    return {surface};
}

} // namespace candela

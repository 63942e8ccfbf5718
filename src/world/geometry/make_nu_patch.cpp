// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_nu_patch.h"

#include "world/geometry/assemble_patches.h"
#include "world/geometry/spline_spans.h"
#include "world/geometry/trimmed_surface.h"

namespace candela {

/// The surface as trim curves leave it.
static SurfaceList trimmed(std::shared_ptr<const PatchSurface> whole, TrimRecord curves,
                           const PatchGrid &grid, const PrimitiveRecord &record,
                           const Attributes &attributes, DiagnosticSink &diagnostics) {
    const auto longest = whole->longestDerivatives();
    const auto surface = std::make_shared<TrimmedSurface>(std::move(whole), std::move(curves), grid,
                                                          longest, trimsInside(attributes));
    if (surface->openLoops() > 0)
        diagnostics.warning(record.where,
                            "loops of the NuPatch's trim curves do not end where they "
                            "begin; they are closed by straight lines");
    if (surface->area() > 0)
        return {surface};
    diagnostics.warning(record.where, "the trim curves leave nothing of the NuPatch");
    return {};
}

SurfaceList makeNuPatch(const NuPatchRecord &patch, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    const std::vector<float> points = homogeneousPoints(record, diagnostics);
    if (points.empty())
        return {};
    const SplineMesh mesh(patch);
    const VertexBasis basis{mesh.vertices(), [&](std::span<const float> values, int components) {
                                return mesh.convert(values, components);
                            }};
    const auto surface =
        assemblePatches({"NuPatch", record, attributes, mesh.grid(), &basis},
                        fromHomogeneous(points, basis), mesh.sides(points), diagnostics);
    TrimRecord curves = trimOf(attributes);
    if (!surface)
        return {};
    return curves.empty()
               ? SurfaceList{surface}
               : trimmed(surface, std::move(curves), mesh.grid(), record, attributes, diagnostics);
}

} // namespace candela

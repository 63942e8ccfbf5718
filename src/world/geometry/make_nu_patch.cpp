// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_nu_patch.h"

#include "world/geometry/assemble_patches.h"
#include "world/geometry/spline_spans.h"

namespace candela {

SurfaceList makeNuPatch(const NuPatchRecord &patch, const PrimitiveRecord &record,
                        const Attributes &attributes, DiagnosticSink &diagnostics) {
    const std::vector<float> points = homogeneousPoints(record, diagnostics);
    if (points.empty())
        return {};
    const SplineMesh mesh(patch);
    const VertexBasis basis{mesh.vertices(), [&](std::span<const float> values, int components) {
                                return mesh.convert(values, components);
                            }};
    return assemblePatches({"NuPatch", record, attributes, mesh.grid(), &basis},
                           fromHomogeneous(points, basis), mesh.sides(points), diagnostics);
}

} // namespace candela

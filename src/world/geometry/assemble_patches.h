// SPDX-License-Identifier: Apache-2.0
// What patch meshes of every kind have in common on their way to a surface.
#pragma once

#include "world/geometry/grid_variables.h"
#include "world/geometry/patch_surface.h"

namespace candela {

/// What is being made.
struct PatchOrder {
    const char *name; ///< In messages.
    const PrimitiveRecord &record;
    const Attributes &attributes;
    const PatchGrid &grid;
    const VertexBasis *basis; ///< As GridVariables has it.
};

/// Homogeneous floats by four as they are, or by three where every weight is 1.
PatchPolynomials fromHomogeneous(const std::vector<float> &points, const VertexBasis &);

/// The surface, or null and a report.
std::shared_ptr<const PatchSurface> assemblePatches(const PatchOrder &, PatchPolynomials positions,
                                                    MeshSides sides, DiagnosticSink &);

} // namespace candela

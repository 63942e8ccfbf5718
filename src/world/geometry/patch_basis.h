// SPDX-License-Identifier: Apache-2.0
// From control points to patch polynomials.
#pragma once

#include "interface/ri/primitive_record.h"
#include "world/geometry/patch_polynomials.h"
#include "world/geometry/side_curve.h"

#include <optional>
#include <span>
#include <string>

namespace candela {

/// How the control points of a RiPatchMesh make patches.
struct PatchTopology {
    PatchGrid grid;
    bool bicubic = false;
    int uVertices = 0, vVertices = 0;
    int uStep = 1, vStep = 1;
    std::array<float, 16> uBasis{}, vBasis{}; ///< Bicubic only; rows as in BasisRecord.

    int degree() const { return bicubic ? 3 : 1; }
    int vertices() const { return uVertices * vVertices; }
};

/// The topology of a mesh under these bases, or a sentence why there is none.
std::optional<PatchTopology> patchTopology(const PatchMeshRecord &, const Attributes &,
                                           std::string &why);

/// Values at control points, `components` floats each, as polynomials.
PatchPolynomials convertVertices(const PatchTopology &, std::span<const float> values,
                                 int components);

/// The sides of the patches round a mesh of homogeneous control points, four floats each.
MeshSides sideCurves(const PatchTopology &, std::span<const float> points);

} // namespace candela

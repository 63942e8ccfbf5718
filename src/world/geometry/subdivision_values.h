// SPDX-License-Identifier: Apache-2.0
// Values of faces' corners, as a mesh of their own.
#pragma once

#include "world/geometry/primitive_variables.h"

#include <vector>

namespace candela {

/// The faces as the values connect them: corners that share a vertex and a value are one.
struct ValueMesh {
    SubdivisionRecord mesh;
    std::vector<float> values; ///< Of its vertices.
    int vertices = 0;
};

/// Its outlines and creases are as the tags of `mesh` have them; holes are faces like others.
ValueMesh valueMesh(const NumericVariable &, const SubdivisionRecord &mesh);

} // namespace candela

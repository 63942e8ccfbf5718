// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_geometry.h"

#include "world/geometry/make_patch_mesh.h"
#include "world/geometry/teapot.h"

#include <algorithm>

namespace candela {

SurfaceList makeGeometry(const GeometryRecord &, const PrimitiveRecord &record,
                         const Attributes &attributes, DiagnosticSink &diagnostics) {
    const PatchMeshRecord mesh{true, 4, 4, false, false};
    PrimitiveRecord patch{mesh, record.variables, record.where, {}};
    std::erase_if(patch.variables.all, [](const Parameter &variable) {
        return variable.declaration.storage > StorageClass::Varying;
    });
    patch.variables.all.push_back({"P", {StorageClass::Vertex, ValueType::Point, 1}, {}, {}});
    Attributes bezier = attributes;
    bezier.uBasis = bezier.vBasis = BasisRecord{};
    SurfaceList surfaces;
    for (std::vector<float> &points : teapotPatches()) {
        patch.variables.all.back().floats = std::move(points);
        for (auto &surface : makePatchMesh(mesh, patch, bezier, diagnostics))
            surfaces.push_back(std::move(surface));
    }
    return surfaces;
}

} // namespace candela

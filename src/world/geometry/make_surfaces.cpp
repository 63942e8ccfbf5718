// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_blobby.h"
#include "world/geometry/make_geometry.h"
#include "world/geometry/make_nu_patch.h"
#include "world/geometry/make_patch_mesh.h"
#include "world/geometry/make_quadric.h"
#include "world/geometry/make_strokes.h"
#include "world/geometry/make_subdivision.h"
#include "world/geometry/polygon_surface.h"

namespace candela {

static SurfaceList makePolygons(const PolygonsRecord &polygons, const PrimitiveRecord &record,
                                DiagnosticSink &diagnostics) {
    auto mesh = triangulateFaces(polygons, record, diagnostics);
    if (!mesh)
        return {};
    return {std::make_shared<PolygonSurface>(std::move(*mesh), record, diagnostics)};
}

std::vector<std::shared_ptr<const Surface>>
makeSurfaces(std::shared_ptr<const PrimitiveRecord> record, const Attributes &attributes,
             DiagnosticSink &diagnostics) {
    auto make = [&](const auto &shape) -> SurfaceList {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, PolygonsRecord>)
            return makePolygons(shape, *record, diagnostics);
        else if constexpr (std::is_same_v<Shape, PatchMeshRecord>)
            return makePatchMesh(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, NuPatchRecord>)
            return makeNuPatch(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, SubdivisionRecord>)
            return makeSubdivision(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, GeometryRecord>)
            return makeGeometry(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, PointsRecord>)
            return makePoints(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, CurvesRecord>)
            return makeCurves(shape, *record, attributes, diagnostics);
        else if constexpr (std::is_same_v<Shape, BlobbyRecord>)
            return makeBlobby(shape, *record, diagnostics);
        else
            return makeQuadric(shape, *record, attributes, diagnostics);
    };
    return std::visit(make, record->shape);
}

} // namespace candela

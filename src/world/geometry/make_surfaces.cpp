// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_blobby.h"
#include "world/geometry/make_geometry.h"
#include "world/geometry/make_nu_patch.h"
#include "world/geometry/make_patch_mesh.h"
#include "world/geometry/make_quadric.h"
#include "world/geometry/make_strokes.h"
#include "world/geometry/make_subdivision.h"
#include "world/geometry/moving_surface.h"
#include "world/geometry/polygon_surface.h"

#include <algorithm>

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

std::vector<std::shared_ptr<const Surface>>
makeSurfaces(const std::shared_ptr<const PrimitiveRecord> &record, const Attributes &attributes,
             const Shutter &shutter, DiagnosticSink &diagnostics) {
    SurfaceList surfaces = makeSurfaces(recordAt(record, shutter.open), attributes, diagnostics);
    if (!record->motion || !shutter.hasInterval())
        return surfaces;
    if (std::ranges::any_of(surfaces, [](const auto &surface) { return surface->isStroke(); })) {
        diagnostics.warning(record->where, "points and curves keep the shape that they have when "
                                           "the shutter opens");
        return surfaces;
    }
    const int steps = stepsThrough(record->motion->times, shutter.open, shutter.close);
    std::vector<SurfaceList> inTime{surfaces};
    DiagnosticList heard; // It has been said of the first.
    for (int step = 1; step <= steps; ++step) {
        const double time = shutter.open + double(step) / steps * (shutter.close - shutter.open);
        SurfaceList &later = inTime.emplace_back();
        const auto moved = recordAt(record, time);
        for (const auto &surface : surfaces) {
            const auto *polygons = std::holds_alternative<PolygonsRecord>(record->shape)
                                       ? dynamic_cast<const PolygonSurface *>(surface.get())
                                       : nullptr; // Of polygons that are not the record's own.
            later.push_back(polygons ? polygons->movedTo(*moved, heard) : nullptr);
        }
        if (std::ranges::count(later, nullptr) > 0)
            later = makeSurfaces(moved, attributes, heard);
        if (later.size() != surfaces.size()) {
            diagnostics.warning(record->where, "the primitive comes to nothing while the shutter "
                                               "is open; it keeps its shape");
            return surfaces;
        }
    }
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        SurfaceList own;
        for (const SurfaceList &step : inTime)
            own.push_back(step[k]);
        surfaces[k] = std::make_shared<MovingSurface>(std::move(own));
    }
    return surfaces;
}

} // namespace candela

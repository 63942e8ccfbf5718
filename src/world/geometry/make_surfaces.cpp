// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/curves_surface.h"
#include "world/geometry/make_blobby.h"
#include "world/geometry/make_geometry.h"
#include "world/geometry/make_nu_patch.h"
#include "world/geometry/make_patch_mesh.h"
#include "world/geometry/make_quadric.h"
#include "world/geometry/make_strokes.h"
#include "world/geometry/make_subdivision.h"
#include "world/geometry/moving_surface.h"
#include "world/geometry/points_surface.h"
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
            return makeBlobby(*record, diagnostics);
        else
            return makeQuadric(shape, *record, attributes, diagnostics);
    };
    return std::visit(make, record->shape);
}

/// What the record is at even steps over the shutter's interval; one if it keeps its shape.
static std::vector<std::shared_ptr<const PrimitiveRecord>>
recordsIn(const std::shared_ptr<const PrimitiveRecord> &record, const Shutter &shutter) {
    std::vector<std::shared_ptr<const PrimitiveRecord>> records{recordAt(record, shutter.open)};
    if (!record->motion || !shutter.hasInterval())
        return records;
    const int steps = stepsThrough(record->motion->times, shutter.open, shutter.close);
    for (int step = 1; step <= steps; ++step)
        records.push_back(
            recordAt(record, shutter.open + double(step) / steps * (shutter.close - shutter.open)));
    return records;
}

/// A surface that is each of these at even steps of the shutter's interval.
static std::shared_ptr<const Surface> inMotion(const PrimitiveRecord &record, SurfaceList steps) {
    if (std::holds_alternative<CurvesRecord>(record.shape))
        return std::make_shared<CurvesSurface>(steps);
    if (std::holds_alternative<PointsRecord>(record.shape))
        return std::make_shared<PointsSurface>(steps);
    return std::make_shared<MovingSurface>(std::move(steps));
}

std::vector<std::shared_ptr<const Surface>>
makeSurfaces(const std::shared_ptr<const PrimitiveRecord> &record, const Attributes &attributes,
             const Shutter &shutter, DiagnosticSink &diagnostics) {
    const std::vector<std::shared_ptr<const PrimitiveRecord>> records = recordsIn(record, shutter);
    if (records.size() > 1 && std::holds_alternative<BlobbyRecord>(record->shape))
        return makeMovingBlobby(records, diagnostics);
    SurfaceList surfaces = makeSurfaces(records.front(), attributes, diagnostics);
    if (records.size() == 1)
        return surfaces;
    std::vector<SurfaceList> inTime{surfaces};
    DiagnosticList heard; // It has been said of the first.
    for (std::size_t step = 1; step < records.size(); ++step) {
        SurfaceList &later = inTime.emplace_back();
        const auto &moved = records[step];
        for (const auto &surface : surfaces) {
            const auto *polygons = std::holds_alternative<PolygonsRecord>(record->shape)
                                       ? dynamic_cast<const PolygonSurface *>(surface.get())
                                       : nullptr; // Of polygons that are not the record's own.
            later.push_back(polygons ? polygons->movedTo(*moved, heard) : nullptr);
        }
        if (std::ranges::count(later, nullptr) > 0)
            later = makeSurfaces(moved, attributes, heard);
        const auto goesOn = [](const auto &now, const auto &next) {
            return haveSameNames(*now, *next);
        };
        if (!std::ranges::equal(surfaces, later, goesOn)) {
            diagnostics.warning(record->where,
                                "the primitive comes to nothing, or loses variables, "
                                "while the shutter is open; it keeps its shape");
            return surfaces;
        }
    }
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
        SurfaceList own;
        for (const SurfaceList &step : inTime)
            own.push_back(step[k]);
        surfaces[k] = inMotion(*record, std::move(own));
    }
    return surfaces;
}

} // namespace candela

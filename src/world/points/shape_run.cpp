// SPDX-License-Identifier: Apache-2.0
#include "world/points/shape_run.h"

#include "foundation/base/lanes.h"
#include "world/points/surface_points.h"

#include <algorithm>

namespace candela {

namespace {

void nameOnSphere(const ShapeRun &run, ShadingPoints &points, RunScratch &own) {
    std::fill_n(run.piece, run.count, 0u);
    float *planes = own.planes.get(3 * std::size_t(run.stride));
    const Vec3Planes P{planes, planes + run.stride, planes + 2 * run.stride};
    for (int c = 0; c < 3; ++c)
        lanes::gather(run.count, run.order, points.input(ShaderInput::P, c),
                      planes + c * run.stride);
    for (int k = 0; run.placed && k < run.count; ++k) {
        Matrix4 objectFromCurrent;
        std::copy_n(run.tables.matricesOf(run.instance[k]) + 16, 16, objectFromCurrent.m.begin());
        P.set(k, transformPoint(objectFromCurrent, P.get(k)));
    }
    transformPoints(run.count, run.shape.shapeFromOuter, P);
    run.shape.surface->sphereCoordinates(run.count, P, run.u, run.v);
}

/// (piece, u, v) of the surface from what the rays have met.
void name(const ShapeRun &run, ShadingPoints &points, RunScratch &own) {
    const Shape &shape = run.shape;
    switch (points.named ? Naming::Direct : shape.naming) {
    case Naming::Direct: std::copy_n(run.element, run.count, run.piece); break;
    case Naming::Corners:
        for (int k = 0; k < run.count; ++k)
            run.piece[k] = shape.pieces.empty() ? 0 : shape.pieces[run.element[k]];
        interpolateUv(run.count, run.element, run.u, run.v, shape.triangles.data(),
                      shape.vertexUv.data(), run.u, run.v);
        break;
    case Naming::Sphere: nameOnSphere(run, points, own);
    }
}

} // namespace

ShapeRun makeRun(const PointTables &tables, ShadingPoints &points, const std::int32_t *order,
                 int count, const float *normalSign, RunScratch &own) {
    const int stride = paddedLanes(count);
    float *names = own.names.get(3 * std::size_t(stride));
    std::uint32_t *integers = own.integers.get(3 * std::size_t(stride));
    const ShapeRun run{tables,
                       tables.shapes[points.shape[order[0]]],
                       order,
                       count,
                       stride,
                       points.instance[order[0]] != noHit,
                       names,
                       names + stride,
                       names + 2 * stride,
                       integers,
                       integers + stride,
                       integers + 2 * stride};
    for (int k = 0; k < count; ++k) {
        const int i = order[k];
        run.sign[k] = normalSign ? normalSign[i] : 1;
        run.instance[k] = points.instance[i], run.element[k] = points.element[i];
        run.u[k] = points.u[i], run.v[k] = points.v[i];
    }
    name(run, points, own);
    return run;
}

void placeVectors(const ShapeRun &run, Vec3Planes planes) {
    transformVectors(run.count, run.shape.outerFromShape, planes);
    if (run.placed)
        transformVectorsEach(run.count, run.tables.instanceMatrices.data(), run.instance, planes);
}

void placePoints(const ShapeRun &run, Vec3Planes planes) {
    transformPoints(run.count, run.shape.outerFromShape, planes);
    if (run.placed)
        transformPointsEach(run.count, run.tables.instanceMatrices.data(), run.instance, planes);
}

void placeNormals(const ShapeRun &run, Vec3Planes planes) {
    transformNormals(run.count, run.shape.shapeFromOuter, planes);
    if (run.placed)
        transformNormalsEach(run.count, run.tables.instanceMatrices.data(), run.instance, planes);
}

void deliver(const ShapeRun &run, const float *from, float *to) {
    scatter(run.count, run.order, from, to);
}

} // namespace candela

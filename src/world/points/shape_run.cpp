// SPDX-License-Identifier: Apache-2.0
#include "world/points/shape_run.h"

#include "foundation/base/lanes.h"
#include "world/points/surface_points.h"

#include <algorithm>

namespace candela {

namespace {

void nameRound(const ShapeRun &run, ShadingPoints &points, RunScratch &own) {
    std::copy_n(run.element, run.count, run.piece);
    float *planes = own.planes.get(3 * std::size_t(run.stride));
    const Vec3Planes P{planes, planes + run.stride, planes + 2 * run.stride};
    for (int c = 0; c < 3; ++c)
        lanes::gather(run.count, run.order, points.input(ShaderInput::P, c),
                      planes + c * run.stride);
    for (int k = 0; run.placed && k < run.count; ++k) {
        Matrix4 objectFromCurrent;
        std::copy_n(run.matrices + 32 * std::size_t(run.row[k]) + 16, 16,
                    objectFromCurrent.m.begin());
        P.set(k, transformPoint(objectFromCurrent, P.get(k)));
    }
    transformPoints(run.count, run.shape.shapeFromOuter, P);
    run.shape.surface->nameRound(run.count, P, run.share, run.piece, run.u, run.v);
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
    case Naming::Round: nameRound(run, points, own);
    }
}

/// Where the points' instances stand: of those that move, at the points' times.
void place(ShapeRun &run, const ShadingPoints &points, std::uint32_t *row, RunScratch &own) {
    const PointTables &tables = run.tables;
    run.matrices = tables.instanceMatrices.data(), run.row = row;
    bool moves = false;
    for (int k = 0; k < run.count; ++k) {
        row[k] = points.instance[run.order[k]];
        moves |= run.placed && tables.instances[row[k]].steps > 0;
    }
    if (!moves)
        return;
    float *matrices = own.matrices.get(32 * std::size_t(run.count));
    const float *time = points.inputTable[std::size_t(ShaderInput::time)];
    for (int k = 0; k < run.count; ++k) {
        tables.placeAt(row[k], time[run.order[k]], matrices + 32 * std::size_t(k));
        row[k] = std::uint32_t(k);
    }
    run.matrices = matrices;
}

const float *sharesOf(const ShapeRun &run, const ShadingPoints &points, RunScratch &own) {
    float *shares = own.shares.get(std::size_t(run.stride));
    const float *time = points.inputTable[std::size_t(ShaderInput::time)];
    for (int k = 0; k < run.count; ++k)
        shares[k] = run.tables.shutter.share(time[run.order[k]]);
    return shares;
}

} // namespace

ShapeRun makeRun(const PointTables &tables, ShadingPoints &points, const std::int32_t *order,
                 int count, const float *normalSign, RunScratch &own) {
    const int stride = paddedLanes(count);
    float *names = own.names.get(3 * std::size_t(stride));
    std::uint32_t *integers = own.integers.get(3 * std::size_t(stride));
    ShapeRun run{tables,
                 tables.shapes[points.shape[order[0]]],
                 order,
                 count,
                 stride,
                 points.instance[order[0]] != noHit,
                 nullptr,
                 nullptr,
                 names,
                 names + stride,
                 names + 2 * stride,
                 integers,
                 integers + stride,
                 nullptr};
    for (int k = 0; k < count; ++k) {
        const int i = order[k];
        run.sign[k] = normalSign ? normalSign[i] : 1;
        run.element[k] = points.element[i];
        run.u[k] = points.u[i], run.v[k] = points.v[i];
    }
    place(run, points, integers + 2 * stride, own);
    if (run.shape.surface->steps() > 1)
        run.share = sharesOf(run, points, own);
    name(run, points, own);
    return run;
}

void placeVectors(const ShapeRun &run, Vec3Planes planes) {
    transformVectors(run.count, run.shape.outerFromShape, planes);
    if (run.placed)
        transformVectorsEach(run.count, run.matrices, run.row, planes);
}

void placePoints(const ShapeRun &run, Vec3Planes planes) {
    transformPoints(run.count, run.shape.outerFromShape, planes);
    if (run.placed)
        transformPointsEach(run.count, run.matrices, run.row, planes);
}

void placeNormals(const ShapeRun &run, Vec3Planes planes) {
    transformNormals(run.count, run.shape.shapeFromOuter, planes);
    if (run.placed)
        transformNormalsEach(run.count, run.matrices, run.row, planes);
}

void deliver(const ShapeRun &run, const float *from, float *to) {
    scatter(run.count, run.order, from, to);
}

} // namespace candela

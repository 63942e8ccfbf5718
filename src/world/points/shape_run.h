// SPDX-License-Identifier: Apache-2.0
// The points of a batch that lie on one shape, as its surface names them.
#pragma once

#include "foundation/base/scratch.h"
#include "world/points/point_tables.h"
#include "world/points/shading_points.h"

namespace candela {

/// Planes are dense, and not those of the batch.
struct ShapeRun {
    const PointTables &tables;
    const Shape &shape;
    const std::int32_t *order; ///< Where the points stand in the batch.
    int count, stride;         ///< Stride: of planes that hold as many.
    bool placed;               ///< By instances:
    const float *matrices;     ///< 32 floats a row, a matrix and its inverse,
    const std::uint32_t *row;  ///< which of them places each point.
    float *u, *v, *sign;       ///< Sign: of normals against the natural ones.
    std::uint32_t *element, *piece;
    const float *share; ///< Of the shutter's interval, where the surface changes its shape.

    SurfaceQuery query() const { return {count, piece, u, v, share}; }
};

/// Storage of a thread's runs.
struct RunScratch {
    Scratch<std::uint32_t> integers;
    Scratch<float> names, planes, matrices, shares;
    Scratch<float *> variablePlanes;
};

/// The points order[0..count) of the batch, all of one shape, `normalSign` by place in the batch;
/// null: natural normals.
ShapeRun makeRun(const PointTables &, ShadingPoints &, const std::int32_t *order, int count,
                 const float *normalSign, RunScratch &);

// From the surface's own space to current space.
void placeVectors(const ShapeRun &, Vec3Planes);
void placePoints(const ShapeRun &, Vec3Planes);
void placeNormals(const ShapeRun &, Vec3Planes); ///< As covectors; of any length.

/// To the batch's order.
void deliver(const ShapeRun &, const float *from, float *to);

} // namespace candela

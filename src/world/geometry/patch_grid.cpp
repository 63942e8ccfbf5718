// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_grid.h"

#include <algorithm>

namespace candela {

/// Splits a mesh coordinate into patch and place. The comparison order sends NaN to 0.
static int locateOn(const PatchAxis &axis, float coordinate, float &mesh, float &within) {
    mesh = coordinate > 0 ? std::min(coordinate, 1.0f) : 0.0f;
    if (axis.breaks.empty()) {
        float scaled = mesh * float(axis.patches);
        int patch = std::min(int(scaled), axis.patches - 1);
        within = std::min(scaled - float(patch), 1.0f);
        return patch;
    }
    const float *first = axis.breaks.data() + 1, *last = first + axis.patches - 1;
    int patch = int(std::upper_bound(first, last, mesh) - first);
    float begin = axis.breaks[patch], end = axis.breaks[patch + 1];
    within = std::clamp((mesh - begin) / (end - begin), 0.0f, 1.0f);
    return patch;
}

void locate(const PatchGrid &grid, const float *meshU, const float *meshV, int count,
            PatchPoints &points) {
    points.count = count;
    points.meshSpeedU = 1 / (grid.u.high - grid.u.low);
    points.meshSpeedV = 1 / (grid.v.high - grid.v.low);
    for (int k = 0; k < count; ++k) {
        int column = locateOn(grid.u, meshU[k], points.meshU[k], points.u[k]);
        int row = locateOn(grid.v, meshV[k], points.meshV[k], points.v[k]);
        points.patch[k] = row * grid.u.patches + column;
        points.speedU[k] = grid.u.speed(column);
        points.speedV[k] = grid.v.speed(row);
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Where light paths have met surfaces: what camera paths are connected to and merged with. A row
// each, compact; shading points are made from it again.
#pragma once

#include "foundation/base/vec3.h"
#include "foundation/units/color.h"
#include "light/bidir/merge_cells.h"
#include "light/path/techniques.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

struct LightVertex {
    /// What the ray met, as HitBatch has it.
    std::uint32_t shape, element, instance;
    float u, v;
    Vec3 elementNormal;
    Vec3 P;
    Vec3 Ng;                              ///< Unit vector.
    Vec3 toPrevious;                      ///< Unit vector, against the light.
    float distance;                       ///< To there, metres.
    float time, width;                    ///< Of the ray, where it met the surface.
    std::array<float, colorSamples> flux; ///< That arrives with the path, W.
    PathVertex ofPath;
    std::int32_t light; ///< What shines on it: index + 1, 0 = what other surfaces scatter.
    std::int32_t depth; ///< Scatterings before.
    std::int32_t code;  ///< Of its shader.
};

/// Those of a pass, in the order of their paths, or of the cells if there are any.
struct LightVertices {
    std::vector<LightVertex> rows;
    std::int64_t paths = 0; ///< That they come from, those that met nothing among them.
    MergeCells cells;       ///< The rows, where they lie; empty unless they are merged with.
};

} // namespace candela

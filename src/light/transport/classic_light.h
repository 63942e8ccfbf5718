// SPDX-License-Identifier: Apache-2.0
// The RI 3.1 way to light a surface: every light at once, and the whole shader run on them.
#pragma once

#include "light/transport/direct_light.h"
#include "light/transport/surface_vertices.h"

#include <vector>

namespace candela {

class ClassicLight {
public:
    explicit ClassicLight(int capacity);

    /// Ci and Oi of the vertices with `rounds` samples of every light, at uniform positions
    /// derived from (u,v), and the ambient light given. Returns the number of shadow rays.
    int shade(SurfaceVertices &, int rounds, const float *u, const float *v,
              const float *const *ambient, float *const *Ci, float *const *Oi);

private:
    int sampleRow(SurfaceVertices &, int row, int light, int rounds, const float *u,
                  const float *v);
    int shadowRow(SurfaceVertices &, int row);

    LightSampleStorage light_;
    ShadowRays shadow_;
    Planes<float> rows_; ///< L and Cl, each a plane of (row, lane).
    Planes<std::int32_t> rowLights_;
    Planes<float> position_;
    std::vector<int> lane_;
    int rowCapacity_ = 0, lanes_;
};

} // namespace candela

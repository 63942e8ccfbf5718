// SPDX-License-Identifier: Apache-2.0
// Uniform sampling of a parametric surface by area, nearly: a density over (u,v) that is constant
// in each cell of a grid. Exact densities are per unit (u,v), the coordinates of Surface queries;
// the Jacobian by those makes them exact per area too, so no sample is biased by how the surface is
// diced.
#pragma once

#include "foundation/base/matrix4.h"
#include "world/geometry/surface.h"

#include <vector>

namespace candela {

/// Area in the transformed space per unit of the query's own coordinates; `scratch` holds three
/// floats a point.
void transformedAreas(const Surface &, const Matrix4 &currentFromObject, const SurfaceQuery &,
                      float *scratch, float *area);

class UvDensity {
public:
    static constexpr int cells = 32; ///< Along u and along v.

    /// Of a surface with parameters in [0,1]^2, transformed; see Surface::evaluate.
    UvDensity(const Surface &, const Matrix4 &currentFromObject);

    double area() const { return area_; }
    /// Takes the square to (u,v), monotonic in both.
    void sample(float x, float y, float &u, float &v) const;
    /// Per unit (u,v); its integral is 1 times all scales.
    float at(float u, float v) const;
    void scale(float factor);

private:
    double area_ = 0;
    std::vector<double> rows_, columns_; ///< Running sums: over v, and for each row over u.
    std::vector<float> density_;
};

} // namespace candela

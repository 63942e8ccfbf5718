// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_polynomials.h"

#include <algorithm>

namespace candela {

/// Splits a mesh coordinate into patch and place. The comparison order sends NaN to 0.
static int locateAxis(float coordinate, int patches, float &mesh, float &within) {
    mesh = coordinate > 0 ? std::min(coordinate, 1.0f) : 0.0f;
    float scaled = mesh * float(patches);
    int patch = std::min(int(scaled), patches - 1);
    within = std::min(scaled - float(patch), 1.0f);
    return patch;
}

void locate(const PatchGrid &grid, const float *meshU, const float *meshV, int count,
            PatchPoints &points) {
    points.count = count;
    for (int k = 0; k < count; ++k) {
        int column = locateAxis(meshU[k], grid.patchesU, points.meshU[k], points.u[k]);
        int row = locateAxis(meshV[k], grid.patchesV, points.meshV[k], points.v[k]);
        points.patch[k] = row * grid.patchesU + column;
    }
}

template <int degree>
static void evaluateAll(const PatchPolynomials &polynomials, const PatchGrid &grid,
                        const PatchPoints &points, int component, float *value, float *du,
                        float *dv) {
    const float *u = polynomials.wholeMesh ? points.meshU.data() : points.u.data();
    const float *v = polynomials.wholeMesh ? points.meshV.data() : points.v.data();
    float scaleU = polynomials.wholeMesh ? 1 : float(grid.patchesU);
    float scaleV = polynomials.wholeMesh ? 1 : float(grid.patchesV);
    for (int k = 0; k < points.count; ++k) {
        float pu, pv;
        float p =
            polynomial<degree>(polynomials.of(points.patch[k], component), u[k], v[k], pu, pv);
        if (value)
            value[k] = p;
        if (du)
            du[k] = pu * scaleU;
        if (dv)
            dv[k] = pv * scaleV;
    }
}

void PatchPolynomials::evaluate(const PatchGrid &grid, const PatchPoints &points, int component,
                                float *value, float *du, float *dv) const {
    switch (degree) {
    case 0: return evaluateAll<0>(*this, grid, points, component, value, du, dv);
    case 1: return evaluateAll<1>(*this, grid, points, component, value, du, dv);
    default: return evaluateAll<3>(*this, grid, points, component, value, du, dv);
    }
}

void appendBilinear(std::vector<float> &coefficients, float c00, float c10, float c01, float c11) {
    // c[0][0], c[0][1] (v), c[1][0] (u), c[1][1] (uv).
    coefficients.insert(coefficients.end(), {c00, c01 - c00, c10 - c00, c00 - c10 - c01 + c11});
}

} // namespace candela

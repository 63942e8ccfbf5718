// SPDX-License-Identifier: Apache-2.0
// Bivariate polynomials over a mesh of patches: positions and primitive variables of parametric
// surfaces are all of this one form, whatever basis or class they came in.
#pragma once

#include "world/geometry/surface.h"

#include <array>
#include <vector>

namespace candela {

/// How many patches a mesh has and which way it closes; a quadric is a mesh of one patch.
struct PatchGrid {
    int patchesU = 1, patchesV = 1;
    bool periodicU = false, periodicV = false;

    int patches() const { return patchesU * patchesV; }
    int cornersU() const { return periodicU ? patchesU : patchesU + 1; }
    int cornersV() const { return periodicV ? patchesV : patchesV + 1; }
    int corners() const { return cornersU() * cornersV(); }
};

/// Some points of a mesh, each by its patch and its place within it.
struct PatchPoints {
    static constexpr int capacity = 128;
    int count = 0;
    std::array<int, capacity> patch;
    std::array<float, capacity> u, v;         ///< Within the patch, in [0,1].
    std::array<float, capacity> meshU, meshV; ///< Over the mesh, in [0,1].
};

/// Locates up to PatchPoints::capacity mesh coordinates; what lies outside [0,1] is clamped.
void locate(const PatchGrid &, const float *meshU, const float *meshV, int count, PatchPoints &);

/// For each patch and component the coefficients c[i][j] of u^i v^j, i and j to `degree`.
struct PatchPolynomials {
    int degree = 0; ///< 0, 1 or 3, in u and in v.
    int components = 1;
    bool wholeMesh = false; ///< One polynomial in (meshU, meshV) for all patches.
    std::vector<float> coefficients;

    int coefficientCount() const { return (degree + 1) * (degree + 1); }
    const float *of(int patch, int component) const {
        int place = wholeMesh ? component : patch * components + component;
        return coefficients.data() + std::size_t(place) * coefficientCount();
    }
    /// Values of one component and, where the pointers are not null, derivatives by meshU, meshV.
    void evaluate(const PatchGrid &, const PatchPoints &, int component, float *value, float *du,
                  float *dv) const;
};

/// The value at (u,v) of coefficients as above, and its derivatives by u and v.
template <int degree>
inline float polynomial(const float *c, float u, float v, float &du, float &dv) {
    float value = 0;
    du = dv = 0;
    for (int i = degree; i >= 0; --i) {
        float row = 0, rowDv = 0;
        for (int j = degree; j >= 0; --j) {
            rowDv = rowDv * v + row;
            row = row * v + c[i * (degree + 1) + j];
        }
        du = du * u + value;
        value = value * u + row;
        dv = dv * u + rowDv;
    }
    return value;
}

/// The second derivatives at (u,v): by u twice, by u and v, by v twice.
template <int degree>
inline std::array<float, 3> secondDerivatives(const float *c, float u, float v) {
    if constexpr (degree == 1)
        return {0, c[3], 0};
    float duu = 0, duv = 0, dvv = 0;
    for (int i = degree; i >= 0; --i) {
        float row = 0, rowDv = 0, rowDvv = 0; // The last of half the size.
        for (int j = degree; j >= 0; --j) {
            rowDvv = rowDvv * v + rowDv;
            rowDv = rowDv * v + row;
            row = row * v + c[i * (degree + 1) + j];
        }
        dvv = dvv * u + 2 * rowDvv;
        if (i >= 1)
            duv = duv * u + float(i) * rowDv;
        if (i >= 2)
            duu = duu * u + float(i * (i - 1)) * row;
    }
    return {duu, duv, dvv};
}

/// Appends the bilinear function that has these values at (0,0), (1,0), (0,1), (1,1).
void appendBilinear(std::vector<float> &coefficients, float c00, float c10, float c01, float c11);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Bivariate polynomials over a mesh of patches: positions and primitive variables of parametric
// surfaces are all of this one form, whatever basis or class they came in.
#pragma once

#include "interface/ri/primitive_record.h"
#include "world/geometry/patch_grid.h"

#include <array>
#include <vector>

namespace candela {

/// For each patch and component the coefficients c[i][j] of u^i v^j, i and j to `degree`; or, of
/// any degrees, c[i][j] are Bernstein coefficients, which high degrees keep their digits in.
struct PatchPolynomials {
    int degree = 0; ///< 0, 1 or 3, in u and in v.
    int components = 1;
    bool wholeMesh = false; ///< One polynomial in (meshU, meshV) for all patches.
    std::vector<float> coefficients{};
    /// Degrees in u and in v if the coefficients are Bernstein's; {0, 0} otherwise.
    std::array<int, 2> bernstein{0, 0};

    bool isBernstein() const { return bernstein[0] > 0; }
    int coefficientCount() const {
        return isBernstein() ? (bernstein[0] + 1) * (bernstein[1] + 1)
                             : (degree + 1) * (degree + 1);
    }
    const float *of(int patch, int component) const {
        int place = wholeMesh ? component : patch * components + component;
        return coefficients.data() + std::size_t(place) * coefficientCount();
    }
    /// Values of one component and, where the pointers are not null, derivatives by what shaders
    /// call u and v.
    void evaluate(const PatchPoints &, int component, float *value, float *du, float *dv) const;
};

/// Coefficients of powers up to `degree`, at a place of a patch.
template <int degree> class PowersAt {
public:
    PowersAt(const PatchPolynomials &, float u, float v) : u_(u), v_(v) {}

    /// The value and its derivatives by u and v.
    float value(const float *c, float &du, float &dv) const {
        float value = 0;
        du = dv = 0;
        for (int i = degree; i >= 0; --i) {
            float row = 0, rowDv = 0;
            for (int j = degree; j >= 0; --j) {
                rowDv = rowDv * v_ + row;
                row = row * v_ + c[i * (degree + 1) + j];
            }
            du = du * u_ + value;
            value = value * u_ + row;
            dv = dv * u_ + rowDv;
        }
        return value;
    }

    /// The second derivatives: by u twice, by u and v, by v twice.
    std::array<float, 3> second(const float *c) const {
        if constexpr (degree == 1)
            return {0, c[3], 0};
        float duu = 0, duv = 0, dvv = 0;
        for (int i = degree; i >= 0; --i) {
            float row = 0, rowDv = 0, rowDvv = 0; // The last of half the size.
            for (int j = degree; j >= 0; --j) {
                rowDvv = rowDvv * v_ + rowDv;
                rowDv = rowDv * v_ + row;
                row = row * v_ + c[i * (degree + 1) + j];
            }
            dvv = dvv * u_ + 2 * rowDvv;
            if (i >= 1)
                duv = duv * u_ + float(i) * rowDv;
            if (i >= 2)
                duu = duu * u_ + float(i * (i - 1)) * row;
        }
        return {duu, duv, dvv};
    }

private:
    float u_, v_;
};

/// Bernstein coefficients of any degrees, at a place of a patch; as PowersAt.
class BernsteinAt {
public:
    BernsteinAt(const PatchPolynomials &, float u, float v);
    float value(const float *c, float &du, float &dv) const;
    std::array<float, 3> second(const float *c) const;

private:
    /// The basis functions of one coordinate, and their first and second derivatives.
    using Basis = std::array<std::array<double, mostSplineOrder>, 3>;
    static void fill(Basis &, int degree, double t);
    double sum(const float *c, int byU, int byV) const;

    int degreeU_, degreeV_;
    Basis u_, v_;
};

/// Calls with a null pointer to the class that evaluates these polynomials: of positions, which are
/// of degree 1 at least.
template <class Function> auto withPolynomial(const PatchPolynomials &polynomials, Function call) {
    if (polynomials.isBernstein())
        return call(static_cast<const BernsteinAt *>(nullptr));
    return polynomials.degree == 1 ? call(static_cast<const PowersAt<1> *>(nullptr))
                                   : call(static_cast<const PowersAt<3> *>(nullptr));
}

/// Appends the bilinear function that has these values at (0,0), (1,0), (0,1), (1,1).
void appendBilinear(std::vector<float> &coefficients, float c00, float c10, float c01, float c11);

} // namespace candela

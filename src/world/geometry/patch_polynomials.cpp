// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_polynomials.h"

namespace candela {

void BernsteinAt::fill(Basis &basis, int degree, double t) {
    // Of each degree from the last; derivatives are differences of those one and two below.
    std::array<std::array<double, mostSplineOrder>, 3> low{}; // Degree d, d - 1 and d - 2.
    low[0][0] = 1;
    for (int d = 1; d <= degree; ++d) {
        low[2] = low[1], low[1] = low[0];
        for (int i = 0; i <= d; ++i)
            low[0][i] = (i < d ? (1 - t) * low[1][i] : 0) + (i > 0 ? t * low[1][i - 1] : 0);
    }
    auto at = [&](int below, int i) { return i >= 0 && i <= degree - below ? low[below][i] : 0.0; };
    for (int i = 0; i <= degree; ++i) {
        basis[0][i] = low[0][i];
        basis[1][i] = degree * (at(1, i - 1) - at(1, i));
        basis[2][i] =
            degree < 2 ? 0 : degree * (degree - 1.0) * (at(2, i - 2) - 2 * at(2, i - 1) + at(2, i));
    }
}

BernsteinAt::BernsteinAt(const PatchPolynomials &polynomials, float u, float v)
    : degreeU_(polynomials.bernstein[0]), degreeV_(polynomials.bernstein[1]) {
    fill(u_, degreeU_, u);
    fill(v_, degreeV_, v);
}

double BernsteinAt::sum(const float *c, int byU, int byV) const {
    double sum = 0;
    for (int i = 0; i <= degreeU_; ++i) {
        double row = 0;
        for (int j = 0; j <= degreeV_; ++j)
            row += v_[byV][j] * c[i * (degreeV_ + 1) + j];
        sum += u_[byU][i] * row;
    }
    return sum;
}

float BernsteinAt::value(const float *c, float &du, float &dv) const {
    du = float(sum(c, 1, 0)), dv = float(sum(c, 0, 1));
    return float(sum(c, 0, 0));
}

std::array<float, 3> BernsteinAt::second(const float *c) const {
    return {float(sum(c, 2, 0)), float(sum(c, 1, 1)), float(sum(c, 0, 2))};
}

template <class At>
static void evaluateAll(const PatchPolynomials &polynomials, const PatchPoints &points,
                        int component, float *value, float *du, float *dv) {
    const bool whole = polynomials.wholeMesh;
    const float *u = whole ? points.meshU.data() : points.u.data();
    const float *v = whole ? points.meshV.data() : points.v.data();
    for (int k = 0; k < points.count; ++k) {
        float pu, pv;
        float p =
            At(polynomials, u[k], v[k]).value(polynomials.of(points.patch[k], component), pu, pv);
        if (value)
            value[k] = p;
        if (du)
            du[k] = pu * (whole ? points.meshSpeedU : points.speedU[k]);
        if (dv)
            dv[k] = pv * (whole ? points.meshSpeedV : points.speedV[k]);
    }
}

void PatchPolynomials::evaluate(const PatchPoints &points, int component, float *value, float *du,
                                float *dv) const {
    if (isBernstein())
        return evaluateAll<BernsteinAt>(*this, points, component, value, du, dv);
    switch (degree) {
    case 0: return evaluateAll<PowersAt<0>>(*this, points, component, value, du, dv);
    case 1: return evaluateAll<PowersAt<1>>(*this, points, component, value, du, dv);
    default: return evaluateAll<PowersAt<3>>(*this, points, component, value, du, dv);
    }
}

void appendBilinear(std::vector<float> &coefficients, float c00, float c10, float c01, float c11) {
    // c[0][0], c[0][1] (v), c[1][0] (u), c[1][1] (uv).
    coefficients.insert(coefficients.end(), {c00, c01 - c00, c10 - c00, c00 - c10 - c01 + c11});
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_surface.h"

#include <cmath>

namespace candela {

PatchSurface::PatchSurface(const PatchTopology &topology, PatchPolynomials positions,
                           std::vector<PatchBounds> bounds,
                           std::array<std::vector<SideCurve>, 4> sides, GridVariables variables)
    : topology_(topology), positions_(std::move(positions)), patchBounds_(std::move(bounds)),
      variables_(std::move(variables)) {
    const PatchGrid &grid = topology_.grid;
    leastNormal_.reserve(patchBounds_.size());
    for (const PatchBounds &patch : patchBounds_) {
        const DerivativeBounds &d = patch.derivatives;
        bound_.add(patch.box);
        leastNormal_.push_back(float(1e-5 * d.du * d.dv * grid.patches()));
        // Of the polynomials, and of the float that says where on the mesh.
        double rounding =
            4e-7 * patch.coefficientSum + 2e-7 * (d.du * grid.patchesU + d.dv * grid.patchesV);
        roundingError_ = std::max(roundingError_, rounding);
    }
    outline_ = {patchBounds_, std::move(sides), patchesMeet(grid, positions_, roundingError_),
                float(4 * roundingError_)};
    Vec3 margin{float(roundingError_), float(roundingError_), float(roundingError_)};
    bound_ = {bound_.low - margin, bound_.high + margin};
}

template <int degree, bool rational>
inline PatchSurface::Local PatchSurface::local(int patch, float u, float v) const {
    Local at;
    for (int c = 0; c < 3; ++c)
        at.P[c] = polynomial<degree>(positions_.of(patch, c), u, v, at.du[c], at.dv[c]);
    if constexpr (rational) {
        float wu, wv, w = polynomial<degree>(positions_.of(patch, 3), u, v, wu, wv);
        at.P = at.P / w;
        at.du = (at.du - at.P * wu) / w;
        at.dv = (at.dv - at.P * wv) / w;
    }
    at.du *= float(topology_.grid.patchesU);
    at.dv *= float(topology_.grid.patchesV);
    return at;
}

/// The normal near a place that has none, with the derivatives there; as a last resort any frame.
template <int degree, bool rational>
Vec3 PatchSurface::beside(int patch, float &u, float &v, Local &at) const {
    for (float step : {2e-3f, 2e-2f, 0.2f}) {
        float nearU = u + (0.5f - u) * step, nearV = v + (0.5f - v) * step;
        Local near = local<degree, rational>(patch, nearU, nearV);
        Vec3 normal = cross(near.du, near.dv);
        if (length(normal) > leastNormal_[patch]) {
            at.du = near.du;
            at.dv = near.dv;
            u = nearU, v = nearV;
            return normal;
        }
    }
    Vec3 along = length(at.du) >= length(at.dv) ? at.du : at.dv;
    Vec3 n{0, 0, 1};
    if (length(along) > 0) {
        Vec3 other;
        orthonormalBasis(normalize(along), n, other);
    }
    orthonormalBasis(n, at.du, at.dv);
    return n;
}

template <int degree, bool rational>
std::array<Vec3, 2> PatchSurface::normalDerivatives(int patch, float u, float v,
                                                    const Local &at) const {
    float scaleU = float(topology_.grid.patchesU), scaleV = float(topology_.grid.patchesV);
    Vec3 duu, duv, dvv;
    for (int c = 0; c < 3; ++c) {
        auto second = secondDerivatives<degree>(positions_.of(patch, c), u, v);
        duu[c] = second[0], duv[c] = second[1], dvv[c] = second[2];
    }
    if constexpr (rational) {
        // w P = H, differentiated twice; P and its derivatives by the patch's own (u,v).
        float wu, wv, w = polynomial<degree>(positions_.of(patch, 3), u, v, wu, wv);
        auto second = secondDerivatives<degree>(positions_.of(patch, 3), u, v);
        Local here = local<degree, rational>(patch, u, v);
        Vec3 du = here.du / scaleU, dv = here.dv / scaleV;
        duu = (duu - du * (2 * wu) - here.P * second[0]) / w;
        duv = (duv - dv * wu - du * wv - here.P * second[1]) / w;
        dvv = (dvv - dv * (2 * wv) - here.P * second[2]) / w;
    }
    duu *= scaleU * scaleU, duv *= scaleU * scaleV, dvv *= scaleV * scaleV;
    Vec3 normal = cross(at.du, at.dv);
    return {unitDerivative(normal, cross(duu, at.dv) + cross(at.du, duv)),
            unitDerivative(normal, cross(duv, at.dv) + cross(at.du, dvv))};
}

template <int degree, bool rational>
void PatchSurface::evaluateAs(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    PatchPoints points;
    for (int start = 0; start < query.count; start += PatchPoints::capacity) {
        locate(topology_.grid, query.u + start, query.v + start,
               std::min(query.count - start, points.capacity), points);
        for (int i = 0; i < points.count; ++i) {
            int k = start + i, patch = points.patch[i];
            Local at = local<degree, rational>(patch, points.u[i], points.v[i]);
            Vec3 normal = cross(at.du, at.dv);
            float u = points.u[i], v = points.v[i];
            if (answer.areaScale)
                answer.areaScale[k] = length(normal);
            if (!(length(normal) > leastNormal_[patch])) [[unlikely]]
                normal = beside<degree, rational>(patch, u, v, at);
            if (answer.dNdu.x || answer.dNdv.x || answer.dNgdu.x || answer.dNgdv.x) {
                auto derivatives = normalDerivatives<degree, rational>(patch, u, v, at);
                for (const Vec3Planes &byU : {answer.dNdu, answer.dNgdu})
                    if (byU.x)
                        byU.set(k, derivatives[0]);
                for (const Vec3Planes &byV : {answer.dNdv, answer.dNgdv})
                    if (byV.x)
                        byV.set(k, derivatives[1]);
            }
            if (answer.P.x)
                answer.P.set(k, at.P);
            if (answer.dPdu.x)
                answer.dPdu.set(k, at.du);
            if (answer.dPdv.x)
                answer.dPdv.set(k, at.dv);
            if (answer.Ng.x)
                answer.Ng.set(k, normal);
            if (answer.N.x)
                answer.N.set(k, normal);
            if (answer.u)
                answer.u[k] = points.meshU[i];
            if (answer.v)
                answer.v[k] = points.meshV[i];
        }
    }
    if (answer.N.x || answer.dNdu.x || answer.dNdv.x)
        variables_.overrideNormals(query.count, query.u, query.v, answer.N, answer.dNdu,
                                   answer.dNdv);
}

void PatchSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    bool rational = positions_.components == 4;
    if (positions_.degree == 3)
        rational ? evaluateAs<3, true>(query, answer) : evaluateAs<3, false>(query, answer);
    else
        rational ? evaluateAs<1, true>(query, answer) : evaluateAs<1, false>(query, answer);
}

void PatchSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                    float *const *valueDu, float *const *valueDv) const {
    variables_.evaluate(index, 0, query.count, query.u, query.v, value, valueDu, valueDv);
}

Vec3 PatchSurface::normalAt(int patch, float u, float v) const {
    bool rational = positions_.components == 4;
    Local at = positions_.degree == 3
                   ? rational ? local<3, true>(patch, u, v) : local<3, false>(patch, u, v)
               : rational ? local<1, true>(patch, u, v)
                          : local<1, false>(patch, u, v);
    return cross(at.du, at.dv);
}

bool PatchSurface::hasArea() const {
    for (int patch = 0; patch < topology_.grid.patches(); ++patch)
        for (float u : {0.11f, 0.52f, 0.87f})
            for (float v : {0.13f, 0.48f, 0.91f})
                if (length(normalAt(patch, u, v)) > leastNormal_[patch])
                    return true;
    return false;
}

float PatchSurface::area() const {
    static constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
    static constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
    double sum = 0;
    for (int patch = 0; patch < topology_.grid.patches(); ++patch)
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j) {
                double u = (1 + (i % 2 ? 1 : -1) * node[i / 2]) / 2;
                double v = (1 + (j % 2 ? 1 : -1) * node[j / 2]) / 2;
                sum +=
                    weight[i / 2] * weight[j / 2] / 4 * length(normalAt(patch, float(u), float(v)));
            }
    return float(sum / topology_.grid.patches());
}

PatchCuts PatchSurface::cutsAt(const DiceRate &rate) const {
    return choosePatchCuts(topology_.grid, patchBounds_, rate);
}

double PatchSurface::triangleCount(const DiceRate &rate) const {
    return candela::triangleCount(topology_.grid, cutsAt(rate), patchBounds_);
}

DicedMesh PatchSurface::dice(const DiceRate &rate) const {
    PatchCuts cuts = cutsAt(rate);
    DicedMesh mesh = dicePatches(topology_.grid, cuts, *this, outline_);
    mesh.chordError = float(cuts.error) + outline_.tolerance;
    return mesh;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_positions.h"

#include <cmath>

namespace candela {

PatchPositions::PatchPositions(PatchPolynomials polynomials, std::span<const PatchBounds> bounds)
    : polynomials_(std::move(polynomials)) {
    leastNormal_.reserve(bounds.size());
    for (const PatchBounds &patch : bounds)
        leastNormal_.push_back(float(1e-5 * patch.derivatives.du * patch.derivatives.dv));
}

template <class Polynomial, bool rational>
inline PatchPositions::Local PatchPositions::local(const PatchPlace &place) const {
    const Polynomial polynomial(polynomials_, place.u, place.v);
    Local at;
    for (int c = 0; c < 3; ++c)
        at.P[c] = polynomial.value(polynomials_.of(place.patch, c), at.du[c], at.dv[c]);
    if constexpr (rational) {
        float wu, wv, w = polynomial.value(polynomials_.of(place.patch, 3), wu, wv);
        at.P = at.P / w;
        at.du = (at.du - at.P * wu) / w;
        at.dv = (at.dv - at.P * wv) / w;
    }
    at.du *= place.speedU;
    at.dv *= place.speedV;
    return at;
}

/// The normal near a place that has none, with the derivatives there; as a last resort any frame.
template <class Polynomial, bool rational>
Vec3 PatchPositions::beside(PatchPlace &place, Local &at) const {
    for (float step : {2e-3f, 2e-2f, 0.2f}) {
        PatchPlace nearby = place;
        nearby.u += (0.5f - place.u) * step, nearby.v += (0.5f - place.v) * step;
        Local near = local<Polynomial, rational>(nearby);
        Vec3 normal = cross(near.du, near.dv);
        if (length(normal) > leastNormal(place)) {
            at.du = near.du;
            at.dv = near.dv;
            place = nearby;
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

template <class Polynomial, bool rational>
std::array<Vec3, 2> PatchPositions::normalDerivatives(const PatchPlace &place,
                                                      const Local &at) const {
    const Polynomial polynomial(polynomials_, place.u, place.v);
    Vec3 duu, duv, dvv;
    for (int c = 0; c < 3; ++c) {
        auto second = polynomial.second(polynomials_.of(place.patch, c));
        duu[c] = second[0], duv[c] = second[1], dvv[c] = second[2];
    }
    if constexpr (rational) {
        // w P = H, differentiated twice; P and its derivatives by the patch's own (u,v).
        const float *weight = polynomials_.of(place.patch, 3);
        float wu, wv, w = polynomial.value(weight, wu, wv);
        auto second = polynomial.second(weight);
        Local here = local<Polynomial, rational>(place);
        Vec3 du = here.du / place.speedU, dv = here.dv / place.speedV;
        duu = (duu - du * (2 * wu) - here.P * second[0]) / w;
        duv = (duv - dv * wu - du * wv - here.P * second[1]) / w;
        dvv = (dvv - dv * (2 * wv) - here.P * second[2]) / w;
    }
    duu *= place.speedU * place.speedU, dvv *= place.speedV * place.speedV;
    duv *= place.speedU * place.speedV;
    Vec3 normal = cross(at.du, at.dv);
    return {unitDerivative(normal, cross(duu, at.dv) + cross(at.du, duv)),
            unitDerivative(normal, cross(duv, at.dv) + cross(at.du, dvv))};
}

template <class Polynomial, bool rational>
void PatchPositions::evaluateAs(const PatchPoints &points, int first,
                                const SurfaceAnswer &answer) const {
    for (int i = 0; i < points.count; ++i) {
        const int k = first + i;
        PatchPlace place{points.patch[i], points.u[i], points.v[i], points.speedU[i],
                         points.speedV[i]};
        Local at = local<Polynomial, rational>(place);
        Vec3 normal = cross(at.du, at.dv);
        if (answer.areaScale)
            answer.areaScale[k] = length(normal);
        if (!(length(normal) > leastNormal(place))) [[unlikely]]
            normal = beside<Polynomial, rational>(place, at);
        if (answer.dNdu.x || answer.dNdv.x || answer.dNgdu.x || answer.dNgdv.x) {
            auto derivatives = normalDerivatives<Polynomial, rational>(place, at);
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
    }
}

void PatchPositions::evaluate(const PatchPoints &points, int first,
                              const SurfaceAnswer &answer) const {
    const auto as = [&]<class Polynomial>(const Polynomial *) {
        polynomials_.components == 4 ? evaluateAs<Polynomial, true>(points, first, answer)
                                     : evaluateAs<Polynomial, false>(points, first, answer);
    };
    withPolynomial(polynomials_, as);
}

PatchPositions::Local PatchPositions::localAt(const PatchPlace &place) const {
    const auto as = [&]<class Polynomial>(const Polynomial *) {
        return polynomials_.components == 4 ? local<Polynomial, true>(place)
                                            : local<Polynomial, false>(place);
    };
    return withPolynomial(polynomials_, as);
}

Vec3 PatchPositions::normalAt(const PatchPlace &place) const {
    const Local at = localAt(place);
    return cross(at.du, at.dv);
}

Vec3 PatchPositions::pointAt(const PatchPlace &place) const { return localAt(place).P; }

bool PatchPositions::hasArea(int patch) const {
    for (float u : {0.11f, 0.52f, 0.87f})
        for (float v : {0.13f, 0.48f, 0.91f})
            if (length(normalAt({patch, u, v})) > leastNormal_[patch])
                return true;
    return false;
}

double PatchPositions::area(int patch) const {
    static constexpr double node[4] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                       0.9602898564975363};
    static constexpr double weight[4] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                         0.1012285362903763};
    double sum = 0;
    for (int i = 0; i < 8; ++i)
        for (int j = 0; j < 8; ++j) {
            double u = (1 + (i % 2 ? 1 : -1) * node[i / 2]) / 2;
            double v = (1 + (j % 2 ? 1 : -1) * node[j / 2]) / 2;
            sum +=
                weight[i / 2] * weight[j / 2] / 4 * length(normalAt({patch, float(u), float(v)}));
        }
    return sum;
}

} // namespace candela

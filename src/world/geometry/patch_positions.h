// SPDX-License-Identifier: Apache-2.0
// Points, derivatives and normals of patches, polynomial and rational.
#pragma once

#include "world/geometry/bezier_net.h"
#include "world/geometry/surface.h"

namespace candela {

/// A place on a patch, with the speed of its (u,v) by what shaders call them.
struct PatchPlace {
    int patch = 0;
    float u = 0, v = 0, speedU = 1, speedV = 1;
};

/// Where a side of a patch has collapsed to a point, dPdu, dPdv and Ng are those of a place just
/// beside it.
class PatchPositions {
public:
    PatchPositions() = default;
    /// Polynomials have 3 components, or 4 homogeneous ones; `bounds` are those of each patch.
    PatchPositions(PatchPolynomials, std::span<const PatchBounds> bounds);

    const PatchPolynomials &polynomials() const { return polynomials_; }
    /// What is asked of places, but for u, v and areaScale; answers begin at place `first`.
    void evaluate(const PatchPoints &, int first, const SurfaceAnswer &) const;
    /// dPdu x dPdv, 0 where there is none.
    Vec3 normalAt(const PatchPlace &) const;
    Vec3 pointAt(const PatchPlace &) const;
    /// False if every normal of the patch vanishes.
    bool hasArea(int patch) const;
    /// By Gauss quadrature of |dPdu x dPdv| with 8 x 8 points, by the patch's own coordinates.
    double area(int patch) const;

private:
    struct Local {
        Vec3 P, du, dv; ///< Derivatives by (u,v) as shaders see them.
    };
    template <class Polynomial, bool rational> Local local(const PatchPlace &) const;
    Local localAt(const PatchPlace &) const;
    template <class Polynomial, bool rational>
    void evaluateAs(const PatchPoints &, int first, const SurfaceAnswer &) const;
    /// Moves the place to just beside it, where it has no normal.
    template <class Polynomial, bool rational> Vec3 beside(PatchPlace &, Local &) const;
    /// Derivatives of the unit normal by the shaders' (u,v).
    template <class Polynomial, bool rational>
    std::array<Vec3, 2> normalDerivatives(const PatchPlace &, const Local &) const;
    /// |dPdu x dPdv| below this is degenerate.
    float leastNormal(const PatchPlace &place) const {
        return leastNormal_[place.patch] * (place.speedU * place.speedV);
    }

    PatchPolynomials polynomials_;
    std::vector<float> leastNormal_; ///< Of each patch, by its own coordinates.
};

} // namespace candela

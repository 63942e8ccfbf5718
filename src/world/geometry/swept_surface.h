// SPDX-License-Identifier: Apache-2.0
// The quadrics of RI 3.2, 5.4: a profile swept about the z axis.
#pragma once

#include "world/geometry/grid_variables.h"
#include "world/geometry/swept_dicing.h"

namespace candela {

/// Query coordinates are (u, t): RI's u and the profile's dicing parameter. dPdu x dPdv points
/// away from the axis for positive radii and sweeps (RI 3.2, 5.4); of a disk along +z.
template <class Profile> class SweptSurface final : public Surface {
public:
    /// `thetaSweep` in radians.
    SweptSurface(Profile, double thetaSweep, GridVariables);

    Box3 bound() const override;
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    /// Whole spheres are.
    bool isRound() const override;
    RoundElements roundElements() const override;
    void nameRound(int count, const Vec3Planes &P, const float *share, std::uint32_t *piece,
                   float *u, float *v) const override;
    bool hasOwnNormals() const override { return variables_.hasNormals(); }
    std::span<const VariableInfo> variables() const override { return variables_.infos(); }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    float poleRadius() const { return float(limits_.derivatives.du) * leastArmFraction; }
    bool isPole(double t) const;
    SweptCounts countsAt(const DiceRate &) const;
    void evaluateOne(int k, float u, float t, const SurfaceAnswer &) const;

    Profile profile_;
    ProfileLimits limits_;
    double thetaSweep_;
    GridVariables variables_;
};

extern template class SweptSurface<StraightProfile>;
extern template class SweptSurface<CircularProfile>;
extern template class SweptSurface<ParabolicProfile>;

} // namespace candela

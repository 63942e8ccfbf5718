// SPDX-License-Identifier: Apache-2.0
// RiPoints (RI 3.2, 5.5) as balls, which look like disks that face the eye from everywhere.
#pragma once

#include "world/geometry/moment.h"
#include "world/geometry/primitive_variables.h"
#include "world/geometry/surface.h"

namespace candela {

/// A query's piece is a point. u is once around its z axis, v from one pole to the other, as on
/// RI's spheres; dPdu x dPdv points outwards.
class PointsSurface final : public Surface {
public:
    /// `knots`: x, y, z and radius of each.
    PointsSurface(std::vector<std::array<float, 4>> knots, std::vector<NumericVariable> variables,
                  std::optional<NumericVariable> normal,
                  const std::array<float, 8> &textureCoordinates);
    /// Points that move, which are these at even steps over the shutter's interval: as many, with
    /// variables alike.
    explicit PointsSurface(const std::vector<std::shared_ptr<const Surface>> &steps);

    Box3 bound() const override { return bound_; }
    SurfaceDomain domain() const override { return {count(), false}; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    float area() const override;
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool isRound() const override { return true; }
    bool isStroke() const override { return true; }
    RoundElements roundElements() const override { return elements_; }
    void nameRound(int count, const Vec3Planes &P, const float *share, std::uint32_t *piece,
                   float *u, float *v) const override;
    int steps() const override { return 1 + int(elements_.later.size()); }
    std::shared_ptr<const Surface> step(int number) const override;
    bool hasOwnNormals() const override { return normal_.has_value(); }
    std::span<const VariableInfo> variables() const override { return infos_; }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    using Knot = std::array<float, 4>;

    /// What these are at a step, and remain.
    PointsSurface(const PointsSurface &, int step);

    std::uint32_t count() const { return std::uint32_t(elements_.knots.size()); }
    const std::vector<Knot> &knotsOf(int step) const {
        return step == 0 ? elements_.knots : elements_.later[std::size_t(step) - 1];
    }
    Knot knotAt(std::uint32_t point, Moment) const;
    float valueAt(const NumericVariable &, std::uint32_t point, int component, Moment) const;
    void measure();

    struct Cells {
        int around, along;
        double scale; ///< Of corners: the body has the ball's surface.
        double error;
    };
    Cells cellsAt(const DiceRate &) const;

    RoundElements elements_;
    float largestRadius_ = 0;
    std::vector<NumericVariable>
        variables_; ///< With the values of all steps, as a moment has them.
    std::vector<VariableInfo> infos_;
    std::optional<NumericVariable> normal_;
    std::array<float, 8> textureCoordinates_;
    int defaultS_ = -1, defaultT_ = -1; ///< Places of the default s and t in infos_.
    Box3 bound_;
};

} // namespace candela

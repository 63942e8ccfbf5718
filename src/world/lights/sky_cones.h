// SPDX-License-Identifier: Apache-2.0
// The directions in which a light without a place shines, as its shader's solar() draws them: cones
// of one statement, chosen by importance and filled evenly. What draws a direction is told from the
// direction, and so is its density: so rays that escape find what light samples find.
#pragma once

#include "world/lights/emission_lobes.h"

#include <array>
#include <span>
#include <vector>

namespace candela {

/// Directions lead from the light to what it lights.
class SkyCones {
public:
    SkyCones() = default;
    /// Cones in the statement's order; the exponents have no say.
    explicit SkyCones(std::span<const EmissionCone>);

    /// Rays may meet something: some cone is wider than a direction.
    bool isWide() const { return isWide_; }
    /// Density per steradian of a unit direction, of those that are drawn from cones with a width.
    double pdf(Vec3 direction) const;
    /// Likewise of the unit direction that the uniform number `x` (the first of
    /// ShaderInput::lightSample) has drawn; 0 if that is the one direction of a cone without width.
    double pdfOfDrawn(float x, Vec3 direction) const;
    /// Uniform numbers for which the shader draws a direction that rays may meet.
    std::array<float, 2> numbersFor(Vec3 direction) const;

private:
    struct Cone {
        Vec3 axis;
        float importance = 0, before = 0; ///< Importance; that of the cones before it.
        double height = 0;                ///< 1 - cosine at the rim; 0 = one direction.
        double density = 0;               ///< Per steradian.

        /// 1 - cosine of a direction with the axis, to the last bit where it is small.
        double heightOf(Vec3 direction) const;
        bool holds(Vec3 direction) const { return heightOf(direction) <= height; }
    };
    const Cone &drawnBy(float x) const;

    std::vector<Cone> cones_;
    float total_ = 0;
    bool isWide_ = false;
};

} // namespace candela

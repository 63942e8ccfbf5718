// SPDX-License-Identifier: Apache-2.0
// The directions in which a light without extent sends light paths: the cones that its shader
// states (paper 5.4), and a share for all others, so that a wrong cone costs noise and never light.
#pragma once

#include "foundation/base/vec3.h"
#include "world/lights/cone_lobe.h"

#include <span>
#include <vector>

namespace candela {

struct EmissionCone {
    Vec3 axis;          ///< Unit vector.
    float angle = 360;  ///< Full angle, degrees.
    float exponent = 0; ///< Of the cosine with the axis.
    float importance = 1;
};

class EmissionLobes {
public:
    /// Without cones of importance: uniform over all directions.
    explicit EmissionLobes(std::span<const EmissionCone> = {});

    /// Density per steradian of a unit direction; nowhere 0.
    double pdf(Vec3 direction) const;
    /// A unit direction for uniform numbers in [0,1).
    Vec3 sample(double u, double v) const;

private:
    struct Lobe {
        Vec3 axis;
        ConeLobe cone;
        double share; ///< Of all directions drawn.
    };
    std::vector<Lobe> lobes_;
    double uniform_ = 1; ///< What the lobes leave.
};

} // namespace candela

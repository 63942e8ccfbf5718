// SPDX-License-Identifier: Apache-2.0
#include "world/lights/emission_lobes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// The share of directions that no cone has a say in.
constexpr double uniformShare = 0.1;

/// At 1 - cosine from the axis, turned by `turn` of a full circle (Duff et al. 2017).
Vec3 directionNear(Vec3 axis, double oneMinusCosine, double turn) {
    const double z = 1 - oneMinusCosine;
    const double r = std::sqrt(std::max(0.0, oneMinusCosine * (2 - oneMinusCosine)));
    const double x = r * std::cos(2 * std::numbers::pi * turn);
    const double y = r * std::sin(2 * std::numbers::pi * turn);
    const double sign = std::copysign(1.0, double(axis.z)), a = -1 / (sign + axis.z);
    const double b = double(axis.x) * axis.y * a;
    return normalize(Vec3{float(x * (1 + sign * axis.x * axis.x * a) + y * b + z * axis.x),
                          float(x * sign * b + y * (sign + axis.y * axis.y * a) + z * axis.y),
                          float(x * -sign * axis.x - y * axis.y + z * axis.z)});
}

} // namespace

EmissionLobes::EmissionLobes(std::span<const EmissionCone> cones) {
    double total = 0;
    for (const EmissionCone &cone : cones)
        if (cone.importance > 0 && std::isfinite(cone.importance) && cone.angle > 0) {
            lobes_.push_back({cone.axis, ConeLobe(cone.angle, cone.exponent), cone.importance});
            total += cone.importance;
        }
    if (lobes_.empty())
        return;
    uniform_ = uniformShare;
    for (Lobe &lobe : lobes_)
        lobe.share *= (1 - uniform_) / total;
}

double EmissionLobes::pdf(Vec3 direction) const {
    double sum = uniform_ / (4 * std::numbers::pi);
    for (const Lobe &lobe : lobes_)
        sum += lobe.share * lobe.cone.pdf(dot(direction, lobe.axis));
    return sum;
}

Vec3 EmissionLobes::sample(double u, double v) const {
    for (const Lobe &lobe : lobes_) {
        if (u < lobe.share)
            return directionNear(lobe.axis, lobe.cone.sampleOneMinusMu(u / lobe.share), v);
        u -= lobe.share;
    }
    return directionNear({0, 0, 1}, 2 * std::min(u / uniform_, 1.0), v);
}

} // namespace candela

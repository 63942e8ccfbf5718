// SPDX-License-Identifier: Apache-2.0
#include "world/lights/sky_cones.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;
constexpr float largestBelow1 = 0x1.fffffep-1f;

/// How far numbers stay from the ends of a cone's share, beyond which the shader, which computes
/// with floats, would draw from another one.
constexpr double margin = 0x1p-22;

} // namespace

SkyCones::SkyCones(std::span<const EmissionCone> cones) {
    for (const EmissionCone &stated : cones) {
        if (!(stated.importance > 0))
            continue;
        const double sine = std::sin(std::clamp(double(stated.angle), 0.0, 360.0) * pi / 720);
        cones_.push_back({stated.axis, stated.importance, total_, 2 * sine * sine, 0});
        total_ += stated.importance;
        isWide_ |= sine > 0;
    }
    for (Cone &cone : cones_)
        if (cone.height > 0)
            cone.density = cone.importance / (double(total_) * 2 * pi * cone.height);
}

double SkyCones::Cone::heightOf(Vec3 direction) const {
    const double x = double(direction.x) - axis.x, y = double(direction.y) - axis.y,
                 z = double(direction.z) - axis.z;
    return (x * x + y * y + z * z) / 2;
}

double SkyCones::pdf(Vec3 direction) const {
    double sum = 0;
    for (const Cone &cone : cones_)
        if (cone.holds(direction))
            sum += cone.density;
    return sum;
}

/// As the shader chooses.
const SkyCones::Cone &SkyCones::drawnBy(float x) const {
    const float wanted = x * total_;
    std::size_t drawn = 0;
    for (std::size_t k = 1; k < cones_.size(); ++k)
        if (cones_[k].before <= wanted)
            drawn = k;
    return cones_[drawn];
}

double SkyCones::pdfOfDrawn(float x, Vec3 direction) const {
    const Cone &drawn = drawnBy(x);
    if (drawn.height == 0)
        return 0;
    return pdf(direction) + (drawn.holds(direction) ? 0 : drawn.density); // But for rounding.
}

std::array<float, 2> SkyCones::numbersFor(Vec3 direction) const {
    // The densest draws it most finely.
    const Cone *densest = nullptr;
    for (const Cone &cone : cones_)
        if (cone.height > 0 && cone.holds(direction) &&
            (!densest || cone.density > densest->density))
            densest = &cone;
    if (!densest)
        return {};
    const Vec3 axis = densest->axis;
    const double sign = axis.z < 0 ? -1 : 1, a = -1 / (sign + axis.z),
                 b = double(axis.x) * axis.y * a;
    const double sideways = direction.x * (1 + sign * axis.x * axis.x * a) +
                            direction.y * (sign * b) + direction.z * (-sign * axis.x);
    const double upward =
        direction.x * b + direction.y * (sign + double(axis.y) * axis.y * a) - direction.z * axis.y;
    const double turn = std::atan2(upward, sideways) / (2 * pi);

    const double low = densest->before / double(total_),
                 share = densest->importance / double(total_);
    const double room = std::min(margin, share / 4);
    const double x = low + share * (densest->heightOf(direction) / densest->height);
    return {std::min(float(std::clamp(x, low > 0 ? low + room : 0.0, low + share - room)),
                     largestBelow1),
            std::min(float(turn < 0 ? turn + 1 : turn), largestBelow1)};
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/lights/nested_grid.h"

namespace candela {

/// Of all samples, those in the rectangle alone.
static constexpr double shareOfPart = 0.8;

double NestedGrid::pdf(double a, double b) const {
    if (!part_)
        return whole_.pdf(a, b);
    double inPart = 0;
    if (where_.holds(a, b)) {
        const auto [x, y] = where_.within(a, b);
        inPart = part_->pdf(x, y) / where_.area();
    }
    return shareOfPart * inPart + (1 - shareOfPart) * whole_.pdf(a, b);
}

std::array<double, 2> NestedGrid::sample(double u, double v) const {
    if (!part_)
        return whole_.sample(u, v);
    if (u >= shareOfPart)
        return whole_.sample((u - shareOfPart) / (1 - shareOfPart), v);
    const auto [x, y] = part_->sample(u / shareOfPart, v);
    return {where_.low[0] + x * where_.size[0], where_.low[1] + y * where_.size[1]};
}

} // namespace candela

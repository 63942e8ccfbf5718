// SPDX-License-Identifier: Apache-2.0
// Where a moment lies among the even steps of what changes its shape while the shutter is open.
#pragma once

#include "world/geometry/primitive_variables.h"

#include <algorithm>

namespace candela {

/// Between a step and the next, `share` of the way.
struct Moment {
    int step = 0;
    float share = 0;
};

/// When shares[k] of the shutter's interval has passed, of so many steps; null = none has.
inline Moment momentAt(const float *shares, int k, int steps) {
    if (!shares || steps < 2)
        return {};
    const float place = shares[k] * float(steps - 1);
    const int step = std::clamp(int(place), 0, steps - 2);
    return {step, place - float(step)};
}

/// Of values of all steps, one step's after the other's, leaves what they are at the moment.
inline void keepMoment(NumericVariable &variable, int steps, Moment moment) {
    std::vector<float> &values = variable.values;
    const std::size_t size = values.size() / std::size_t(steps);
    const float *from = values.data() + std::size_t(moment.step) * size;
    for (std::size_t k = 0; k < size; ++k)
        values[k] = moment.share == 0
                        ? from[k]
                        : from[k] * (1 - moment.share) + from[size + k] * moment.share;
    values.resize(size);
}

/// Puts the values of the next step behind those that are there.
inline void addStep(NumericVariable &variable, const NumericVariable &next) {
    variable.values.insert(variable.values.end(), next.values.begin(), next.values.end());
}

} // namespace candela

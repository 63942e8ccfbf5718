// SPDX-License-Identifier: Apache-2.0
// Multiple importance sampling: every weight by which one way of finding light counts beside
// another is computed here (power heuristic, Veach and Guibas 1995). Densities are per steradian,
// roulette is no part of them.
#pragma once

#include <limits>

namespace candela {

/// The weight of what a technique of density `own` has found, where another one finds it with
/// density `other`: own^2 / (own^2 + other^2), for any densities from 0 to infinity. Both weights
/// of a pair add to 1 unless both densities are 0.
inline float misWeight(float own, float other) {
    constexpr float most = std::numeric_limits<float>::max();
    own = own > most ? most : own;
    other = other > most ? most : other;
    const float ratio = other / (own > 0 ? own : 1.0f); // Its square may be infinite.
    return own > 0 ? 1 / (1 + ratio * ratio) : 0.0f;
}

/// The weight of a technique that counts `weight` among some, when others join them whose densities
/// squared, over its own squared, are `others` together.
inline double misWeightAmong(double weight, double others) {
    return weight > 0 ? 1 / (1 / weight + others) : 0.0;
}

/// factor[i] = what the radiance of a light sample is worth as Cl: weight / (pi lightPdf), weighted
/// against finding the same direction with density directionPdf. Delta lights
/// (lightPdf = 0) come as they are. 0 where `wanted` is 0.
void lightSampleFactors(int count, const float *lightPdf, const float *directionPdf,
                        const float *wanted, float *factor);

/// weight[i] of emission that a direction of density directionPdf has hit, against light sampling
/// of density lightPdf; 1 for directions without a choice (directionPdf = 0).
void emissionWeights(int count, const float *directionPdf, const float *lightPdf, float *weight);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What the service nearestHit tells of what a ray meets: numbers in this order, and then the
// samples of the colours Cs and Os.
#pragma once

namespace candela {

/// Index of a result; of points and vectors that of the first component.
struct HitField {
    static constexpr int hit = 0;      ///< 1, or 0 if the ray meets nothing: then all are 0.
    static constexpr int distance = 1; ///< From the ray's origin, metres.
    static constexpr int P = 2;
    static constexpr int N = 5; ///< Shading normal, unit length.
    static constexpr int Ng = 8;
    static constexpr int s = 11;
    static constexpr int t = 12;
    static constexpr int u = 13;
    static constexpr int v = 14;
    static constexpr int Cs = 15; ///< Of `samples` numbers.
    static constexpr int Os(int samples) { return Cs + samples; }
    static constexpr int count(int samples) { return Cs + 2 * samples; }
};

} // namespace candela

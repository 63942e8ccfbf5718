// SPDX-License-Identifier: Apache-2.0
// Sine and cosine of a fraction of a turn, in plain arithmetic that compilers vectorise.
#pragma once

#include <cmath>

namespace candela {

/// sin and cos of 2 pi t for t in [0,1]; absolute error below 1e-6.
inline void sinCosTurns(float t, float &sine, float &cosine) {
    // Quarter turns leave an angle in [-pi/4, pi/4], where short Taylor polynomials suffice.
    float quarters = 4 * t;
    int quadrant = int(quarters + 0.5f);
    float x = (quarters - float(quadrant)) * float(M_PI / 2), x2 = x * x;
    float s = x * (1 + x2 * (-1 / 6.0f + x2 * (1 / 120.0f - x2 * (1 / 5040.0f))));
    float c = 1 + x2 * (-0.5f + x2 * (1 / 24.0f + x2 * (-1 / 720.0f + x2 * (1 / 40320.0f))));
    bool swap = quadrant & 1;
    float a = swap ? c : s, b = swap ? s : c;
    sine = quadrant & 2 ? -a : a;
    cosine = (quadrant + 1) & 2 ? -b : b;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Steps and pulses, sharp, smooth and filtered, under the names that the shaders of Advanced
// RenderMan use.
#ifndef PATTERNS_H
#define PATTERNS_H

#include "filterwidth.h"

#define boxstep(a, b, x) clamp(((x) - (a)) / ((b) - (a)), 0, 1)
#define blend(a, b, x) ((a) * (1 - (x)) + (b) * (x))

// 1 from edge0 to edge1.
#define pulse(edge0, edge1, x) (step(edge0, x) - step(edge1, x))

// Rises from e0 to e1 and falls from e2 to e3.
#define smoothpulse(e0, e1, e2, e3, x) (smoothstep(e0, e1, x) - smoothstep(e2, e3, x))

// In each period 0 as far as edge, 1 from there on.
#define pulsetrain(edge, period, x) pulse(edge, period, mod(x, period))
#define smoothpulsetrain(e0, e1, e2, e3, period, x) smoothpulse(e0, e1, e2, e3, mod(x, period))

/// The mean of pulse() over a width of dx around x.
float filteredpulse(float edge0, edge1, x, dx) {
    float lower = x - 0.5 * dx;
    float covered = min(lower + dx, edge1) - max(lower, edge0);
    return clamp(covered / dx, 0, 1);
}

/// The mean of pulsetrain() over a width of dx around x.
float filteredpulsetrain(float edge, period, x, dx) {
    float zero = edge / period;
    float width = dx / period;
    float from = x / period - 0.5 * width;
    float to = from + width;
    float ones = (1 - zero) * (floor(to) - floor(from));
    ones += max(0, to - floor(to) - zero) - max(0, from - floor(from) - zero);
    return ones / width;
}

#endif

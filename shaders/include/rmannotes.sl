// SPDX-License-Identifier: Apache-2.0
// What shaders that were written after the RenderMan Notes expect under this name: words for
// layers and tiles. It is found where no file of that name lies beside the shader.
#ifndef RMANNOTES_SL
#define RMANNOTES_SL

// Noise from -1 to 1.
#define snoise(x) (2 * noise(x) - 1)
#define snoise2(x, y) (2 * noise(x, y) - 1)

// Opacities of layers, as sets.
#define complement(a) (1 - (a))
#define intersection(a, b) ((a) * (b))
#define union(a, b) ((a) + (b) - (a) * (b))
#define difference(a, b) ((a) * (1 - (b)))

// b over a.
#define blend(a, b, x) ((a) * (1 - (x)) + (b) * (x))

// From 0 at a to 1 at b, straight.
#define boxstep(a, b, x) clamp(((x) - (a)) / ((b) - (a)), 0, 1)

// 1 from a to b, with edges as wide as fuzz.
#define pulse(a, b, fuzz, x) (smoothstep((a) - (fuzz), (a), (x)) - smoothstep((b) - (fuzz), (b), (x)))

// freq tiles from 0 to 1: where in its tile a place lies, and in which one.
#define repeat(x, freq) mod((x) * (freq), 1.0)
#define whichtile(x, freq) floor((x) * (freq))
#define odd(x) (mod(x, 2) == 1)
#define even(x) (mod(x, 2) == 0)

// (x, y) turned by rad around (ox, oy) gives (rx, ry).
#define rotate2d(x, y, rad, ox, oy, rx, ry) \
    rx = ((x) - (ox)) * cos(rad) - ((y) - (oy)) * sin(rad) + (ox); \
    ry = ((x) - (ox)) * sin(rad) + ((y) - (oy)) * cos(rad) + (oy)

#endif

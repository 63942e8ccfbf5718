// SPDX-License-Identifier: Apache-2.0
// Noise of the yardsticks: the cheapest that is still gradient noise with a quintic fade. Corners
// are hashed by sums of their axes' products and one round of mixing; gradients are a cube's
// corners, so that a dot product is three signs turned and two sums.
#pragma once

#include "lanes.h"

namespace candela::bench {
namespace {

inline Floats fade(Floats t) { return t * t * t * fused(t, fused(t, all(6), all(-15)), all(10)); }

/// Uniform bits of a lattice point, which is given as the sum of its axes' products.
inline Bits hashed(Bits sum) {
    const Bits once = (sum ^ (sum >> 15)) * 0x2c1b3c6du;
    return once ^ (once >> 13);
}

/// (+-1, +-1, +-1) . (x, y, z), signs being the hash's upper bits.
inline Floats towards(Bits hash, Floats x, Floats y, Floats z) {
    return signedBy(x, hash, 0) + signedBy(y, hash, 1) + signedBy(z, hash, 2);
}

/// In [0, 1], mean one half.
inline Floats noise(const Three &at) {
    constexpr std::uint32_t factor[3] = {0x9e3779b1u, 0x85ebca77u, 0xc2b2ae3du};
    Bits line[3][2];
    Floats near[3], far[3], share[3];
    for (int k = 0; k < 3; ++k) {
        const Floats cell = floor(at[k]);
        near[k] = at[k] - cell;
        far[k] = near[k] - 1.0f;
        share[k] = fade(near[k]);
        line[k][0] = wholeBits(cell) * factor[k];
        line[k][1] = line[k][0] + factor[k];
    }
    Floats row[2][2];
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 2; ++y) {
            const Bits base = line[1][y] + line[2][z];
            const Floats Y = y ? far[1] : near[1], Z = z ? far[2] : near[2];
            row[z][y] = mixed(towards(hashed(base + line[0][0]), near[0], Y, Z),
                              towards(hashed(base + line[0][1]), far[0], Y, Z), share[0]);
        }
    const Floats sum = mixed(mixed(row[0][0], row[0][1], share[1]),
                             mixed(row[1][0], row[1][1], share[1]), share[2]);
    return fused(sum, all(1 / 3.0f), all(.5f));
}

/// A number in [0, 1) for each cell.
inline Floats cellNoise(Floats x, Floats y) {
    const Bits hash = hashed(wholeBits(floor(x)) * 0x9e3779b1u + wholeBits(floor(y)) * 0x85ebca77u);
    return __builtin_convertvector(Integers(hash >> 8), Floats) * 0x1p-24f;
}

} // namespace
} // namespace candela::bench

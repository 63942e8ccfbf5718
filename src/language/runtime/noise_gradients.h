// SPDX-License-Identifier: Apache-2.0
// The gradients of gradient noise: eight, and the same turned round, for each number of dimensions.
#pragma once

namespace {

/// Coordinates of sixteen gradients, an axis a row; the second half is the first one's opposite.
template <int dimensions> struct GradientTable { alignas(64) float axis[dimensions][16]; };

/// Scales eight gradients so that no blend of them exceeds one half. `largestSum` is what unscaled
/// ones reach, attained in the middle of a cell or close to it.
template <int dimensions>
constexpr GradientTable<dimensions> makeGradients(const float (&half)[dimensions][8],
                                                  float largestSum) {
    GradientTable<dimensions> table{};
    for (int k = 0; k < dimensions; ++k)
        for (int i = 0; i < 16; ++i)
            table.axis[k][i] = (i < 8 ? half[k][i] : -half[k][i - 8]) * (0.4999f / largestSum);
    return table;
}

template <int dimensions> constexpr GradientTable<dimensions> noiseGradients{};

/// Evenly spaced slopes in (-1,1).
template <>
constexpr GradientTable<1> noiseGradients<1> = makeGradients<1>(
    {{0.0625f, 0.1875f, 0.3125f, 0.4375f, 0.5625f, 0.6875f, 0.8125f, 0.9375f}}, 0.46876f);
/// Evenly spaced directions.
template <>
constexpr GradientTable<2>
    noiseGradients<2> = makeGradients<2>({{0.9807853f, 0.8314696f, 0.5555702f, 0.1950903f,
                                           -0.1950903f, -0.5555702f, -0.8314696f, -0.9807853f},
                                          {0.1950903f, 0.5555702f, 0.8314696f, 0.9807853f,
                                           0.9807853f, 0.8314696f, 0.5555702f, 0.1950903f}},
                                         0.69536f);
/// Directions found by search: second moments are those of the sphere, fourth moments nearer to
/// them than those of a cube's edges.
template <>
constexpr GradientTable<3>
    noiseGradients<3> = makeGradients<3>({{-0.6353653f, 0.1015626f, 0.9176784f, 0.5925001f,
                                           0.6150207f, -0.1080997f, 0.8037114f, -0.1589677f},
                                          {0.7714549f, -0.7863147f, 0.3139163f, 0.6703898f,
                                           -0.08997f, 0.2485513f, -0.2165316f, -0.8866649f},
                                          {-0.0341796f, -0.6094212f, -0.2435631f, 0.4466778f,
                                           -0.7833613f, -0.9625678f, 0.554222f, 0.4342287f}},
                                         0.78584f);
template <>
constexpr GradientTable<4>
    noiseGradients<4> = makeGradients<4>({{0.1744232f, -0.1053659f, 0.7488423f, -0.4462788f,
                                           0.7537433f, -0.7916573f, -0.078367f, -0.0237856f},
                                          {0.9095452f, -0.2633171f, 0.2088512f, 0.7945796f,
                                           0.2992778f, 0.2197022f, 0.5367009f, -0.0420012f},
                                          {0.3616535f, 0.7347124f, -0.0156528f, -0.3785235f,
                                           0.3173194f, 0.519058f, -0.141788f, -0.8922202f},
                                          {0.1072882f, -0.6162465f, 0.6287856f, 0.1618593f,
                                           -0.4915406f, 0.2357718f, -0.8280742f, -0.4490137f}},
                                         0.81473f);

} // namespace

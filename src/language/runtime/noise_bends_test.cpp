// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/noise_bends.h"

#include "language/runtime/noise_gradients.h"
#include "language/runtime/runtime_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace candela::runtime {
namespace {

/// The blend at t with its first and second derivatives.
std::array<double, 3> blend(double t) {
    return {t * t * t * (t * (t * 6 - 15) + 10), 30 * t * t * (t - 1) * (t - 1),
            60 * t * (2 * t - 1) * (t - 1)};
}

/// The greatest derivative along axis i (and j, unless it is -1) at a place of a cell, over all
/// gradients that its corners may have.
template <int dimensions> double most(const double *place, int i, int j) {
    double sum = 0;
    for (int corner = 0; corner < 1 << dimensions; ++corner) {
        const auto isHigh = [&](int axis) { return (corner >> axis & 1) != 0; };
        const auto weight = [&](int a, int b) {
            double product = 1;
            for (int k = 0; k < dimensions; ++k) {
                const int order = (k == a) + (k == b);
                const double high = blend(place[k])[std::size_t(order)];
                product *= isHigh(k) ? high : order == 0 ? 1 - high : -high;
            }
            return product;
        };
        double factor[dimensions];
        for (int k = 0; k < dimensions; ++k) {
            factor[k] = weight(i, j) * (place[k] - isHigh(k));
            if (k == i)
                factor[k] += weight(-1, j);
            if (k == j)
                factor[k] += weight(i, -1);
        }
        double greatest = 0;
        for (int g = 0; g < 16; ++g) {
            double value = 0;
            for (int k = 0; k < dimensions; ++k)
                value += factor[k] * double(noiseGradients<dimensions>.axis[k][g]);
            greatest = std::max(greatest, value);
        }
        sum += greatest;
    }
    return sum;
}

template <int dimensions> NoiseBend greatestOnGrid(int steps) {
    double slope = 0, twice = 0, mixed = 0;
    int points = 1;
    for (int k = 0; k < dimensions; ++k)
        points *= steps + 1;
    for (int n = 0; n < points; ++n) {
        double place[dimensions];
        for (int k = 0, rest = n; k < dimensions; ++k, rest /= steps + 1)
            place[k] = double(rest % (steps + 1)) / steps;
        for (int i = 0; i < dimensions; ++i) {
            slope = std::max(slope, most<dimensions>(place, i, -1));
            twice = std::max(twice, most<dimensions>(place, i, i));
            for (int j = 0; j < i; ++j)
                mixed = std::max(mixed, most<dimensions>(place, i, j));
        }
    }
    return {float(slope), float(twice), float(mixed)};
}

template <int dimensions> void expectHeld(int steps) {
    const NoiseBend found = greatestOnGrid<dimensions>(steps);
    const NoiseBend known = noiseBends[dimensions - 1];
    const auto expect = [](float least, float bound) {
        EXPECT_LE(least * 1.005f, bound) << dimensions;
        EXPECT_GE(least * 1.04f, bound) << dimensions;
    };
    expect(found.slope, known.slope);
    expect(found.twice, known.twice);
    expect(found.mixed, known.mixed);
}

TEST(NoiseBends, HoldForAllGradientsThatTheHashCanGive) {
    expectHeld<1>(1000);
    expectHeld<2>(120);
    expectHeld<3>(24);
    expectHeld<4>(10);
}

/// By the noise itself, about random places: from slopes at both ends of a short way.
TEST(NoiseBends, NoPlaceOfTheNoiseBendsMore) {
    std::mt19937 bits(5);
    std::uniform_real_distribution<float> number(-50, 50);
    constexpr float h = 1.0f / 128;
    for (int n = 0; n < 20000; ++n) {
        float place[3] = {number(bits), number(bits), number(bits)}, at[4], beyond[4];
        const float *in[] = {&place[0], &place[1], &place[2]};
        float *out[] = {&at[0], &at[1], &at[2], &at[3]};
        callScalar(RuntimeFunction::noise3_slopes, in, out);
        const std::size_t along = bits() % 3;
        place[along] += h;
        float *out2[] = {&beyond[0], &beyond[1], &beyond[2], &beyond[3]};
        callScalar(RuntimeFunction::noise3_slopes, in, out2);
        for (std::size_t k = 0; k < 3; ++k) {
            ASSERT_LE(std::fabs(at[1 + k]), noiseBends[2].slope);
            const float bend = std::fabs(beyond[1 + k] - at[1 + k]) / h;
            ASSERT_LE(bend, (k == along ? noiseBends[2].twice : noiseBends[2].mixed) + 1e-3f);
        }
    }
}

} // namespace
} // namespace candela::runtime

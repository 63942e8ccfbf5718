// SPDX-License-Identifier: Apache-2.0
#include "foundation/units/color_basis.h"

#include <algorithm>

namespace candela {

namespace {

using Matrix3 = std::array<std::array<double, 3>, 3>;

/// By Cramer's rule.
Matrix3 inverse(const Matrix3 &m) {
    const auto cofactor = [&](int row, int column) {
        const int r1 = (row + 1) % 3, r2 = (row + 2) % 3;
        const int c1 = (column + 1) % 3, c2 = (column + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const double determinant =
        m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Matrix3 result;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            result[row][column] = cofactor(column, row) / determinant;
    return result;
}

/// The way back of least squares: (U^T U)^-1 U^T of the uplift U.
std::array<std::vector<float>, 3> wayBack(const std::vector<std::array<float, 3>> &uplift) {
    Matrix3 square{};
    for (const auto &sample : uplift)
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 3; ++column)
                square[row][column] += double(sample[row]) * sample[column];
    const Matrix3 inverted = inverse(square);
    std::array<std::vector<float>, 3> result;
    for (int primary = 0; primary < 3; ++primary)
        for (const auto &sample : uplift)
            result[primary].push_back(float(inverted[primary][0] * sample[0] +
                                            inverted[primary][1] * sample[1] +
                                            inverted[primary][2] * sample[2]));
    return result;
}

} // namespace

std::vector<float> ColorBasis::luminance() const {
    if (isRgb())
        return {luminanceWeights.begin(), luminanceWeights.end()};
    std::vector<float> weights(static_cast<std::size_t>(samples));
    for (int k = 0; k < samples; ++k)
        for (int primary = 0; primary < 3; ++primary)
            weights[k] += luminanceWeights[primary] * rgbFromSamples[primary][k];
    return weights;
}

ColorBasis evenBasis(int samples) {
    ColorBasis basis;
    basis.samples = samples;
    if (samples == 3)
        return basis;
    if (samples == 1) {
        basis.samplesFromRgb = {luminanceWeights};
        basis.rgbFromSamples.fill({1});
        return basis;
    }
    for (int k = 0; k < samples; ++k) {
        const float fromBlue = 2 * float(k) / float(samples - 1); // 0 blue, 1 green, 2 red
        const float red = std::max(0.0f, fromBlue - 1), blue = std::max(0.0f, 1 - fromBlue);
        basis.samplesFromRgb.push_back({red, 1 - red - blue, blue});
    }
    basis.rgbFromSamples = wayBack(basis.samplesFromRgb);
    return basis;
}

} // namespace candela

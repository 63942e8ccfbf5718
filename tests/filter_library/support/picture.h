// SPDX-License-Identifier: Apache-2.0
// Pictures for the tests of filters, and what a viewer measures in them, in double precision.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

namespace candela::filters {

using Rgb = std::array<double, 3>;

/// Row 0 is the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<Rgb> pixels;

    Picture() = default;
    Picture(int width, int height, Rgb value = {})
        : width(width), height(height), pixels(std::size_t(width) * std::size_t(height), value) {}

    Rgb &at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    const Rgb &at(int x, int y) const {
        return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
    }
    /// What the border holds goes on beyond it.
    const Rgb &clamped(int x, int y) const;
};

Rgb operator+(const Rgb &, const Rgb &);
Rgb operator*(double, const Rgb &);

/// cd/m^2 of a radiance in W m^-2 sr^-1.
double luminanceOf(const Rgb &);
/// Photometric: 179 lm/W.
Rgb photometricOf(const Rgb &);

/// As filters see them.
Rgb asFloats(const Rgb &);

Picture makePicture(int width, int height, const std::function<Rgb(int x, int y)> &);
/// Colours of all hues over so many decades of luminance, lowest 10^`lowest` cd/m^2: no two alike,
/// the same in each run.
Picture manifold(int width, int height, double lowest, double decades);
/// All pixels of a luminance in cd/m^2, grey.
Picture grey(int width, int height, double luminance);

/// The mean over pixels of a function of them.
double meanOf(const Picture &, const std::function<double(const Rgb &)> &);
Rgb sumOf(const Picture &);

/// Tells of the first pixel that differs by more than `relative` of the expected value, or of
/// `floor` where that is less.
void expectNear(const Picture &found, const Picture &expected, double relative, double floor);

} // namespace candela::filters

// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace candela::filters {

const Rgb &Picture::clamped(int x, int y) const {
    return at(std::clamp(x, 0, width - 1), std::clamp(y, 0, height - 1));
}

Rgb operator+(const Rgb &a, const Rgb &b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

Rgb operator*(double factor, const Rgb &a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

double luminanceOf(const Rgb &c) { return 179 * (.2126 * c[0] + .7152 * c[1] + .0722 * c[2]); }

Rgb photometricOf(const Rgb &c) { return 179. * c; }

Rgb asFloats(const Rgb &c) {
    Rgb rounded;
    for (int k = 0; k < 3; ++k) {
        // GCC 12.2 would take two conversions side by side, to float and back, for nothing.
        const volatile float narrow = float(c[k]);
        rounded[k] = narrow;
    }
    return rounded;
}

Picture makePicture(int width, int height, const std::function<Rgb(int x, int y)> &value) {
    Picture made(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            made.at(x, y) = value(x, y);
    return made;
}

Picture manifold(int width, int height, double lowest, double decades) {
    const double golden = .6180339887498949;
    return makePicture(width, height, [&](int x, int y) {
        const double number = y * width + x;
        const double level = std::fmod(number * golden, 1);
        const double hue = std::fmod(number * golden * golden * 7, 1) * 6.283185307179586;
        Rgb c{1 + .8 * std::cos(hue), 1 + .8 * std::cos(hue - 2.1), 1 + .8 * std::cos(hue + 2.1)};
        c = std::pow(10, lowest + decades * level) / luminanceOf(c) * c;
        return asFloats(c);
    });
}

Picture grey(int width, int height, double luminance) {
    const double value = luminance / 179;
    return Picture(width, height, asFloats({value, value, value}));
}

double meanOf(const Picture &picture, const std::function<double(const Rgb &)> &value) {
    double sum = 0;
    for (const Rgb &pixel : picture.pixels)
        sum += value(pixel);
    return sum / double(picture.pixels.size());
}

Rgb sumOf(const Picture &picture) {
    Rgb sum{};
    for (const Rgb &pixel : picture.pixels)
        sum = sum + pixel;
    return sum;
}

void expectNear(const Picture &found, const Picture &expected, double relative, double floor) {
    ASSERT_EQ(found.width, expected.width);
    ASSERT_EQ(found.height, expected.height);
    for (int y = 0; y < found.height; ++y)
        for (int x = 0; x < found.width; ++x)
            for (int c = 0; c < 3; ++c) {
                const double wanted = expected.at(x, y)[c];
                const double bound = relative * std::max(std::abs(wanted), floor);
                ASSERT_NEAR(found.at(x, y)[c], wanted, bound)
                    << "pixel " << x << " " << y << ", channel " << c;
            }
}

} // namespace candela::filters

// SPDX-License-Identifier: Apache-2.0
// Histogram adjustment by Larson, Rushmeier and Piatko, with each of its ceilings.
#include "tests/filter_library/support/filter_run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela::filters {
namespace {

constexpr int bins = 100;
constexpr double most = 100, least = 1; ///< cd/m^2, of the display

double justNoticeable(double luminance) {
    const double l = std::log10(luminance);
    if (l < -3.94)
        return std::pow(10, -2.86);
    if (l < -1.44)
        return std::pow(10, std::pow(.405 * l + 1.6, 2.18) - 2.86);
    if (l < -.0184)
        return std::pow(10, l - .395);
    if (l < 1.9)
        return std::pow(10, std::pow(.249 * l + .65, 2.7) - .72);
    return std::pow(10, l - 1.255);
}

/// The tone curve: from the logarithm of luminance to that of the display's.
struct Curve {
    double darkest = 0, width = 0;
    std::vector<double> frequencies = std::vector<double>(bins);
    bool linear = false; ///< The scene fits without.

    double total() const { return std::accumulate(frequencies.begin(), frequencies.end(), 0.0); }
    double displayLog(double brightness) const {
        double below = 0;
        const double at = std::clamp((brightness - darkest) / width, 0., double(bins));
        for (int bin = 0; bin < bins; ++bin)
            below += frequencies[bin] * std::clamp(at - bin, 0., 1.);
        return std::log(least) + std::log(most / least) * below / total();
    }
};

double ceilingOf(const Curve &curve, const std::vector<double> &before, int bin, double total,
                 bool human) {
    const double plain = total * curve.width / std::log(most / least);
    if (!human)
        return plain;
    const double below = std::accumulate(before.begin(), before.begin() + bin, 0.0);
    const double share = (below + before[bin] / 2) / total;
    const double display = least * std::pow(most / least, share);
    const double scene = std::exp(curve.darkest + (bin + .5) * curve.width);
    return plain * justNoticeable(display) / justNoticeable(scene) * scene / display;
}

Curve curveOf(const std::vector<double> &glances, const std::string &contrast) {
    Curve curve;
    const auto [lowest, highest] = std::minmax_element(glances.begin(), glances.end());
    curve.darkest = std::log(*lowest);
    curve.width = std::max((std::log(*highest) - curve.darkest) / bins, 1e-6);
    for (const double glance : glances) {
        const double at = std::floor((std::log(glance) - curve.darkest) / curve.width);
        ++curve.frequencies[int(std::clamp(at, 0., bins - 1.))];
    }
    const double tolerance = .025 * double(glances.size());
    double cut = contrast == "none" ? 0 : 1e9;
    while (cut > tolerance && !curve.linear) {
        const double total = curve.total();
        const std::vector<double> before = curve.frequencies;
        for (int bin = 0; bin < bins; ++bin)
            curve.frequencies[bin] =
                std::min(before[bin], ceilingOf(curve, before, bin, total, contrast == "human"));
        cut = total - curve.total();
        curve.linear = curve.total() < tolerance;
    }
    return curve;
}

/// Means over squares, which divide the picture evenly here.
std::vector<double> glancesOf(const Picture &scene, int each) {
    std::vector<double> glances;
    for (int y = 0; y < scene.height; y += each)
        for (int x = 0; x < scene.width; x += each) {
            double sum = 0;
            for (int j = 0; j < each; ++j)
                for (int i = 0; i < each; ++i)
                    sum += luminanceOf(scene.at(x + i, y + j));
            glances.push_back(std::max(sum / (each * each), 1e-4));
        }
    return glances;
}

double expectedValue(const Curve &curve, const std::vector<double> &glances, double luminance) {
    double display = std::exp(curve.displayLog(std::log(std::max(luminance, 1e-4))));
    if (curve.linear) {
        double middle = 0;
        for (const double glance : glances)
            middle += std::log(glance) / double(glances.size());
        const double ward = std::pow(
            (1.219 + std::pow(most / 2, .4)) / (1.219 + std::pow(std::exp(middle), .4)), 2.5);
        display =
            luminance * std::min(ward, most / *std::max_element(glances.begin(), glances.end()));
    }
    return std::max((display - least) / (most - least), 0.);
}

/// Mostly dark, with a bright part; each of many luminances, in squares with some noise.
Picture darkAndBright(int width, int height, int square) {
    const Picture levels = manifold(width / square, height / square, -1, 2);
    const Picture noise = manifold(width, height, 0, .1);
    return makePicture(width, height, [&](int x, int y) {
        const double light = luminanceOf(levels.at(x / square, y / square));
        return asFloats((x > width * 2 / 3 ? 900 : 1) * light * noise.at(x, y));
    });
}

void expectFormula(const Picture &scene, const char *contrast, int each, double degrees,
                   bool linear) {
    const auto glances = glancesOf(scene, each);
    const Curve curve = curveOf(glances, contrast);
    EXPECT_EQ(curve.linear, linear);
    const auto expected = makePicture(scene.width, scene.height, [&](int x, int y) {
        const Rgb &c = scene.at(x, y);
        return expectedValue(curve, glances, luminanceOf(c)) / luminanceOf(c) * photometricOf(c);
    });
    const Filter filter =
        Filter("histogram_adjust").with("contrast", contrast).with("fieldofview", degrees);
    expectNear(filtered(filter, scene), expected, 1e-4, .01);
}

TEST(HistogramAdjust, IsTheFormula) {
    for (const char *contrast : {"none", "linear", "human"}) {
        SCOPED_TRACE(contrast);
        expectFormula(darkAndBright(48, 32, 1), contrast, 1, 48, false);
        expectFormula(darkAndBright(128, 96, 4), contrast, 4, 32, false);
    }
}

/// Of less contrast than the display: linear, as Ward scales.
TEST(HistogramAdjust, ScenesThatFitAreScaled) {
    const Picture scene = manifold(48, 32, 1, .5);
    for (const char *contrast : {"linear", "human"}) {
        SCOPED_TRACE(contrast);
        expectFormula(scene, contrast, 1, 48, true);
    }
}

/// The ceiling's meaning: luminances that differ by a factor do not differ by more on the display.
/// What the last round cut, 2.5 %, is left of it.
TEST(HistogramAdjust, ContrastNeverExceedsTheScenes) {
    const Picture scene = darkAndBright(60, 40, 1);
    const Filter filter =
        Filter("histogram_adjust").with("contrast", "linear").with("fieldofview", 60);
    const Picture found = filtered(filter, scene);
    std::vector<std::pair<double, double>> curve; // logarithms of luminance, and of the display's
    for (std::size_t i = 0; i < scene.pixels.size(); ++i)
        curve.push_back({std::log(luminanceOf(scene.pixels[i])),
                         std::log(least + (most - least) * luminanceOf(found.pixels[i]) / 179)});
    std::sort(curve.begin(), curve.end());
    for (std::size_t i = 10; i < curve.size(); i += 10) {
        const double world = curve[i].first - curve[i - 10].first;
        const double display = curve[i].second - curve[i - 10].second;
        EXPECT_GE(display, -1e-5);
        EXPECT_LE(display, world * 1.06 + 1e-4);
    }
    EXPECT_NEAR(curve.back().second, std::log(most), 1e-5);
}

TEST(HistogramAdjust, OneLuminanceAloneIsScaledAsWardDoes) {
    const Picture found = filtered(Filter("histogram_adjust"), grey(30, 20, 50));
    EXPECT_NEAR(found.at(4, 4)[0], 49 / 99., 1e-5);
}

} // namespace
} // namespace candela::filters

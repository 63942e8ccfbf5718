// SPDX-License-Identifier: Apache-2.0
// Equation numbers are those of Andersson et al. 2020, but for exposures: Andersson et al. 2021.
#include "image/flip.h"

#include "foundation/base/parallel.h"
#include "foundation/units/color.h"
#include "image/imaging.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;

using Triple = std::array<float, 3>;
using Values = std::vector<Triple>; ///< By pixel.

struct Size {
    int width, height;
};

// ---- Colours: linear Rec.709, CIE XYZ relative to its white (D65), and two opponent spaces ----

constexpr double xyzOfRgb[3][3] = {
    {.4123908, .3575843, .1804808}, {.2126390, .7151687, .0721923}, {.0193308, .1191948, .9505322}};
constexpr double rgbOfXyz[3][3] = {{3.2409699, -1.5373832, -.4986108},
                                   {-.9692436, 1.8759675, .0415551},
                                   {.0556301, -.2039770, 1.0569715}};

double whiteOf(int row) { return xyzOfRgb[row][0] + xyzOfRgb[row][1] + xyzOfRgb[row][2]; }

std::array<double, 3> relativeXyz(const Triple &rgb) {
    std::array<double, 3> xyz{};
    for (int row = 0; row < 3; ++row) {
        for (int c = 0; c < 3; ++c)
            xyz[row] += xyzOfRgb[row][c] * double(rgb[c]);
        xyz[row] /= whiteOf(row);
    }
    return xyz;
}

/// YCxCz: as CIELAB, but linear, so that it may be filtered.
Triple opponentOf(const Triple &rgb) {
    const auto [x, y, z] = relativeXyz(rgb);
    return {float(116 * y - 16), float(500 * (x - y)), float(200 * (y - z))};
}

Triple rgbOfOpponent(const Triple &o) {
    const double y = (double(o[0]) + 16) / 116, x = y + double(o[1]) / 500;
    const double z = y - double(o[2]) / 200;
    const double xyz[3] = {x * whiteOf(0), y * whiteOf(1), z * whiteOf(2)};
    Triple rgb{};
    for (int row = 0; row < 3; ++row)
        rgb[row] = float(rgbOfXyz[row][0] * xyz[0] + rgbOfXyz[row][1] * xyz[1] +
                         rgbOfXyz[row][2] * xyz[2]);
    return rgb;
}

/// CIELAB whose chroma fades with the lightness, as Hunt has found.
std::array<double, 3> huntLab(const Triple &rgb) {
    const auto [x, y, z] = relativeXyz(rgb);
    const auto root = [](double t) {
        constexpr double delta = 6.0 / 29;
        return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
    };
    const double lightness = 116 * root(y) - 16;
    const double fading = .01 * lightness;
    return {lightness, fading * 500 * (root(x) - root(y)), fading * 200 * (root(y) - root(z))};
}

/// HyAB: lightness and chroma apart, for large differences.
double hyab(const Triple &a, const Triple &b) {
    const auto p = huntLab(a), q = huntLab(b);
    return std::fabs(p[0] - q[0]) + std::hypot(p[1] - q[1], p[2] - q[2]);
}

// ---- Filters: sums of products of two kernels of one dimension ----

using Kernel = std::vector<double>; ///< Of odd length, about its middle.

/// The values of a function at whole pixels.
Kernel kernelOf(int radius, const std::function<double(double)> &f) {
    Kernel kernel;
    for (int k = -radius; k <= radius; ++k)
        kernel.push_back(f(double(k)));
    return kernel;
}

double sumOf(const Kernel &kernel) {
    double sum = 0;
    for (double value : kernel)
        sum += value;
    return sum;
}

/// What a pixel of one channel is from its neighbours along x or along y; beyond the border it is
/// as on it.
void filterLine(const std::vector<float> &from, Size size, const Kernel &kernel, bool alongX, int y,
                std::vector<float> &to) {
    const int radius = int(kernel.size()) / 2;
    for (int x = 0; x < size.width; ++x) {
        double sum = 0;
        for (int k = -radius; k <= radius; ++k) {
            const int i = alongX ? std::clamp(x + k, 0, size.width - 1) : x;
            const int j = alongX ? y : std::clamp(y + k, 0, size.height - 1);
            sum += kernel[std::size_t(k + radius)] * double(from[std::size_t(j) * size.width + i]);
        }
        to[std::size_t(y) * size.width + x] = float(sum);
    }
}

std::vector<float> filtered(const std::vector<float> &from, Size size, const Kernel &alongX,
                            const Kernel &alongY) {
    std::vector<float> between(from.size()), to(from.size());
    const auto rows = std::size_t(size.height);
    parallelFor(rows,
                [&](std::size_t y) { filterLine(from, size, alongX, true, int(y), between); });
    parallelFor(rows, [&](std::size_t y) { filterLine(between, size, alongY, false, int(y), to); });
    return to;
}

std::vector<float> channelOf(const Values &values, int c) {
    std::vector<float> channel;
    for (const Triple &value : values)
        channel.push_back(value[c]);
    return channel;
}

// ---- What the eye resolves of colour (4.1) ----

/// A Gaussian of the contrast sensitivity, by degrees: weight and width.
struct Lobe {
    double a, b;
};
constexpr Lobe sensitivity[3][2] = {{{1, .0047}, {0, 1e-5}},      // achromatic,
                                    {{1, .0053}, {0, 1e-5}},      // red and green,
                                    {{34.1, .04}, {13.5, .025}}}; // blue and yellow.
constexpr double widestLobe = .04;

/// The sum of lobes is 1 over the pixels.
std::vector<float> seenChannel(const std::vector<float> &from, Size size, int c,
                               double pixelsPerDegree) {
    const int radius = int(std::ceil(3 * std::sqrt(widestLobe / (2 * pi * pi)) * pixelsPerDegree));
    std::vector<double> sum(from.size());
    double whole = 0;
    for (const Lobe &lobe : sensitivity[c]) {
        if (lobe.a == 0)
            continue;
        const Kernel kernel = kernelOf(radius, [&](double x) {
            const double degrees = x / pixelsPerDegree;
            return std::exp(-pi * pi * degrees * degrees / lobe.b);
        });
        const double height = lobe.a * std::sqrt(pi / lobe.b);
        whole += height * sumOf(kernel) * sumOf(kernel);
        const std::vector<float> part = filtered(from, size, kernel, kernel);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += height * double(part[i]);
    }
    std::vector<float> result;
    for (double value : sum)
        result.push_back(float(value / whole));
    return result;
}

/// As it is seen, back in Rec.709 and within what a display shows.
Values seen(const Values &opponent, Size size, double pixelsPerDegree) {
    std::vector<float> channel[3];
    for (int c = 0; c < 3; ++c)
        channel[c] = seenChannel(channelOf(opponent, c), size, c, pixelsPerDegree);
    Values result(opponent.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] = rgbOfOpponent({channel[0][i], channel[1][i], channel[2][i]});
        for (float &value : result[i])
            value = std::clamp(value, 0.0f, 1.0f);
    }
    return result;
}

/// Differences of colour spread over [0, 1]: the largest one, of green and blue, is 1, and small
/// ones have most of the scale.
double colorError(const Triple &a, const Triple &b) {
    constexpr double power = .7, small = .4, ofSmall = .95;
    static const double largest = std::pow(hyab({0, 1, 0}, {0, 0, 1}), power);
    const double error = std::pow(hyab(a, b), power), knee = small * largest;
    return error < knee ? ofSmall / knee * error
                        : ofSmall + (error - knee) / (largest - knee) * (1 - ofSmall);
}

// ---- Edges and points (4.2) ----

/// A kernel whose positive values, over two dimensions with the Gaussian across, sum to 1, and its
/// negative ones to -1.
Kernel balanced(Kernel kernel, const Kernel &across) {
    double positive = 0, negative = 0;
    for (double value : kernel)
        (value > 0 ? positive : negative) += std::fabs(value);
    for (double &value : kernel)
        value /= (value > 0 ? positive : negative) * sumOf(across);
    return kernel;
}

struct Features {
    std::vector<float> edges, points; ///< How strong, by pixel.
};

Features featuresOf(const Values &opponent, Size size, double pixelsPerDegree) {
    constexpr double degrees = .082;
    const double sigma = .5 * degrees * pixelsPerDegree;
    const int radius = int(std::ceil(3 * sigma));
    const auto gauss = [&](double x) { return std::exp(-x * x / (2 * sigma * sigma)); };
    const Kernel across = kernelOf(radius, gauss);
    const Kernel slope =
        balanced(kernelOf(radius, [&](double x) { return -x * gauss(x); }), across);
    const Kernel bend = balanced(
        kernelOf(radius, [&](double x) { return (x * x / (sigma * sigma) - 1) * gauss(x); }),
        across);
    std::vector<float> lightness;
    for (const Triple &value : opponent)
        lightness.push_back((value[0] + 16) / 116);
    const auto strengthOf = [&](const Kernel &kernel) {
        std::vector<float> x = filtered(lightness, size, kernel, across);
        const std::vector<float> y = filtered(lightness, size, across, kernel);
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] = std::hypot(x[i], y[i]);
        return x;
    };
    return {strengthOf(slope), strengthOf(bend)};
}

// ---- Together (4.3) ----

/// Of linear values within [0, 1].
std::vector<float> errorsOf(const Values &test, const Values &reference, Size size,
                            double pixelsPerDegree) {
    Values opponent[2], shown[2];
    Features features[2];
    for (int k = 0; k < 2; ++k) {
        for (const Triple &rgb : k == 0 ? test : reference)
            opponent[k].push_back(opponentOf(rgb));
        shown[k] = seen(opponent[k], size, pixelsPerDegree);
        features[k] = featuresOf(opponent[k], size, pixelsPerDegree);
    }
    std::vector<float> errors(test.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
        const double ofEdges = std::fabs(features[0].edges[i] - features[1].edges[i]);
        const double ofPoints = std::fabs(features[0].points[i] - features[1].points[i]);
        const double ofFeatures = std::sqrt(std::max(ofEdges, ofPoints) / std::numbers::sqrt2);
        errors[i] =
            float(std::pow(colorError(shown[0][i], shown[1][i]), 1 - std::min(1.0, ofFeatures)));
    }
    return errors;
}

// ---- Exposures ----

/// Narkowicz's fit of the ACES curve, with the exposure that goes with it.
constexpr double curve[5] = {.6 * .6 * 2.51, .6 * .03, .6 * .6 * 2.43, .6 * .59, .14};

double shownBy(double x) {
    const double up = (curve[0] * x + curve[1]) * x,
                 down = (curve[2] * x + curve[3]) * x + curve[4];
    return std::clamp(up / down, 0.0, 1.0);
}

/// What is shown as .85: there the reference's brightest and its middle pixel are put.
double brightestShown() {
    constexpr double shown = .85;
    const double a = curve[0] - shown * curve[2], b = curve[1] - shown * curve[3];
    const double c = -shown * curve[4];
    return (-b + std::sqrt(b * b - 4 * a * c)) / (2 * a);
}

struct Exposures {
    double first = 0, last = 0; ///< Powers of two.
    int count = 1;

    double at(int k) const {
        return std::exp2(count > 1 ? first + (last - first) * k / (count - 1) : first);
    }
};

/// From where the brightest pixel is not washed out to where half of them are.
Exposures exposuresFor(const Values &reference) {
    std::vector<double> luminances;
    for (const Triple &rgb : reference) {
        const double y = double(luminance(Color(rgb[0], rgb[1], rgb[2])));
        if (y > 0)
            luminances.push_back(y);
    }
    if (luminances.empty())
        return {};
    std::ranges::sort(luminances);
    const double middle = luminances[luminances.size() / 2], most = luminances.back();
    Exposures exposures{std::log2(brightestShown() / most), std::log2(brightestShown() / middle)};
    exposures.count = std::max(2, int(std::ceil(exposures.last - exposures.first)));
    return exposures;
}

Values exposedBy(const Values &light, double exposure) {
    Values result;
    for (const Triple &rgb : light) {
        Triple shown{};
        for (int c = 0; c < 3; ++c)
            shown[c] = float(shownBy(double(rgb[c]) * exposure));
        result.push_back(shown);
    }
    return result;
}

// ---- From pictures ----

std::optional<Values> valuesOf(const Picture &picture) {
    Values values(picture.window.pixels());
    for (int c = 0; c < 3; ++c) {
        const PictureChannel *channel = picture.find(std::string(1, "RGB"[c]));
        if (!channel)
            return std::nullopt;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const float value = channel->values[i];
            values[i][c] = std::isfinite(value) && value > 0 ? value : 0.0f;
        }
    }
    return values;
}

Values linearOf(Values values) {
    for (Triple &rgb : values)
        for (float &value : rgb)
            value = linearOfSrgb(std::min(value, 1.0f));
    return values;
}

} // namespace

std::optional<FlipMap> flipOf(const Picture &test, const Picture &reference,
                              double pixelsPerDegree) {
    const auto a = valuesOf(test), b = valuesOf(reference);
    if (!a || !b || a->size() != b->size() || a->empty())
        return std::nullopt;
    const Size size{reference.window.columns(), reference.window.rows()};
    FlipMap map;
    if (test.hasDisplayValues && reference.hasDisplayValues) {
        map.values = errorsOf(linearOf(*a), linearOf(*b), size, pixelsPerDegree);
    } else {
        const Exposures exposures = exposuresFor(*b);
        map.exposures = exposures.count;
        map.values.assign(a->size(), 0);
        for (int k = 0; k < exposures.count; ++k) {
            const std::vector<float> errors =
                errorsOf(exposedBy(*a, exposures.at(k)), exposedBy(*b, exposures.at(k)), size,
                         pixelsPerDegree);
            for (std::size_t i = 0; i < errors.size(); ++i)
                map.values[i] = std::max(map.values[i], errors[i]);
        }
    }
    for (float value : map.values)
        map.mean += double(value) / double(map.values.size());
    return map;
}

} // namespace candela

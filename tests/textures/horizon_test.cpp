// SPDX-License-Identifier: Apache-2.0
// A chequered plane to the horizon: where its pattern is finer than two pixels, 16 samples a pixel
// show it as thousands would, and would not without filtered lookups.
#include "tests/textures/pictures.h"

#include "image/picture_file.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

constexpr int columns = 192, rows = 96;
constexpr double focal = rows / 2; // In pixels; the view is 90 degrees high.
constexpr double period = 0.5;     // Of the pattern, metres; the eye is 1 m above the plane.

/// Rows below the horizon, counted from 0: the period across row k's middle, in pixels.
double periodAtRow(int k) {
    const double below = k + 0.5;
    return period * below * below / focal;
}

/// The pattern where a place of the picture shows it, x from the middle and y below the horizon.
double patternAt(double x, double y) {
    if (y <= 0)
        return 0;
    const double z = focal / y, across = x * z / focal;
    const auto half = [](double place) {
        const double share = place / period - std::floor(place / period);
        return share < 0.5;
    };
    return half(across) == half(z) ? 1 : 0;
}

/// The mean of the pattern from y to y + 1 at x, by where it changes.
double columnMean(double x, double y) {
    // Finer than the reference needs to know.
    const double grey = std::sqrt(0.01 * focal / period), top = std::max(y, grey);
    if (top >= y + 1)
        return 0.5;
    std::vector<double> places{top, y + 1};
    const auto addChanges = [&](double numerator) { // Where numerator / y is a half period.
        for (double k = std::ceil(std::abs(numerator) / (y + 1) / (period / 2));; ++k) {
            const double place = std::abs(numerator) / (k * period / 2);
            if (!(k > 0) || place >= y + 1)
                continue;
            if (place <= top)
                return;
            places.push_back(place);
        }
    };
    addChanges(focal);
    if (x != 0)
        addChanges(x);
    std::sort(places.begin(), places.end());
    double sum = (top - y) / 2;
    for (std::size_t k = 1; k < places.size(); ++k)
        sum += (places[k] - places[k - 1]) * patternAt(x, (places[k] + places[k - 1]) / 2);
    return sum;
}

/// The pixel's mean, of a box of one pixel.
double reference(int column, int row) {
    constexpr int n = 32;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        sum += columnMean(column - columns / 2 + (i + 0.5) / n, row);
    return sum / n;
}

/// The root mean square error of row k, in grey levels of 255.
double errorOfRow(const Picture &picture, int k) {
    const std::vector<float> &grey = picture.find("G")->values;
    double sum = 0;
    for (int x = 0; x < columns; ++x) {
        const double value = grey[std::size_t((rows / 2 + k) * columns + x)];
        sum += std::pow(value - reference(x, k), 2);
    }
    return 255 * std::sqrt(sum / columns);
}

Picture render(const ScratchFolder &folder, const std::string &options) {
    folder.write("plane.sl", "surface plane() { Oi = 1; Ci = color texture(\"checks.exr\", s, t" +
                                 options + "); }");
    const std::string scene = folder.write(
        "plane.rib",
        "Format 192 96 1 PixelSamples 4 4 PixelFilter \"box\" 1 1\n"
        "Display \"plane.exr\" \"openexr\" \"rgb\" Projection \"perspective\" \"fov\" 90\n"
        "WorldBegin Surface \"plane\"\n"
        "Patch \"bilinear\" \"P\" [-2000 -1 0.25  2000 -1 0.25  -2000 -1 4096.25  2000 -1 4096.25] "
        "\"varying float s\" [-4000 4000 -4000 4000] \"varying float t\" [.5 .5 8192.5 8192.5]\n"
        "WorldEnd\n");
    const Outcome run = runCandela({"--quiet", "--output-dir", folder.path(), scene});
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    return readPicture(folder.path("plane.exr"), problem).value_or(Picture{});
}

void writeChecks(const ScratchFolder &folder) {
    writeExr(folder, "checks.exr", 128, 128, {"R", "G", "B"},
             [](int x, int y, int) { return (x < 64) == (y < 64) ? 1.0f : 0.0f; });
}

TEST(Horizon, FilteredLookupsShowWhatManySamplesWould) {
    ScratchFolder folder;
    writeChecks(folder);
    const Picture filtered = render(folder, ""), raw = render(folder, ", \"width\", 0");
    ASSERT_TRUE(filtered.find("G") && raw.find("G"));
    double worstRaw = 0;
    int fine = 0;
    for (int k = 1; periodAtRow(k) < 2; ++k, ++fine) { // Row 0 shows where the plane ends.
        EXPECT_LE(errorOfRow(filtered, k), 4) << "row " << k << ", period " << periodAtRow(k);
        worstRaw = std::max(worstRaw, errorOfRow(raw, k));
    }
    EXPECT_GE(fine, 10);
    EXPECT_GT(worstRaw, 8) << "the test would not tell filtered lookups from others";
}

} // namespace
} // namespace candela::test

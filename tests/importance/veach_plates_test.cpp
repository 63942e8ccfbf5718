// SPDX-License-Identifier: Apache-2.0
// Veach's plates (VALIDATION G1): lamps of equal power and unequal size mirrored in plates of
// unequal gloss. Light samples and directions together have the mean of either and, in every
// plate x lamp cell, hardly more noise than the better one; one sample a pixel, so that no
// stratification helps either.
#include "foundation/base/student.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

using Point = std::array<double, 3>;

Point operator-(const Point &a, const Point &b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point &a, const Point &b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point along(const Point &from, double t, const Point &direction) {
    return {from[0] + t * direction[0], from[1] + t * direction[1], from[2] + t * direction[2]};
}
Point unit(const Point &a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}
Point cross(const Point &a, const Point &b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Lamp {
    double x, radius, radiance;
};
constexpr Lamp lamps[] = {
    {-3.75, .03333, 901.803}, {-1.25, .1, 100}, {1.25, .3, 11.1111}, {3.75, .9, 1.23457}};

/// From one edge to the other at x = -4 .. 4.
struct Plate {
    double y0, z0, y1, z1, exponent;
};
constexpr Plate plates[] = {{-2.70651, .25609, -2.08375, -.526323, 30000},
                            {-3.28825, 1.36972, -2.83856, .476536, 5000},
                            {-3.73096, 2.70046, -3.43378, 1.74564, 1500},
                            {-3.99615, 4.0667, -3.82069, 3.08221, 100}};
constexpr Point eye{0, 2, 15};

std::string text(double value) { return std::to_string(value) + " "; }

std::string array(const Point &right, const Point &up, const Point &ahead) {
    std::string matrix = "[";
    for (int axis = 0; axis < 3; ++axis)
        matrix += text(right[axis]) + text(up[axis]) + text(ahead[axis]) + "0 ";
    return matrix + text(-dot(eye, right)) + text(-dot(eye, up)) + text(-dot(eye, ahead)) + "1]";
}

/// A look at where the plate mirrors the lamp, wide enough for the highlight.
std::string camera(const Plate &plate, const Lamp &lamp) {
    const Point edge{0, plate.y0, plate.z0}, slope{0, plate.y1 - plate.y0, plate.z1 - plate.z0};
    const Point normal = unit({0, -slope[2], slope[1]});
    const Point image = along(eye, -2 * dot(eye - edge, normal), normal);
    const Point toLamp = Point{lamp.x, 0, 0} - image;
    const Point seen = along(image, dot(edge - image, normal) / dot(toLamp, normal), toLamp);
    const Point ahead = unit(seen - eye), right = unit(cross(ahead, {0, 1, 0}));
    const double reach = std::sqrt(dot(Point{lamp.x, 0, 0} - seen, Point{lamp.x, 0, 0} - seen));
    const double whole = reach + std::sqrt(dot(seen - eye, seen - eye));
    const double half = 1.2 * (lamp.radius + reach * std::sqrt(2 / plate.exponent)) / whole;
    const std::string w = text(std::min(half, .1));
    return "Format 64 64 1\nProjection \"perspective\" \"fov\" [90]\nScreenWindow -" + w + w + "-" +
           w + w + "\nConcatTransform " + array(right, cross(right, ahead), ahead) + "\n";
}

enum Strategy { Together, Lights, Directions };
constexpr const char *surfaces[] = {"Surface \"lobe\"",
                                    "Surface \"lobe\" \"string heard\" [\"lamps\"]",
                                    "Surface \"lobebydirections\""};

Frame cell(const Plate &plate, const Lamp &lamp, Strategy strategy) {
    const std::string r = text(lamp.radius);
    const std::string near = text(plate.y0) + text(plate.z0), far = text(plate.y1) + text(plate.z1);
    return {"", camera(plate, lamp),
            "AttributeBegin\nAreaLightSource \"lamp\" 1 \"float radiance\" [" +
                text(lamp.radiance) + "]\nSurface \"matte\" \"float Kd\" [0]\nTranslate " +
                text(lamp.x) + "0 0\nSphere " + r + "-" + r + r +
                "360\nAttributeEnd\nIlluminate 1 1\n" + surfaces[strategy] +
                " \"float exponent\" [" + text(plate.exponent) + "]\nPolygon \"P\" [-4 " + near +
                "4 " + near + "4 " + far + "-4 " + far + "]\n"};
}

/// Of the pixels of a cell, from two independent renders.
struct CellResult {
    double mean = 0, meanError = 0;
    MeanAndError variance; ///< Of a pixel; the mean over the pixels.
};

CellResult resultOf(const FramePixels &first, const FramePixels &second) {
    CellResult result;
    std::vector<double> variances;
    for (std::size_t i = 0; i < first.red.size(); ++i) {
        const double a = first.red[i], b = second.red[i];
        result.mean += (a + b) / 2 / double(first.red.size());
        variances.push_back((a - b) * (a - b) / 2);
    }
    result.variance = meanAndError(variances);
    result.meanError = std::sqrt(result.variance.mean / 2 / double(first.red.size()));
    return result;
}

TEST(VeachPlates, TogetherTheStrategiesAreNoWorseThanTheBetterOne) {
    std::vector<Frame> frames;
    for (const Plate &plate : plates)
        for (const Lamp &lamp : lamps)
            for (Strategy strategy : {Together, Lights, Directions})
                frames.push_back(cell(plate, lamp, strategy));
    const auto first = render(frames, {1, 1, "importance/shaders"});
    const auto second = render(frames, {1, 2, "importance/shaders"});
    ASSERT_EQ(first.size(), frames.size());
    ASSERT_EQ(second.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 3) {
        SCOPED_TRACE("plate " + std::to_string(i / 12 + 1) + ", lamp " +
                     std::to_string(i / 3 % 4 + 1));
        CellResult results[3];
        for (int strategy = 0; strategy < 3; ++strategy)
            results[strategy] = resultOf(first[i + strategy], second[i + strategy]);
        const auto &[together, lights, directions] = results;
        EXPECT_GT(together.mean, 1e-3);
        const CellResult *best = nullptr;
        for (const CellResult &alone : {std::cref(lights), std::cref(directions)}) {
            // One that has found next to nothing does not know its variance either.
            if (alone.mean < .8 * together.mean)
                continue;
            EXPECT_LE(std::abs(together.mean - alone.mean),
                      5 * std::hypot(together.meanError, alone.meanError));
            if (!best || alone.variance.mean < best->variance.mean)
                best = &alone;
        }
        ASSERT_TRUE(best);
        const double noise =
            std::hypot(together.variance.standardError, best->variance.standardError);
        EXPECT_LE(together.variance.mean, 1.1 * best->variance.mean + 2 * noise);
    }
}

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// Area lights in the units of RI are worth the mean over their positions: under both integrators,
// for whatever pieces they come in, and for a sphere as for what is nearly one.
#include "tests/support/frames.h"

#include <cmath>
#include <functional>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Lamp {
    const char *name, *surface, *shape;
    double expected;
};

struct Position {
    double x, y, z, nx, ny, nz;
};

/// The mean over positions(s, t), s and t in (0,1), of what they bring to a white plane at the
/// origin that faces -z.
double meanOver(const std::function<Position(double, double)> &positions) {
    constexpr int steps = 600;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            const Position p = positions((i + .5) / steps, (k + .5) / steps);
            const bool towards = p.x * p.nx + p.y * p.ny + p.z * p.nz < 0;
            sum += towards ? std::max(-p.z / std::hypot(p.x, p.y, p.z), 0.0) : 0;
        }
    return sum / steps / steps;
}

double ofSquare() {
    return meanOver([](double s, double t) { return Position{s - .5, t - .5, -1, 0, 0, 1}; });
}

double ofDisk(double radius) {
    return meanOver([=](double s, double t) {
        const double r = radius * std::sqrt(s);
        return Position{r * std::cos(2 * M_PI * t), r * std::sin(2 * M_PI * t), -1, 0, 0, 1};
    });
}

double ofSphere() {
    return meanOver([](double s, double t) {
        const double z = 2 * s - 1, r = std::sqrt(1 - z * z);
        const double x = r * std::cos(2 * M_PI * t), y = r * std::sin(2 * M_PI * t);
        return Position{x / 2, y / 2, z / 2 - 1, x, y, z};
    });
}

/// The box has a face to the plane, and sides that see it.
double ofBox() {
    const double face =
        meanOver([](double s, double t) { return Position{s - .5, t - .5, -1, 0, 0, 1}; });
    const double side =
        meanOver([](double s, double t) { return Position{.5, s - .5, -1 - t, 1, 0, 0}; });
    return (face + 4 * side) / 6;
}

const std::string square = "Polygon \"P\" [-.5 -.5 -1 .5 -.5 -1 .5 .5 -1 -.5 .5 -1]\n";

std::vector<Lamp> lamps() {
    const char *dark = "Surface \"matte\" \"Kd\" [0]\n",
               *shining = "Surface \"constant\"\nColor [1e-4 1e-4 1e-4]\n";
    return {
        {"square", dark, square.c_str(), ofSquare()},
        {"square that shines", shining, square.c_str(), ofSquare()},
        {"patch", dark, "Patch \"bilinear\" \"P\" [-.5 -.5 -1 .5 -.5 -1 -.5 .5 -1 .5 .5 -1]\n",
         ofSquare()},
        {"disk", dark, "Translate 0 0 -1 Disk 0 .05 360\n", ofDisk(.05)},
        {"wide disk", dark, "Translate 0 0 -1 Disk 0 1 360\n", ofDisk(1)},
        {"sphere", dark, "Translate 0 0 -1 Sphere .5 -.5 .5 360\n", ofSphere()},
        {"nearly a sphere", dark, "Translate 0 0 -1 Scale 1 1.0001 1 Sphere .5 -.5 .5 360\n",
         ofSphere()},
        {"box", dark,
         "Translate 0 0 -1.5 PointsPolygons [4 4 4 4 4 4] [0 3 2 1 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 "
         "6 3 0 4 7] \"P\" [-.5 -.5 -.5 .5 -.5 -.5 .5 .5 -.5 -.5 .5 -.5 -.5 -.5 .5 .5 -.5 .5 .5 "
         ".5 .5 -.5 .5 .5]\n",
         ofBox()}};
}

/// Beside another light, so that there is a choice.
TEST(ClassicAreaLamps, AreTheMeanOverTheirPositions) {
    const std::string view = "Option \"radiometry\" \"string units\" [\"classic\"]\n"
                             "Projection \"orthographic\"\nScreenWindow -.001 .001 -.001 .001\n"
                             "Translate 0 0 .25\n";
    const std::string plane = "Surface \"matte\" \"Ka\" [0] \"Kd\" [1]\nColor [1 1 1]\n"
                              "Patch \"bilinear\" \"P\" [-9 -9 0 9 -9 0 -9 9 0 9 9 0]\n";
    const std::string other = "LightSource \"distantlight\" 2 \"intensity\" [.5] \"from\" "
                              "[1.7320508 0 -1] \"to\" [0 0 0]\n"; // Past all lamps.
    std::vector<Frame> frames;
    std::vector<double> expected;
    for (const Lamp &lamp : lamps())
        for (const char *integrator : {"classic", "path"})
            for (bool alone : {true, false}) {
                frames.push_back({std::string(lamp.name) + ", " + integrator,
                                  "Option \"render\" \"string integrator\" [\"" +
                                      std::string(integrator) + "\"]\n" + view,
                                  (alone ? "" : other) + "AttributeBegin\n" +
                                      "AreaLightSource \"classic_lamp\" 1\n" + lamp.surface +
                                      lamp.shape + "AttributeEnd\nIlluminate 1 1\n" + plane});
                expected.push_back(lamp.expected + (alone ? 0 : .25));
            }
    const auto pictures = render(frames, {256, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const MeanAndError found = meanAndError({pictures[i].red.begin(), pictures[i].red.end()});
        EXPECT_LT(found.standardError, .02 * expected[i]) << frames[i].name;
        EXPECT_LT(std::fabs(found.mean - expected[i]),
                  studentQuantile(1e-5, 63) * found.standardError + 1e-3 * expected[i])
            << frames[i].name << ": " << found.mean << ", not " << expected[i];
    }
}

} // namespace
} // namespace candela::test

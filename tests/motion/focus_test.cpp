// SPDX-License-Identifier: Apache-2.0
// Depth of field: a lens sees each point as a circle of confusion, whose size optics tells.
#include "tests/motion/coverage.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

constexpr int samples = 256;

/// A square of half-width .4 about the axis at depth z.
std::string squareAtDepth(double z) {
    return "AttributeBegin\nTranslate 0 0 " + std::to_string(z) +
           "\nPolygon \"P\" [-.4 -.4 0 -.4 .4 0 .4 .4 0 .4 -.4 0]\nAttributeEnd\n";
}

struct Lens {
    const char *name;
    std::string request;
    double radius, focus; ///< Focal length over twice the f-stop, and what is sharp.
};

TEST(DepthOfField, BlursByTheCircleOfConfusion) {
    const Lens lenses[] = {
        {"wide", "DepthOfField 2 1 2\n", .25, 2},
        {"narrow", "DepthOfField 8 .8 1\n", .05, 1},
        {"far", "DepthOfField 1.4 .7 8\n", .25, 8},
        {"pinhole", "", 0, 1},
        {"off again", "DepthOfField 2 1 2\nDepthOfField\n", 0, 1},
        {"focused at infinity", "DepthOfField 2 .4 1e30\n", .1, 1e9},
    };
    const double depths[] = {.7, 2, 3};
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const Lens &lens : lenses)
            for (double z : depths)
                frames.push_back(
                    {std::string(integrator) + ", " + lens.name + ", at " + std::to_string(z),
                     "Option \"render\" \"string integrator\" \"" + std::string(integrator) +
                         "\"\nFormat 32 16 1\nProjection \"perspective\" \"fov\" 90\n"
                         "ScreenWindow -2 2 -1 1\n" +
                         lens.request,
                     "Surface \"glow\"\n" + squareAtDepth(z)});
    const auto pictures = render(frames, {samples, 1, "motion/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    std::size_t at = 0;
    for (int integrator = 0; integrator < 2; ++integrator)
        for (const Lens &lens : lenses)
            for (double z : depths) {
                SCOPED_TRACE(frames[at].name);
                // Points of the lens spiral outwards, each for as much of its area.
                expectCoverage(pictures[at++], samples, [&](double x, double y, double share) {
                    const double r = lens.radius * std::sqrt(share), turn = 2.399963 * 960 * share;
                    const double lx = r * std::cos(turn), ly = r * std::sin(turn);
                    const double u = lx + (x * lens.focus - lx) * z / lens.focus;
                    const double v = ly + (y * lens.focus - ly) * z / lens.focus;
                    return std::abs(u) < .4 && std::abs(v) < .4;
                });
            }
}

/// What moves before a lens is blurred by both.
TEST(DepthOfField, BlursWhatMoves) {
    const auto pictures =
        render({{"moving",
                 "Option \"render\" \"string integrator\" \"path\"\nShutter 0 1\nFormat 32 16 1\n"
                 "Projection \"perspective\" \"fov\" 90\nScreenWindow -2 2 -1 1\n"
                 "DepthOfField 2 1 2\n",
                 "Surface \"glow\"\nMotionBegin [0 1]\nTranslate -.5 0 0\nTranslate .5 0 0\n"
                 "MotionEnd\n" +
                     squareAtDepth(1)}},
               {samples, 1, "motion/shaders"});
    ASSERT_EQ(pictures.size(), 1u);
    expectCoverage(pictures[0], samples, [](double x, double y, double share) {
        // 32 moments, thirty points of the lens at each.
        const int number = int(share * 960), moment = number % 32, point = number / 32;
        const double r = .25 * std::sqrt((point + .5) / 30), turn = 2.399963 * point;
        const double lx = r * std::cos(turn), ly = r * std::sin(turn);
        const double u = lx + (2 * x - lx) / 2 - ((moment + .5) / 32 - .5);
        const double v = ly + (2 * y - ly) / 2;
        return std::abs(u) < .4 && std::abs(v) < .4;
    });
}

} // namespace

} // namespace candela::test

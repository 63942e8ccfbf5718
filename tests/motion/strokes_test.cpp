// SPDX-License-Identifier: Apache-2.0
// Curves and points that change their shape: what is covered for how long, by closed forms.
#include "tests/motion/coverage.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

namespace candela::test {

namespace {

constexpr int samples = 256;

struct Place {
    double x, y;
};

Place between(Place a, Place b, double share) {
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
}

/// The rectangle about the line from a to b, across which it is so wide.
bool isOnLine(Place a, Place b, double width, double x, double y) {
    const double dx = b.x - a.x, dy = b.y - a.y, size = std::hypot(dx, dy);
    const double along = ((x - a.x) * dx + (y - a.y) * dy) / size;
    const double across = ((x - a.x) * dy - (y - a.y) * dx) / size;
    return along > 0 && along < size && std::abs(across) < width / 2;
}

bool isOnDisk(Place a, double width, double x, double y) {
    return std::hypot(x - a.x, y - a.y) < width / 2;
}

/// What moves, and what it covers.
struct StrokeMotion {
    const char *name;
    std::string shutter, rib;
    Covers covers;
};

void PrintTo(const StrokeMotion &motion, std::ostream *stream) { *stream << motion.name; }

/// A line as a cubic: points of the curve go straight, and evenly.
const std::string cubicThatSwings =
    "MotionBegin [0 1]\n"
    "Curves \"cubic\" [4] \"nonperiodic\" \"P\" [-.5 -.5 0  -.5 -.1667 0  -.5 .1667 0  -.5 .5 0] "
    "\"constantwidth\" .2\n"
    "Curves \"cubic\" [4] \"nonperiodic\" \"P\" [-.5 -.5 0  .1667 -.3333 0  .8333 -.1667 0  1.5 0 "
    "0] "
    "\"constantwidth\" .2\nMotionEnd\n";

std::vector<StrokeMotion> strokeMotions() {
    const auto line = [](double x0, double y0, double x1, double y1, double width) {
        std::string text = "Curves \"linear\" [2] \"nonperiodic\" \"P\" [";
        for (double value : {x0, y0, 0.0, x1, y1, 0.0})
            text += std::to_string(value) + " ";
        return text + "] \"constantwidth\" " + std::to_string(width) + "\n";
    };
    return {
        {"LineThatGoes", "Shutter 0 1\n",
         "MotionBegin [0 1]\n" + line(-1.5, -.5, -1.5, .5, .2) + line(1.3, -.5, 1.3, .5, .2) +
             "MotionEnd\n",
         [](double x, double y, double s) {
             const double at = -1.5 + 2.8 * s;
             return isOnLine({at, -.5}, {at, .5}, .2, x, y);
         }},
        {"LineOfThreeTimes", "Shutter 0 1\n",
         "MotionBegin [0 .25 1]\n" + line(-1.5, -.5, -1.5, .5, .2) + line(0, -.5, 0, .5, .4) +
             line(.5, -.5, 1, .5, .1) + "MotionEnd\n",
         [](double x, double y, double s) {
             const double first = s / .25, second = (s - .25) / .75;
             const Place low = s < .25 ? between({-1.5, -.5}, {0, -.5}, first)
                                       : between({0, -.5}, {.5, -.5}, second);
             const Place high =
                 s < .25 ? between({-1.5, .5}, {0, .5}, first) : between({0, .5}, {1, .5}, second);
             return isOnLine(low, high, s < .25 ? .2 + .2 * first : .4 - .3 * second, x, y);
         }},
        {"ShutterWithin", "Shutter 2.25 2.75\n",
         "MotionBegin [2 3]\n" + line(-1.5, -.5, -1.5, .5, .2) + line(1.5, -.5, 1.5, .5, .2) +
             "MotionEnd\n",
         [](double x, double y, double s) {
             const double at = -.75 + 1.5 * s;
             return isOnLine({at, -.5}, {at, .5}, .2, x, y);
         }},
        {"ShutterShut", "Shutter 2.5 2.5\n",
         "MotionBegin [2 3]\n" + line(-1.5, -.5, -1.5, .5, .2) + line(1.5, -.5, 1.5, .5, .2) +
             "MotionEnd\n",
         [](double x, double y, double) {
             return isOnLine({0, -.5}, {0, .5}, .2, x, y);
         }},
        {"CubicThatSwings", "Shutter 0 1\n", cubicThatSwings,
         [](double x, double y, double s) {
             return isOnLine({-.5, -.5}, between({-.5, .5}, {1.5, 0}, s), .2, x, y);
         }},
        {"RibbonThatTurnsAway", "Shutter 0 1\n",
         "MotionBegin [0 1]\n"
         "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1.5 0 0 1.5 0 0] \"constantwidth\" 1 "
         "\"uniform normal N\" [0 0 -1]\n"
         "Curves \"linear\" [2] \"nonperiodic\" \"P\" [-1.5 0 0 1.5 0 0] \"constantwidth\" 1 "
         "\"uniform normal N\" [0 1 -1]\nMotionEnd\n",
         [](double x, double y, double s) {
             return std::abs(x) < 1.5 && std::abs(y) < .5 / std::hypot(1, s);
         }},
        {"PointsThatPart", "Shutter 0 1\n",
         "MotionBegin [0 1]\nPoints \"P\" [0 0 0 0 0 0] \"width\" [.4 .8]\n"
         "Points \"P\" [-1.2 0 0 1 .4 0] \"width\" [.8 .4]\nMotionEnd\n",
         [](double x, double y, double s) {
             return isOnDisk({-1.2 * s, 0}, .4 + .4 * s, x, y) ||
                    isOnDisk({s, .4 * s}, .8 - .4 * s, x, y);
         }},
    };
}

struct Company {
    const char *name, *before, *after;
};

/// What leaves the picture as it is. Where depth alone is stretched, rays meet triangles.
constexpr Company companies[] = {
    {"", "", ""},
    {"mirrored", "Scale 1 1 -1\n", ""},
    {"one-sided", "Sides 1\n", ""},
    {"one-sided and mirrored", "Sides 1\nScale 1 1 -1\nReverseOrientation\n", ""},
    {"as triangles", "Scale 1 1 3\n", ""},
    {"scaled", "Scale 1e-3 1e-3 1e-3\nScale 1e3 1e3 1e3\n", ""},
    {"far from the origin", "Translate -1000 300 50\nTranslate 1000 -300 -50\n", ""},
    {"an object", "ObjectBegin 1\n", "ObjectEnd\nObjectInstance 1\n"},
    {"one of two instances", "ObjectBegin 1\n",
     "ObjectEnd\nObjectInstance 1\nTranslate 0 9 0\nObjectInstance 1\n"},
    {"in a space that moves", "MotionBegin [0 3]\nTranslate 0 0 0\nTranslate 0 0 1\nMotionEnd\n",
     ""},
    {"instances that move", "ObjectBegin 1\n",
     "ObjectEnd\nMotionBegin [0 3]\nTranslate 0 0 0\nTranslate 0 0 1\nMotionEnd\n"
     "ObjectInstance 1\nTranslate 0 9 0\nObjectInstance 1\n"},
};

class MovingStrokes : public testing::TestWithParam<StrokeMotion> {};

TEST_P(MovingStrokes, CoverWhatTheyPass) {
    const StrokeMotion &motion = GetParam();
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const Company &company : companies)
            frames.push_back({std::string(integrator) + " " + company.name,
                              "Option \"render\" \"string integrator\" \"" +
                                  std::string(integrator) + "\"\n" + motion.shutter + coverageView,
                              "Surface \"matte\"\nTranslate 0 0 5\n" + std::string(company.before) +
                                  motion.rib + company.after});
    auto pictures = render(frames, {samples, 1, "motion/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        SCOPED_TRACE(frames[k].name);
        pictures[k].red = pictures[k].alpha; // What shines would keep its shape.
        expectCoverage(pictures[k], samples, motion.covers);
    }
}

INSTANTIATE_TEST_SUITE_P(, MovingStrokes, testing::ValuesIn(strokeMotions()),
                         [](const auto &param) { return std::string(param.param.name); });

} // namespace

} // namespace candela::test

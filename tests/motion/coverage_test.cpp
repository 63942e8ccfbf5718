// SPDX-License-Identifier: Apache-2.0
// Transformations that move: what is covered for how long.
#include "tests/motion/coverage.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

namespace candela::test {

namespace {

constexpr int samples = 256;

/// What a bar from (-.5,-.25) to (.5,.25) does, and where a point of the picture is in its space.
struct Motion {
    const char *name;
    std::string shutter, block;
    std::function<void(double share, double &x, double &y)> toBar;
};

void PrintTo(const Motion &motion, std::ostream *stream) { *stream << motion.name; }

std::function<void(double, double &, double &)> along(std::function<double(double)> place) {
    return [place](double share, double &x, double &) { x -= place(share); };
}

std::function<void(double, double &, double &)> turned(double from, double to) {
    return [=](double share, double &x, double &y) {
        const double angle = (from + share * (to - from)) * M_PI / 180;
        const double u = x * std::cos(angle) + y * std::sin(angle);
        y = y * std::cos(angle) - x * std::sin(angle), x = u;
    };
}

const char halfTurn[] = "ConcatTransform [0 1 0 0 -1 0 0 0 0 0 1 0 0 0 0 1]\n";

std::vector<Motion> motions() {
    return {
        {"Translate", "Shutter 0 1\n",
         "MotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n",
         along([](double s) { return 2 * s - 1; })},
        {"ThreeTimesAtTwoPaces", "Shutter 0 1\n",
         "MotionBegin [0 .25 1]\nTranslate -1 0 0\nTranslate 0 0 0\nTranslate .5 0 0\nMotionEnd\n",
         along([](double s) { return s < .25 ? 4 * s - 1 : (s - .25) / 1.5; })},
        {"ShutterWithin", "Shutter 2.25 2.75\n",
         "MotionBegin [2 3]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n",
         along([](double s) { return s - .5; })},
        {"ShutterBeyond", "Shutter -1 3\n",
         "MotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n",
         along([](double s) { return std::clamp(8 * s - 3, -1.0, 1.0); })},
        {"ShutterBefore", "Shutter 0 .5\n",
         "MotionBegin [1 2]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n",
         along([](double) { return -1; })},
        {"ShutterShut", "Shutter .25 .25\n",
         "MotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\n",
         along([](double) { return -.5; })},
        {"QuarterTurn", "Shutter 0 1\n",
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 90 0 0 1\nMotionEnd\n", turned(0, 90)},
        {"TurnAndAHalf", "Shutter 0 1\n",
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 540 0 0 1\nMotionEnd\n", turned(0, 540)},
        {"FourWholeTurns", "Shutter 0 1\n",
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 1440 0 0 1\nMotionEnd\n", turned(0, 1440)},
        {"TwoTurnsInTwo", "Shutter 0 1\n",
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 720 0 0 1\nMotionEnd\n"
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 720 0 0 1\nMotionEnd\n",
         turned(0, 1440)},
        {"AboutTheOppositeAxis", "Shutter 0 1\n",
         "MotionBegin [0 1]\nRotate 30 0 0 1\nRotate 30 0 0 -1\nMotionEnd\n", turned(30, -30)},
        {"MatricesTurn", "Shutter 0 1\n",
         std::string("MotionBegin [0 1]\nConcatTransform [1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1]\n") +
             halfTurn + "MotionEnd\n",
         turned(0, 90)},
        {"Scale", "Shutter 0 1\n", "MotionBegin [0 1]\nScale 1 1 1\nScale 3 .5 1\nMotionEnd\n",
         [](double s, double &x, double &y) { x /= 1 + 2 * s, y /= 1 - .5 * s; }},
        {"Skew", "Shutter 0 1\n",
         "MotionBegin [0 1]\nSkew 0 0 1 0 1 0 0\nSkew 60 0 1 0 1 0 0\nMotionEnd\n",
         [](double s, double &x, double &y) { x -= y * std::tan(s * M_PI / 3); }},
        {"BlockInBlock", "Shutter 0 1\n",
         "MotionBegin [0 1]\nTranslate -1 0 0\nTranslate 1 0 0\nMotionEnd\nRotate 10 0 0 1\n"
         "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 180 0 0 1\nMotionEnd\n",
         [](double s, double &x, double &y) {
             x -= 2 * s - 1;
             turned(10, 190)(s, x, y);
         }},
    };
}

const char bar[] = "Polygon \"P\" [-.5 -.25 0 -.5 .25 0 .5 .25 0 .5 -.25 0]\n";

/// The same thing declared otherwise: around what moves stands still `around`.
struct Company {
    const char *name;
    std::function<std::string(const std::string &block)> world;
};

std::vector<Company> companies() {
    const auto object = [](const std::string &inside, const std::string &outside) {
        return "ObjectBegin 1\n" + inside + bar + "ObjectEnd\n" + outside + "ObjectInstance 1\n";
    };
    const auto twice = [](const std::string &inside, const std::string &outside) {
        return "ObjectBegin 1\n" + inside + bar +
               "ObjectEnd\nAttributeBegin\nTranslate 0 9 0\n"
               "ObjectInstance 1\nAttributeEnd\n" +
               outside + "ObjectInstance 1\n";
    };
    return {
        {"", [](const std::string &block) { return "Translate 0 0 5\n" + block + bar; }},
        {"scaled",
         [](const std::string &block) {
             return "Translate 0 0 5\nScale 1e3 1e3 1e3\nScale 1e-3 1e-3 1e-3\n" + block +
                    "Scale 2 2 2\nScale .5 .5 .5\n" + bar;
         }},
        {"mirrored inside",
         [](const std::string &block) {
             return "Translate 0 0 5\n" + block + "Scale -1 1 1\n" + bar;
         }},
        {"mirrored around",
         [](const std::string &block) { return "Translate 0 0 5\nScale 1 1 -1\n" + block + bar; }},
        {"one-sided",
         [](const std::string &block) { return "Sides 1\nTranslate 0 0 5\n" + block + bar; }},
        {"one-sided and mirrored",
         [](const std::string &block) {
             return "Sides 1\nTranslate 0 0 5\nScale 1 1 -1\nReverseOrientation\n" + block + bar;
         }},
        {"moving object",
         [=](const std::string &block) { return object("", "Translate 0 0 5\n" + block); }},
        {"within an object",
         [=](const std::string &block) { return object(block, "Translate 0 0 5\n"); }},
        {"moving object, twice",
         [=](const std::string &block) { return twice("", "Translate 0 0 5\n" + block); }},
        {"within an object, twice",
         [=](const std::string &block) { return twice(block, "Translate 0 0 5\n"); }},
        {"one-sided within an object, twice",
         [=](const std::string &block) { return "Sides 1\n" + twice(block, "Translate 0 0 5\n"); }},
    };
}

class MovingBar : public testing::TestWithParam<Motion> {};

TEST_P(MovingBar, CoversWhatItPasses) {
    const Motion &motion = GetParam();
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const Company &company : companies())
            frames.push_back({std::string(integrator) + " " + company.name,
                              "Option \"render\" \"string integrator\" \"" +
                                  std::string(integrator) + "\"\n" + motion.shutter + coverageView,
                              "Surface \"glow\"\n" + company.world(motion.block)});
    const auto pictures = render(frames, {samples, 1, "motion/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t k = 0; k < frames.size(); ++k) {
        SCOPED_TRACE(frames[k].name);
        expectCoverage(pictures[k], samples, [&](double x, double y, double share) {
            motion.toBar(share, x, y);
            return std::abs(x) < .5 && std::abs(y) < .25;
        });
    }
}

INSTANTIATE_TEST_SUITE_P(, MovingBar, testing::ValuesIn(motions()),
                         [](const auto &param) { return std::string(param.param.name); });

/// A camera that moves sees what a world that moves the other way shows.
TEST(MovingCamera, SeesTheWorldMoveTheOtherWay) {
    struct Way {
        const char *name, *camera, *world;
    };
    const Way ways[] = {
        {"along", "MotionBegin [0 1]\nTranslate 0 0 5\nTranslate 1 .5 4\nMotionEnd\n", ""},
        {"turning",
         "Translate 0 0 5\nMotionBegin [0 1]\nRotate -20 0 1 0\nRotate 20 0 1 0\n"
         "MotionEnd\n",
         ""},
        {"rolling",
         "Translate 0 0 5\nMotionBegin [0 1]\nRotate 0 0 0 1\nRotate 90 0 0 1\n"
         "MotionEnd\n",
         ""},
        {"beside what moves", "MotionBegin [0 1]\nTranslate 0 0 5\nTranslate 1 .5 4\nMotionEnd\n",
         "MotionBegin [0 1]\nTranslate 0 0 0\nTranslate -1 -.5 0\nMotionEnd\n"},
    };
    const std::string things =
        "Surface \"matte\"\nSphere .7 -.7 .7 360\nTranslate 1 0 1\nColor [.5 .5 .5]\n"
        "Cylinder .5 -1 1 360\n";
    const std::string light = "LightSource \"pointlight\" 1 \"intensity\" 40 \"from\" [-3 3 -4]\n";
    for (const char *integrator : {"classic", "path"})
        for (const Way &way : ways) {
            SCOPED_TRACE(std::string(integrator) + " " + way.name);
            const std::string options = "Option \"render\" \"string integrator\" \"" +
                                        std::string(integrator) +
                                        "\"\nShutter 0 1\nFormat 32 32 1\nProjection "
                                        "\"perspective\" \"fov\" 40\n";
            const auto pictures =
                render({{"camera", options + way.camera, light + way.world + things},
                        {"world", options, way.camera + light + way.world + things}},
                       {64, 1, "motion/shaders"});
            ASSERT_EQ(pictures.size(), 2u);
            // The same samples at the same times; only edges may fall to another side.
            double sum = 0, difference = 0;
            for (std::size_t k = 0; k < pictures[0].red.size(); ++k) {
                sum += pictures[0].red[k];
                difference += std::abs(pictures[0].red[k] - pictures[1].red[k]);
                EXPECT_NEAR(pictures[0].alpha[k], pictures[1].alpha[k], 3 / 64.) << k;
            }
            EXPECT_GT(sum, 10);
            EXPECT_LT(difference, .01 * sum);
        }
}

/// Times are spread over the interval, and "time" tells them.
TEST(ShutterTimes, AreWhatShadersSee) {
    const auto pictures = render(
        {{"interval",
          "Option \"render\" \"string integrator\" \"path\"\nShutter 2 4\n" + coverageView,
          "Surface \"moment\"\nTranslate 0 0 5\nPolygon \"P\" [-9 -9 0 -9 9 0 9 9 0 9 -9 0]\n"},
         {"instant",
          "Option \"render\" \"string integrator\" \"path\"\nShutter 3 3\n" + coverageView,
          "Surface \"moment\"\nTranslate 0 0 5\nPolygon \"P\" [-9 -9 0 -9 9 0 9 9 0 9 -9 0]\n"}},
        {64, 1, "motion/shaders"});
    ASSERT_EQ(pictures.size(), 2u);
    for (float red : pictures[0].red)
        EXPECT_NEAR(red, 3, 2. / 64);
    for (float red : pictures[1].red)
        EXPECT_EQ(red, 3);
}

} // namespace

} // namespace candela::test

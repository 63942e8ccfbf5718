// SPDX-License-Identifier: Apache-2.0
#include "tests/motion/stills.h"

#include "tests/support/frames.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {

static std::string numbersOf(std::initializer_list<double> numbers) {
    std::ostringstream text;
    text.precision(9);
    for (double number : numbers)
        text << ' ' << number;
    return text.str();
}

std::string request(const std::string &name, std::initializer_list<double> numbers) {
    return name + numbersOf(numbers) + "\n";
}

std::string array(std::initializer_list<double> numbers) { return "[" + numbersOf(numbers) + "]"; }

static std::string withInPlace(std::string world, const std::string &text) {
    for (std::size_t at; (at = world.find("@\n")) != std::string::npos;)
        world.replace(at, 2, text);
    return world;
}

/// A quarter of a picture of 8 x 8 pixels.
static FramePixels quarterOf(const FramePixels &picture, int quarter) {
    FramePixels part;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            part.red.push_back(
                picture.red[std::size_t(8 * (row + quarter / 2 * 4) + column + quarter % 2 * 4)]);
    return part;
}

void expectMeanOfStills(const std::string &integrator, const std::string &world,
                        const std::function<std::string(double share)> &at) {
    constexpr int moments = 24, samples = 16;
    const std::string options =
        "Option \"render\" \"string integrator\" \"" + integrator +
        "\"\nShutter 0 1\nProjection \"orthographic\"\nScreenWindow -1 1 -1 1\n";
    std::vector<Frame> stills;
    for (int moment = 0; moment < moments; ++moment)
        stills.push_back({"still", options, withInPlace(world, at((moment + .5) / moments))});
    const std::string motion = "MotionBegin [0 1]\n" + at(0) + at(1) + "MotionEnd\n";
    const auto each = render(stills, {samples, 1, "motion/shaders"});
    const auto moving = render({{"moving", options, withInPlace(world, motion)}},
                               {samples * moments, 2, "motion/shaders"});
    ASSERT_EQ(each.size(), stills.size());
    ASSERT_EQ(moving.size(), 1u);
    FramePixels mean = each.front();
    for (std::size_t k = 0; k < mean.red.size(); ++k) {
        mean.red[k] = 0;
        for (const FramePixels &still : each)
            mean.red[k] += still.red[k] / moments;
    }
    const RedComparison found = compareRed(moving.front(), mean);
    EXPECT_GT(found.mean, .01);
    // The mean over moments is that of an integral by its midpoints.
    EXPECT_NEAR(found.difference.mean, 0, 4 * found.difference.standardError + .003 * found.mean);
    for (int quarter = 0; quarter < 4; ++quarter) {
        SCOPED_TRACE("quarter " + std::to_string(quarter));
        const RedComparison part =
            compareRed(quarterOf(moving.front(), quarter), quarterOf(mean, quarter));
        EXPECT_NEAR(part.difference.mean, 0, 6 * part.difference.standardError + .01 * found.mean);
    }
}

} // namespace candela::test

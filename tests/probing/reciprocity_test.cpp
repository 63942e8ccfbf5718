// SPDX-License-Identifier: Apache-2.0
// Lamp and sensor change places: what a square lamp sends to a square sensor by way of surfaces is
// what it gets in return, whatever these surfaces are, as long as they obey reciprocity themselves.
#include "tests/probing/probing.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {
namespace {

/// A square that looks down, turned about z.
struct Square {
    double x, y, z, half, turn;

    double area() const { return 4 * half * half; }
    /// A place on it, both in [-1,1].
    std::array<double, 3> at(double a, double b) const {
        const double along = half * a;
        return {x + along * std::cos(turn), y + along * std::sin(turn), z + half * b};
    }
    std::array<double, 3> normal() const { return {std::sin(turn), -std::cos(turn), 0}; }
    std::string polygon() const {
        std::ostringstream text;
        text.precision(9);
        text << "Polygon \"P\" [";
        for (const auto &[a, b] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
            for (double c : at(a, b))
                text << c << ' ';
        text << "]\n";
        return text.str();
    }
};

constexpr Square left{-.7, 1.1, .1, .15, .5}, right{.6, 1.3, -.3, .08, -.4};

struct Company {
    const char *name, *surface;
    const char *space = ""; ///< Before the world.
};

void PrintTo(const Company &company, std::ostream *stream) { *stream << company.name; }

constexpr Company companies[] = {
    {"Matte", "Surface \"matte\" \"Ka\" [0] \"Kd\" [.8]\n"},
    {"Mirror", "Surface \"mirror\" \"Kr\" [.9]\n"},
    {"RoughMetal", "Surface \"roughmetal\" \"alpha\" [.3]\n"},
    {"Glass", "Surface \"glass\"\n"},
    {"HalfOpaque", "Opacity [.4 .4 .4]\nSurface \"matte\" \"Ka\" [0] \"Kd\" [.8]\n"},
    {"RoughMetalMirrored", "Surface \"roughmetal\" \"alpha\" [.3]\n", "Scale -1 1 1\n"},
};

/// Lux times square metres that arrive on `to`, and their standard error.
std::pair<double, double> flux(const Company &company, const Square &from, const Square &to,
                               const std::string &integrator) {
    const std::string world =
        siWorld(lamp(from.polygon()) + "AttributeBegin\nSurface \"matte\" \"Kd\" " +
                    "[0] \"Ka\" [0]\n" + to.polygon() + "AttributeEnd\nAttributeBegin\n" +
                    "Surface \"matte\" \"Ka\" [0] \"Kd\" [.6]\n" +
                    "Polygon \"P\" [-2 0 -2 -2 0 2 2 0 2 2 0 -2]\nAttributeEnd\n" +
                    company.surface + "Translate .1 .5 0\nSphere .4 -.4 .4 360\n",
                company.space);
    std::ostringstream points;
    points.precision(9); // On the polygon, not behind it.
    constexpr int side = 4;
    for (int i = 0; i < side * side; ++i) {
        for (double c : to.at((i % side + .5) * 2 / side - 1, (i / side + .5) * 2 / side - 1))
            points << c << ' ';
        for (double c : to.normal())
            points << c << ' ';
        points << '\n';
    }
    const Probed probed = probe(world, points.str(), {"--integrator", integrator, "--spp", "4096"});
    EXPECT_EQ(probed.run.status, 0) << probed.run.text();
    EXPECT_EQ(probed.answers.size(), std::size_t(side * side));
    double sum = 0, squares = 0;
    for (const Answer &answer : probed.answers)
        sum += answer.photometric, squares += answer.halfWidth * answer.halfWidth;
    constexpr double halfWidthOfError = 2.13; // Student's t of 16 batches.
    const double share = to.area() / (side * side);
    return {sum * share, std::sqrt(squares) * share / halfWidthOfError};
}

class LampAndSensor : public testing::TestWithParam<Company> {};

TEST_P(LampAndSensor, MayChangePlaces) {
    for (const char *integrator : {"path", "bidir"}) {
        const auto [there, error] = flux(GetParam(), left, right, integrator);
        const auto [back, errorBack] = flux(GetParam(), right, left, integrator);
        EXPECT_GT(there, 0);
        // Midpoints of 16 cells: the light over the squares is smooth.
        EXPECT_NEAR(there, back, 4.5 * std::hypot(error, errorBack) + .004 * there) << integrator;
        EXPECT_LT(std::hypot(error, errorBack), .08 * there) << integrator; // Caustics are noise.
    }
}

INSTANTIATE_TEST_SUITE_P(All, LampAndSensor, testing::ValuesIn(companies),
                         [](const auto &info) { return std::string(info.param.name); });

} // namespace
} // namespace candela::test

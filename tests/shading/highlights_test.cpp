// SPDX-License-Identifier: Apache-2.0
// specular() has the exponent 8/roughness, by option RI's 1/roughness.
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

/// A square seen along its normal, lit from 40 degrees beside it: N.H is the cosine of 20.
Frame highlight(const std::string &name, const std::string &integrator, const std::string &option) {
    const double angle = 40 * M_PI / 180;
    return {name,
            "Option \"render\" \"string integrator\" [\"" + integrator +
                "\"]\nFormat 4 4 1\nProjection \"orthographic\"\n" + option,
            "Attribute \"light\" \"string units\" [\"classic\"]\n"
            "LightSource \"distantlight\" 1 \"point from\" [" +
                std::to_string(std::sin(angle)) + " 0 " + std::to_string(-std::cos(angle)) +
                "] \"point to\" [0 0 0]\n"
                "Surface \"highlight\" \"float roughness\" [.5]\n"
                "Polygon \"P\" [-2 -2 1 -2 2 1 2 2 1 2 -2 1]\n"};
}

TEST(Highlights, AreAsWideAsProductionRenderersHaveThemOrAsRiSays) {
    const struct {
        const char *option;
        double exponent;
    } cases[] = {{"", 16},
                 {"Option \"shading\" \"highlights\" \"production\"\n", 16},
                 {"Option \"shading\" \"highlights\" \"ri\"\n", 2}};
    std::vector<Frame> frames;
    for (const auto &[option, exponent] : cases)
        for (const char *integrator : {"path", "classic"})
            frames.push_back(highlight("f" + std::to_string(frames.size()), integrator, option));
    const std::vector<FramePixels> pictures = render(frames, {4, 1, "shading/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (float red : pictures[i].red)
            EXPECT_NEAR(red, std::pow(std::cos(20 * M_PI / 180), cases[i / 2].exponent), 1e-4);
}

} // namespace
} // namespace candela::test

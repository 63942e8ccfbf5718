// SPDX-License-Identifier: Apache-2.0
#include "tests/volumes/worlds.h"

#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {

namespace {

constexpr const char *shaders = "volumes/shaders";

Frame frameOf(const World &world, const std::string &integrator) {
    return {world.name + ", " + integrator,
            "Option \"render\" \"string integrator\" [\"" + integrator +
                "\"]\nProjection \"orthographic\"\nScreenWindow -.1 .1 -.1 .1\n" + world.options,
            world.rib};
}

} // namespace

void expectEach(const std::vector<World> &worlds, double tolerance, int samples) {
    std::vector<Frame> frames;
    std::vector<const World *> of;
    for (const World &world : worlds)
        for (const auto &[by, integrator] : {std::pair{By::Classic, "classic"}, {By::Path, "path"}})
            if (world.by == By::Both || world.by == by) {
                frames.push_back(frameOf(world, integrator));
                of.push_back(&world);
            }
    const std::vector<FramePixels> pictures = render(frames, {samples, 1, shaders});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < pictures.size(); ++i)
        for (std::size_t pixel = 0; pixel < pictures[i].red.size(); ++pixel) {
            ASSERT_NEAR(pictures[i].red[pixel], of[i]->red, tolerance * (1 + std::fabs(of[i]->red)))
                << frames[i].name << ", pixel " << pixel;
            ASSERT_NEAR(pictures[i].alpha[pixel], of[i]->alpha, tolerance * 2)
                << frames[i].name << ", pixel " << pixel;
        }
}

std::vector<double> meansOf(const World &world, const std::string &integrator, int seeds,
                            int samples) {
    std::vector<double> means;
    for (int seed = 1; seed <= seeds; ++seed) {
        const auto pictures = render({frameOf(world, integrator)}, {samples, seed, shaders});
        if (pictures.empty())
            return {};
        double sum = 0;
        for (const float red : pictures[0].red)
            sum += red;
        means.push_back(sum / double(pictures[0].red.size()));
    }
    return means;
}

std::string text(double value) {
    std::ostringstream stream;
    stream.precision(9);
    stream << value;
    return stream.str();
}

std::string square(double z, const std::string &words, bool turned) {
    const std::string at = " " + text(z) + " ";
    return "AttributeBegin\n" + words + (turned ? "ReverseOrientation\n" : "") +
           "Polygon \"P\" [-1 -1" + at + "-1 1" + at + "1 1" + at + "1 -1" + at +
           "]\nAttributeEnd\n";
}

std::string sheet(double z, double color, double opacity) {
    const std::string o = text(opacity);
    return square(z, "Surface \"constant\"\nColor [" + text(color) + " 0 0]\nOpacity [" + o + " " +
                         o + " " + o + "]\n");
}

std::string fogOf(double distance, double background) {
    return "Atmosphere \"fog\" \"float distance\" [" + text(distance) + "] \"color background\" [" +
           text(background) + " 0 0]\n";
}

} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// Channels that the first hit tells, whatever its shader reads.
#include "tests/between_shaders/shown.h"

namespace candela::test {

namespace {

const std::string channels = "Display \"c.exr\" \"openexr\" \"u,v,s,t,Cs,Os,N\"\n";

struct Place {
    const char *before, *after;
};

} // namespace

TEST_F(Shown, firstHitsTellWhatTheirShaderDoesNotRead) {
    const Place places[] = {{"", ""},
                            {"ObjectBegin 1\n", "ObjectEnd\nSurface \"mute\"\nObjectInstance 1\n"}};
    for (const char *integrator : {"classic", "path"})
        for (const Place &place : places) {
            render(
                smallView(channels) +
                    "WorldBegin\nColor .1 .2 .3\nOpacity .4 .5 .6\nSurface \"mute\"\n" +
                    place.before +
                    "Patch \"bilinear\" \"P\" [-1 1 1  1 1 1  -1 0 1  1 0 1] \"s\" [0 2 0 2] \"t\" "
                    "[0 0 3 3] \"Cs\" [.5 .5 .5 .5 .5 .5 .25 .25 .25 .25 .25 .25]\n"
                    "Patch \"bilinear\" \"P\" [-1 0 1  1 0 1  -1 -1 1  1 -1 1]\n" +
                    place.after + "WorldEnd\n",
                {"--integrator", integrator});
            const std::vector<float> u = plane("c.exr", "u"), v = plane("c.exr", "v");
            const std::vector<float> s = plane("c.exr", "s"), t = plane("c.exr", "t");
            const std::vector<float> green = plane("c.exr", "Cs.G"), Os = plane("c.exr", "Os.B");
            for (int y = 0; y < 8; ++y)
                for (int x = 0; x < 8; ++x) {
                    const auto at = std::size_t(8 * y + x);
                    const float across = (float(x) + .5f) / 8, down = (float(y % 4) + .5f) / 4;
                    const bool upper = y < 4;
                    ASSERT_NEAR(u[at], across, .07f) << integrator << place.before;
                    ASSERT_NEAR(v[at], down, .13f) << integrator << place.before;
                    ASSERT_NEAR(s[at], upper ? 2 * u[at] : u[at], 1e-5f) << integrator;
                    ASSERT_NEAR(t[at], upper ? 3 * v[at] : v[at], 1e-5f) << integrator;
                    ASSERT_NEAR(green[at], upper ? .5f - .25f * v[at] : .2f, 1e-5f) << integrator;
                    ASSERT_NEAR(Os[at], .6f, 1e-6f) << integrator;
                }
        }
}

/// A surface that moves its points has the normal that its shader works with: that of the points
/// as they have come to stand, if it sets N.
TEST_F(Shown, movedSurfacesTellTheirNormals) {
    const Place places[] = {{"", ""},
                            {"ReverseOrientation\n", ""},
                            {"ObjectBegin 1\n", "ObjectEnd\nObjectInstance 1\n"}};
    for (const char *integrator : {"classic", "path"})
        for (const char *shader : {"slope", "slope_told"})
            for (const Place &place : places) {
                render(smallView(channels) + "WorldBegin\nSurface \"" + shader + "\"\n" +
                           place.before + squareAt("1") + place.after + "WorldEnd\n",
                       {"--integrator", integrator});
                const std::vector<float> x = plane("c.exr", "N.X"), z = plane("c.exr", "N.Z");
                const float slope = std::string(shader) == "slope" ? -.5f : 0;
                for (std::size_t i = 0; i < x.size(); ++i)
                    ASSERT_NEAR(x[i] / z[i], slope, 1e-4f) << shader << integrator << place.before;
            }
}

} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// `candela probe --integrator bidir`: the same light as `path`, with less noise where lamps are
// hard to find.
#include "tests/probing/probing.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// A room with a lamp in a tube that is open at its ends.
std::string tube() {
    return siWorld(
        "AreaLightSource \"arealight\" 1 \"radiance\" [100]\nSurface \"matte\" \"Ka\" [0] \"Kd\" "
        "[0]\nAttributeBegin\nTranslate 0 .6 0\nRotate 90 0 1 0\nCylinder .04 -.3 .3 360\n"
        "AttributeEnd\nAreaLightSource \"null\" 2\nIlluminate 1 1\n"
        "Surface \"matte\" \"Ka\" [0] \"Kd\" [.7]\nReverseOrientation\nSphere 1.5 -1.5 1.5 360\n"
        "AttributeBegin\nTranslate 0 .6 0\nRotate 90 0 1 0\nCylinder .1 -.35 .35 360\n"
        "AttributeEnd\n");
}

const std::string points = "0 -1 0 0 1 0\n.5 -.6 .5 0 1 0\n0 0 0 0 1 0\n.2 .1 -.3 1 0 1\n";

} // namespace

TEST(BothEnds, FindTheSameLight) {
    for (const char *quantity : {"--irradiance", "--radiance"}) {
        const Probed path =
            probe(tube(), points, {quantity, "--spp", "65536", "--integrator", "path"});
        const Probed bidir =
            probe(tube(), points, {quantity, "--spp", "16384", "--integrator", "bidir"});
        ASSERT_EQ(path.answers.size(), 4u) << path.run.text();
        ASSERT_EQ(bidir.answers.size(), 4u) << bidir.run.text();
        for (std::size_t k = 0; k < 4; ++k) {
            const Answer &a = path.answers[k], &b = bidir.answers[k];
            // Half widths are 2.1 standard errors; of eight comparisons one fails in 1e4 runs.
            EXPECT_NEAR(a.photometric, b.photometric, 2.8 * std::hypot(a.halfWidth, b.halfWidth))
                << quantity << " " << k;
            EXPECT_GT(b.photometric, 0);
            EXPECT_LT(b.halfWidth, a.halfWidth) << quantity << " " << k;
        }
    }
}

TEST(BothEnds, AnswerAlikeForAnyThreads) {
    const auto answers = [&](const char *threads) {
        return probe(tube(), points, {"--integrator", "bidir", "--threads", threads}).run.out;
    };
    EXPECT_EQ(answers("1"), answers("2"));
}

/// Volumes that light paths cannot cross are said here, too, and the light is that of `path`.
TEST(BothEnds, LeaveSomeVolumesToPath) {
    const std::string world = siWorld("LightSource \"pointlight\" 1 \"from\" [0 0 1]\n"
                                      "Exterior \"fog\"\nSphere 3 -3 3 360\n");
    const Probed path = probe(world, points, {"--integrator", "path"});
    const Probed bidir = probe(world, points, {"--integrator", "bidir"});
    EXPECT_EQ(bidir.run.out, path.run.out);
    EXPECT_TRUE(bidir.run.says("surfaces have an Exterior")) << bidir.run.err;
}

} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// ObjectInstance draws what the object's primitives would, were they repeated in its place.
#include "foundation/base/student.h"
#include "tests/bodies/bodies.h"
#include "tests/bodies/copies.h"
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

/// How GoogleTest names a body that failed.
static void PrintTo(const Body &body, std::ostream *stream) { *stream << body.name; }

namespace {

/// Pixels at outlines, and seams and poles of (u,v), may fall to either side: instances are diced
/// for all that they share.
void expectSamePicture(const std::vector<float> &a, const std::vector<float> &b) {
    ASSERT_EQ(a.size(), b.size());
    int different = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        different += std::abs(a[i] - b[i]) > .01f;
    EXPECT_LE(different, int(a.size()) / 20);
}

class RepeatedBodies : public testing::TestWithParam<Body> {};

TEST_P(RepeatedBodies, LookTheSameAsInstances) {
    const std::string options =
        "Option \"render\" \"string integrator\" [\"classic\"]\n"
        "Format 64 64 1\nShadingRate .02\nProjection \"perspective\" \"fov\" [40]\n"
        "Translate 0 0 18\n";
    std::vector<Frame> frames;
    for (const char *sides : {"Sides 2\n", "Sides 1\n"})
        for (const char *what : {"0", "1", "2"})
            for (bool instances : {false, true})
                frames.push_back({what, options,
                                  copied(GetParam(), instances,
                                         sides + ("Surface \"tell\" \"float what\" [" +
                                                  std::string(what) + "]\n"))});
    const auto pictures = render(frames, {1, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        SCOPED_TRACE("tells " + frames[i].name + (i < 6 ? "" : ", one-sided"));
        float covered = 0;
        for (float alpha : pictures[i].alpha)
            covered += alpha;
        EXPECT_GT(covered, 64 * 64 / 20);
        expectSamePicture(pictures[i].alpha, pictures[i + 1].alpha);
        expectSamePicture(pictures[i].red, pictures[i + 1].red);
        expectSamePicture(pictures[i].green, pictures[i + 1].green);
    }
}

/// One costly kind tells as much as all.
std::vector<Body> lamps() {
    std::vector<Body> some;
    for (const Body &body : closedBodies())
        if (!body.costly || body.name == "Cone")
            some.push_back(body);
    return some;
}

/// The mean light of lamps on a wall behind them.
class RepeatedLamps : public testing::TestWithParam<Body> {};

TEST_P(RepeatedLamps, LightTheSameAsInstances) {
    const std::string options = "Format 32 32 1\nProjection \"orthographic\"\nClipping 4 99\n"
                                "ScreenWindow -5 5 -5 5\n";
    std::vector<Frame> frames;
    for (const char *look :
         {"Surface \"constant\"\n",
          "AreaLightSource \"arealight\" 1 \"float onesided\" [0]\nSurface \"matte\"\n"})
        for (bool instances : {false, true})
            frames.push_back(
                {look, options,
                 std::string("AttributeBegin\n") + look + copied(GetParam(), instances, "") +
                     "AttributeEnd\n" + (look[0] == 'A' ? "Illuminate 1 1\n" : "") +
                     "Surface \"matte\"\nPolygon \"P\" [-9 -9 5 -9 9 5 9 9 5 9 -9 5]\n"});
    const auto pictures = render(frames, {64, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        const auto [mean, difference] = compareRed(pictures[i], pictures[i + 1]);
        EXPECT_GT(mean, .01);
        EXPECT_LE(difference.standardError, .02 * mean);
        EXPECT_LE(std::abs(difference.mean),
                  studentQuantile(1e-5, 1023) * difference.standardError + 2e-4 * mean)
            << frames[i].name << mean;
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, RepeatedBodies, testing::ValuesIn(closedBodies()),
                         [](const auto &info) { return info.param.name; });

INSTANTIATE_TEST_SUITE_P(Bodies, RepeatedLamps, testing::ValuesIn(lamps()),
                         [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela::test

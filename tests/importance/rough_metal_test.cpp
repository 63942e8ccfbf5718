// SPDX-License-Identifier: Apache-2.0
// The shipped "roughmetal" in a uniform field, seen at every angle and of every width: it gives
// back no more than it gets, and its cones follow its lobe well enough to show that.
#include "foundation/base/student.h"
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

constexpr int samples = 64, pixels = 64;
constexpr double alphas[] = {1e-4, 1e-3, .003, .01, .03, .1, .3, 1};
constexpr double cosines[] = {1, .8, .5, .2, .05, .02};

struct View {
    double alpha, cosine;
};

std::string name(const View &view) {
    return "alpha " + std::to_string(view.alpha) + ", cosine " + std::to_string(view.cosine);
}

/// A plane at that slant; all rays that come meet it under one angle.
Frame frameOf(const View &view) {
    const double degrees = std::acos(view.cosine) * 180 / M_PI;
    return {name(view), "Projection \"orthographic\"\nScreenWindow -.01 .01 -.01 .01\n",
            "Surface \"constant\"\nSphere 90 -90 90 360\nSurface \"roughmetal\" \"float alpha\" [" +
                std::to_string(view.alpha) + "]\nTranslate 0 0 5\nRotate " +
                std::to_string(degrees) + " 0 1 0\nPolygon \"P\" [-9 -9 0 -9 9 0 9 9 0 9 -9 0]\n"};
}

TEST(RoughMetal, GivesBackNoMoreThanItGets) {
    std::vector<View> views;
    std::vector<Frame> frames;
    for (double alpha : alphas)
        for (double cosine : cosines) {
            views.push_back({alpha, cosine});
            frames.push_back(frameOf(views.back()));
        }
    const auto pictures = render(frames, {samples, 1, "importance/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    const double sure = studentQuantile(1e-5, pixels - 1);
    for (std::size_t i = 0; i < views.size(); ++i) {
        SCOPED_TRACE(name(views[i]));
        const auto &[alpha, cosine] = views[i];
        const MeanAndError albedo = meanAndError({pictures[i].red.begin(), pictures[i].red.end()});
        // What single precision makes of a lobe a thousandth wide.
        constexpr double rounding = 2e-3;
        EXPECT_LE(albedo.mean, 1 + sure * albedo.standardError + rounding);
        EXPECT_GT(albedo.mean, .3 - sure * albedo.standardError);
        // Narrow lobes lose nothing, as long as their facets stand in no one's way.
        if (alpha <= .01 && cosine >= 20 * alpha) {
            EXPECT_GE(albedo.mean, 1 - sure * albedo.standardError - rounding);
        }
        // Round cones fit a ridge that is as narrow as the cosine but so well; below a width of
        // .003 the largest exponent ends the fit.
        const double relative = albedo.standardError / albedo.mean;
        const double variance = relative * relative * samples * pixels;
        if (alpha >= .003) {
            EXPECT_LE(variance, .3 + .3 / cosine);
        }
    }
}

} // namespace
} // namespace candela::test

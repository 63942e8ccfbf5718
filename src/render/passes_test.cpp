// SPDX-License-Identifier: Apache-2.0
// A frame that is rendered in parts, pass by pass, is the frame that is rendered at once.
#include "foundation/base/parallel.h"
#include "image/film.h"
#include "light/frame/integrate.h"
#include "light/path/first_hit.h"
#include "render/scene_test_support.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

using Range = std::pair<int, int>;

/// A film of the tests' scene that has got these samples, one range after the other.
std::unique_ptr<Film> rendered(const Scene &scene, const std::vector<Range> &ranges,
                               DiagnosticSink &diagnostics) {
    const Options &options = scene.options();
    const PixelFilterSampler filter(options.filter, diagnostics, options.places.pixelFilter);
    const std::array<int, 4> crop = options.format.cropPixels();
    const auto [width, height] = options.format.effectiveResolution();
    auto film =
        std::make_unique<Film>(Film::Settings{{width, height, crop[0], crop[1], crop[2], crop[3]},
                                              firstHitChannels(),
                                              filter.hasNegativeLobes(),
                                              true});
    TransportStatistics statistics;
    int threads = 1;
    for (auto [first, last] : ranges) {
        ThreadLimit limit(threads++);
        IntegratorSettings settings;
        settings.kind = scene.isClassic() ? IntegratorKind::Classic : IntegratorKind::Path;
        settings.lastSample = last;
        settings.seed = 7;
        settings.crop = crop;
        FrameProgress progress({first, false, {}});
        integrate(scene, settings, filter, *film, progress, statistics, diagnostics);
    }
    return film;
}

void expectSame(const Film &a, const Film &b) {
    for (int channel = 0; channel < int(a.channels().size()); ++channel)
        for (int c = 0; c < a.channels()[channel].components; ++c)
            for (FilmHalf half : {FilmHalf::Both, FilmHalf::Even, FilmHalf::Odd})
                EXPECT_EQ(a.mean(channel, c, half), b.mean(channel, c, half))
                    << a.channels()[channel].name;
    for (int c = 0; c < colorSamples; ++c)
        EXPECT_EQ(a.varianceOfMean(c), b.varianceOfMean(c));
}

constexpr const char *everything = CANDELA_SOURCE_DIR "/tests/determinism/everything.rib";

class Passes : public testing::TestWithParam<const char *> {};

TEST_P(Passes, SixteenSamplesAndThenFortyEightGiveTheBytesOfSixtyFour) {
    forScene(GetParam(), everything, [](const Scene &scene) {
        DiagnosticList list;
        const auto whole = rendered(scene, {{0, 64}}, list);
        expectSame(*rendered(scene, {{0, 16}, {16, 64}}, list), *whole);
    });
}

TEST_P(Passes, CarryOnFromAnyOfThem) {
    forScene(GetParam(), everything, [](const Scene &scene) {
        DiagnosticList list;
        expectSame(*rendered(scene, {{0, 16}, {16, 64}, {64, 128}, {128, 150}}, list),
                   *rendered(scene, {{0, 150}}, list));
    });
}

TEST_P(Passes, TheLastMayTakeFewerSamples) {
    forScene(GetParam(), everything, [](const Scene &scene) {
        DiagnosticList list;
        expectSame(*rendered(scene, {{0, 16}, {16, 21}}, list), *rendered(scene, {{0, 21}}, list));
    });
}

INSTANTIATE_TEST_SUITE_P(Integrators, Passes,
                         testing::Values("",
                                         "Option \"render\" \"string integrator\" [\"classic\"]"));

} // namespace
} // namespace candela

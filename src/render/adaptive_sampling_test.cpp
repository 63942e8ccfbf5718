// SPDX-License-Identifier: Apache-2.0
// PixelVariance: fewer samples where few are enough, and pictures whose mean over seeds is what it
// is without.
#include "foundation/base/student.h"
#include "image/film.h"
#include "light/frame/adaptive_sampling.h"
#include "light/frame/integrate.h"
#include "render/scene_test_support.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

struct Wanted {
    int samples;
    double variance = 0;
    std::uint32_t seed = 1;
};

std::unique_ptr<Film> rendered(const Scene &scene, const Wanted &wanted) {
    DiagnosticList diagnostics;
    const Options &options = scene.options();
    const PixelFilterSampler filter(options.filter, diagnostics, options.places.pixelFilter);
    IntegratorSettings settings;
    settings.kind = scene.isClassic() ? IntegratorKind::Classic : IntegratorKind::Path;
    settings.lastSample = wanted.samples;
    settings.variance = wanted.variance;
    settings.seed = wanted.seed;
    settings.crop = options.format.cropPixels();
    const auto [width, height] = options.format.effectiveResolution();
    const auto [x0, x1, y0, y1] = settings.crop;
    Film::Settings film{{width, height, x0, x1, y0, y1}, {}, filter.hasNegativeLobes()};
    film.pairsHalves = AdaptiveSampling(settings).isOn();
    auto result = std::make_unique<Film>(film);
    FrameProgress progress;
    TransportStatistics statistics;
    integrate(scene, settings, filter, *result, progress, statistics, diagnostics);
    return result;
}

double meanOf(const std::vector<float> &pixels) {
    double sum = 0;
    for (float value : pixels)
        sum += value;
    return sum / double(pixels.size());
}

std::string square(const std::string &options, const std::string &shader) {
    return "Format 32 32 1\nProjection \"orthographic\"\n" + options + "WorldBegin\n" + shader +
           "Polygon \"P\" [-2 -2 1 2 -2 1 2 2 1 -2 2 1]\nWorldEnd\n";
}

/// By how many standard errors the means of pictures of many seeds differ from 1.
double deviationFromOne(const std::vector<double> &means) {
    const MeanAndError all = meanAndError(means);
    return (all.mean - 1) / all.standardError;
}

/// Far beyond chance in either direction.
constexpr double sure = 4;

struct Company {
    const char *name, *options;
};

class Adaptive : public testing::TestWithParam<Company> {};

/// A sample in a hundred is bright. The rule that asks a pixel's own samples whether they are
/// enough stops where it has seen none, and makes the picture too dark.
TEST_P(Adaptive, SamplingHasTheMeanOfAllSamples) {
    constexpr int first = 16, all = 128;
    constexpr double variance = 1.5;
    forScene(square(GetParam().options, "Surface \"firefly\"\n"), "", [&](const Scene &scene) {
        std::vector<double> adaptive, byItsOwn;
        double samples = 0;
        for (std::uint32_t seed = 1; seed <= 48; ++seed) {
            const auto film = rendered(scene, {all, variance, seed});
            adaptive.push_back(meanOf(film->mean(0, 0)));
            samples += film->sampleCounts().mean / 48;

            const auto few = rendered(scene, {first, 0, seed}),
                       many = rendered(scene, {all, 0, seed});
            const std::vector<float> spread = few->varianceOfMean(0), soFar = few->mean(0, 0);
            std::vector<float> chosen = many->mean(0, 0);
            for (std::size_t i = 0; i < chosen.size(); ++i)
                if (spread[i] <= variance)
                    chosen[i] = soFar[i];
            byItsOwn.push_back(meanOf(chosen));
        }
        EXPECT_LT(std::fabs(deviationFromOne(adaptive)), sure);
        EXPECT_LT(deviationFromOne(byItsOwn), -sure);
        EXPECT_GT(samples, 1.5 * first);
        EXPECT_LT(samples, 0.9 * all);
    });
}

INSTANTIATE_TEST_SUITE_P(
    Company, Adaptive,
    testing::Values(Company{"Path", "Option \"render\" \"string integrator\" \"path\"\n"},
                    Company{"Classic", "Option \"render\" \"string integrator\" \"classic\"\n"},
                    Company{"Gauss", "PixelFilter \"gaussian\" 2 2\n"},
                    Company{"Lobes", "PixelFilter \"catmull-rom\" 4 4\n"}),
    [](const auto &info) { return std::string(info.param.name); });

/// Nine tenths are flat, with an edge between two tones; one is noise.
TEST(AdaptiveSamplingOf, FlatPartsAndAnEdgeSpendsLessForTheSameError) {
    const std::string patches =
        "Surface \"constant\"\nColor .2 .2 .2\nPolygon \"P\" [-1 -1 .5 .07 -1 .5 .13 1 .5 -1 1 "
        ".5]\n"
        "Surface \"firefly\" \"share\" .5\n"
        "Polygon \"P\" [.8 -1 .5 1 -1 .5 1 1 .5 .8 1 .5]\nSurface \"constant\"\nColor 1 1 1\n";
    const auto errorOf = [](const Film &film, const Film &truth) {
        const std::vector<float> a = film.mean(0, 0), b = truth.mean(0, 0);
        double squares = 0;
        for (int i = 0; i < int(a.size()); ++i)
            squares += std::pow(a[i] - (i % 32 >= 30 ? 1.0 : double(b[i])), 2);
        return squares;
    };
    forScene(square("PixelFilter \"box\" 1 1\n", patches), "", [&](const Scene &scene) {
        const auto truth = rendered(scene, {4096, 0, 99});
        double adaptive = 0, uniform = 0, samples = 0;
        for (std::uint32_t seed = 1; seed <= 8; ++seed) {
            const auto film = rendered(scene, {256, .004, seed});
            samples += film->sampleCounts().mean / 8;
            adaptive += errorOf(*film, *truth);
            uniform += errorOf(*rendered(scene, {128, 0, seed}), *truth);
        }
        EXPECT_LT(samples, 128 / 2);
        EXPECT_LT(adaptive, uniform);
    });
}

/// The variance that the film tells is that of the halves' mean over seeds, and no more than what
/// was asked for, but where all samples are not enough.
TEST(AdaptiveSamplingOf, NoiseComesToTheVarianceThatIsAskedFor) {
    constexpr double variance = .02;
    forScene(square("", "Surface \"firefly\" \"share\" .5\n"), "", [&](const Scene &scene) {
        double squares = 0, told = 0;
        for (std::uint32_t seed = 1; seed <= 16; ++seed) {
            const auto film = rendered(scene, {1024, variance, seed});
            told += meanOf(film->varianceOfMean(0)) / 16;
            for (float value : film->mean(0, 0))
                squares += (value - 1) * (value - 1) / (16 * 1024.0);
        }
        EXPECT_LT(squares, variance);
        EXPECT_GT(squares, variance / 4); // Numbers of samples double.
        EXPECT_NEAR(told, squares, .05 * squares);
    });
}

} // namespace
} // namespace candela

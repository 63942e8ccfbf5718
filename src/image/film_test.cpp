// SPDX-License-Identifier: Apache-2.0
#include "image/film.h"

#include "foundation/base/hash.h"
#include "foundation/base/parallel.h"
#include "world/camera/pixel_filter.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace candela {
namespace {

struct Sample {
    int x, y, index;
    float weight;
    std::vector<float> values;
};

float uniform(std::uint64_t key) { return float(mixBits(key) >> 40) * 0x1p-24f; }

/// Samples of a pixel that depend on the pixel and the index alone, of 10 components: Ci, Oi, z
/// and N.
std::vector<Sample> samplesOf(int x, int y, int count, bool signedWeights) {
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i) {
        const std::uint64_t key = (std::uint64_t(y) * 1000 + x) * 1000 + i;
        const float sign = signedWeights && uniform(key * 64 + 63) < 0.2f ? -1.0f : 1.0f;
        Sample sample{x, y, i, signedWeights ? sign / 0.6f : 1.0f, {}};
        for (int c = 0; c < 10; ++c)
            sample.values.push_back(3 * uniform(key * 64 + c) - 1);
        samples.push_back(sample);
    }
    return samples;
}

void addTo(Film &film, const std::vector<Sample> &samples) {
    if (samples.empty())
        return;
    const std::size_t n = samples.size(), components = samples[0].values.size();
    std::vector<int> x(n), y(n), index(n);
    std::vector<float> weight(n), values(n * components);
    std::vector<const float *> planes;
    for (std::size_t c = 0; c < components; ++c)
        planes.push_back(&values[c * n]);
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = samples[i].x, y[i] = samples[i].y, index[i] = samples[i].index;
        weight[i] = samples[i].weight;
        for (std::size_t c = 0; c < components; ++c)
            values[c * n + i] = samples[i].values[c];
    }
    film.add({int(n), x.data(), y.data(), index.data(), weight.data(), planes.data()});
}

Film::Settings settingsOf(FrameWindow window, bool signedWeights = false, bool halves = false) {
    return {window, {{"z", 1}, {"N", 3}}, signedWeights, halves};
}

TEST(Film, ColorAndOpacityComeFirst) {
    const Film film(settingsOf({4, 4, 0, 4, 0, 4}));
    ASSERT_EQ(film.channels().size(), 4u);
    EXPECT_EQ(film.channels()[0].name, "Ci");
    EXPECT_EQ(film.channels()[1].name, "Oi");
    EXPECT_EQ(film.channelIndex("N"), 3);
    EXPECT_EQ(film.channelIndex("none"), -1);
}

TEST(Film, MeansMinimaAndHalvesAgreeWithAReference) {
    Film film(settingsOf({20, 20, 3, 8, 5, 9}, false, true));
    for (int y = 5; y < 9; ++y)
        for (int x = 3; x < 8; ++x)
            addTo(film, samplesOf(x, y, 7, false));
    std::size_t pixel = 0;
    for (int y = 5; y < 9; ++y)
        for (int x = 3; x < 8; ++x, ++pixel) {
            long double sum[10] = {}, even[10] = {}, squares = 0;
            float nearest = std::numeric_limits<float>::max();
            const auto samples = samplesOf(x, y, 7, false);
            for (const Sample &s : samples) {
                for (int c = 0; c < 10; ++c) {
                    sum[c] += s.values[c];
                    even[c] += s.index % 2 == 0 ? s.values[c] : 0;
                }
                nearest = std::min(nearest, s.values[6]);
            }
            for (const Sample &s : samples)
                squares += (s.values[1] - sum[1] / 7) * (s.values[1] - sum[1] / 7);
            ASSERT_EQ(film.mean(0, 2)[pixel], float(double(sum[2] / 7)));
            ASSERT_EQ(film.mean(1, 0)[pixel], float(double(sum[3] / 7)));
            ASSERT_EQ(film.mean(2, 0)[pixel], nearest);
            ASSERT_EQ(film.mean(3, 1)[pixel], float(double(sum[8] / 7)));
            ASSERT_NEAR(film.mean(0, 1, FilmHalf::Even)[pixel], double(even[1] / 4), 1e-6);
            ASSERT_NEAR(film.mean(0, 1, FilmHalf::Odd)[pixel], double((sum[1] - even[1]) / 3),
                        1e-6);
            ASSERT_NEAR(film.varianceOfMean(1)[pixel], double(squares / 6 / 7), 1e-6);
        }
}

TEST(Film, KeepingHalvesChangesNoBit) {
    Film plain(settingsOf({4, 1, 0, 4, 0, 1})), halves(settingsOf({4, 1, 0, 4, 0, 1}, false, true));
    for (int x = 0; x < 4; ++x) {
        addTo(plain, samplesOf(x, 0, 33, false));
        addTo(halves, samplesOf(x, 0, 33, false));
    }
    EXPECT_EQ(plain.mean(0, 0), halves.mean(0, 0));
    EXPECT_EQ(plain.varianceOfMean(0), halves.varianceOfMean(0));
}

TEST(Film, BatchesThreadsAndCropsJoinedChangeNoBit) {
    constexpr int width = 37, height = 23, count = 19;
    Film whole(settingsOf({width, height, 0, width, 0, height}, true));
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            addTo(whole, samplesOf(x, y, count, true));

    Film threaded(settingsOf({width, height, 0, width, 0, height}, true));
    parallelFor(width * height, [&](std::size_t k) {
        const std::size_t i = (k * 101) % (width * height); // Another order, in batches of two.
        const auto samples = samplesOf(int(i % width), int(i / width), count, true);
        for (int s = 0; s < count; s += 2)
            addTo(threaded, {samples.begin() + s, samples.begin() + std::min(count, s + 2)});
    });
    for (int channel = 0; channel < 4; ++channel)
        EXPECT_EQ(whole.mean(channel, 0), threaded.mean(channel, 0));

    for (FrameWindow part : {FrameWindow{width, height, 0, 11, 0, height},
                             FrameWindow{width, height, 11, width, 4, 23}}) {
        Film crop(settingsOf(part, true));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                addTo(crop, samplesOf(x, y, count, true)); // Those outside are ignored.
        const auto all = whole.mean(0, 1), some = crop.mean(0, 1);
        const auto allVariance = whole.varianceOfMean(1), someVariance = crop.varianceOfMean(1);
        for (int y = part.y0; y < part.y1; ++y)
            for (int x = part.x0; x < part.x1; ++x) {
                const std::size_t at = std::size_t(y - part.y0) * part.columns() + x - part.x0;
                ASSERT_EQ(some[at], all[y * width + x]);
                ASSERT_EQ(someVariance[at], allVariance[y * width + x]);
            }
    }
}

/// Samples of f at the points of a filter, `count` a pixel, independent.
template <class Function>
void sampleFiltered(Film &film, const PixelFilterSampler &filter, int count, const Function &f) {
    for (int y = 0; y < film.window().height; ++y)
        for (int x = 0; x < film.window().width; ++x) {
            std::vector<Sample> samples;
            for (int i = 0; i < count; ++i) {
                const std::uint64_t key = ((std::uint64_t(y) * 4096 + x) * 4096 + i) * 2;
                const FilterSample s = filter.sample(uniform(key), uniform(key + 1));
                samples.push_back({x, y, i, s.weight, std::vector<float>(10, f(s.dx, s.dy))});
            }
            addTo(film, samples);
        }
}

TEST(Film, NegativeLobesKeepConstantsExactAndMeansUnbiased) {
    DiagnosticList list;
    const PixelFilterSampler filter({"catmull-rom", 4, 4}, list);
    constexpr int size = 100, count = 6;
    const FrameWindow window{size, size, 0, size, 0, size};
    Film constant(settingsOf(window, true)), varying(settingsOf(window, true));
    sampleFiltered(constant, filter, count, [](float, float) { return 0.7f; });
    for (float value : constant.mean(0, 0))
        ASSERT_FLOAT_EQ(value, 0.7f);
    for (float value : constant.varianceOfMean(0))
        ASSERT_NEAR(value, 0, 1e-12);

    const auto g = [](float x, float y) { return 1 + 0.5f * std::cos(2 * x) + y * y; };
    double exact = 0, norm = 0;
    for (int i = 0; i < 800; ++i)
        for (int j = 0; j < 800; ++j) {
            const double x = (i + 0.5) / 200 - 2, y = (j + 0.5) / 200 - 2;
            const double kernel = pixelFilterKernel(filter.record(), x, y);
            exact += kernel * g(float(x), float(y));
            norm += kernel;
        }
    exact /= norm;
    sampleFiltered(varying, filter, count, g);
    double mean = 0, meanSquare = 0, variance = 0;
    const auto values = varying.mean(0, 0), variances = varying.varianceOfMean(0);
    for (std::size_t i = 0; i < values.size(); ++i) {
        mean += values[i] / values.size();
        meanSquare += double(values[i]) * values[i] / values.size();
        variance += variances[i] / values.size();
    }
    const double spread = meanSquare - mean * mean;
    EXPECT_NEAR(mean, exact, 4 * std::sqrt(spread / values.size()));
    // Six samples leave a bias of higher order.
    EXPECT_NEAR(variance / spread, 1, 0.25);
}

TEST(Film, EmptySingleAndNonFiniteSamples) {
    Film film(settingsOf({3, 1, 0, 3, 0, 1}, true));
    std::vector<float> values(10, 0.5f);
    addTo(film, {{1, 0, 0, -1.5f, values}});
    values[0] = NAN;
    values[4] = INFINITY;
    values[6] = INFINITY; // An infinite depth is a miss, not a mistake.
    addTo(film, {{2, 0, 0, 1, values}});
    EXPECT_EQ(film.mean(0, 0), (std::vector<float>{0, 0.5f, 0}));
    EXPECT_EQ(film.mean(0, 1), (std::vector<float>{0, 0.5f, 0.5f}));
    EXPECT_EQ(film.mean(2, 0)[0], std::numeric_limits<float>::max());
    EXPECT_EQ(film.mean(2, 0)[2], std::numeric_limits<float>::max());
    EXPECT_EQ(film.nonFiniteSamples(), 2u);
    EXPECT_TRUE(std::isinf(film.varianceOfMean(0)[1]));
}

TEST(Film, NeedsAreKnownBeforeItIsMade) {
    Film::Settings settings;
    settings.window = {1000000, 1000000, 0, 1000000, 0, 1000000};
    const double needed = Film::bytesNeeded(settings);
    EXPECT_GT(needed, 48e12); // Six sums at least, in double.
    settings.window = {1000000, 1000000, 0, 10, 0, 10};
    EXPECT_DOUBLE_EQ(Film::bytesNeeded(settings), needed * 1e-10);
    settings.keepHalves = true;
    EXPECT_GT(Film::bytesNeeded(settings), needed * 1e-10);
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "image/film.h"

#include "foundation/base/hash.h"
#include "foundation/base/parallel.h"
#include "world/camera/pixel_filter.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

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

TEST(Film, PairedHalvesCountAlikeWhateverTheirNumbers) {
    Film::Settings settings = settingsOf({1, 1, 0, 1, 0, 1});
    settings.pairsHalves = true;
    Film film(settings);
    const auto sample = [](int index, float value) {
        return Sample{0, 0, index, 1, std::vector<float>(10, value)};
    };
    addTo(film, {sample(0, 1)});
    EXPECT_EQ(film.mean(0, 0)[0], 1) << "one half alone";
    addTo(film, {sample(1, 5), sample(2, 2), sample(4, 3)});
    EXPECT_EQ(film.mean(0, 0)[0], .5 * 2 + .5 * 5);
    EXPECT_EQ(film.mean(2, 0)[0], 1) << "depths are none of both";
    EXPECT_EQ(film.mean(0, 0, FilmHalf::Even)[0], 2);
    // A sample's variance is 35 / 12; the halves have 3 and 1.
    EXPECT_NEAR(film.varianceOfMean(0)[0], 35 / 12. * (1 / 3. + 1) / 4, 1e-6);
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

TEST(Film, NumbersOfThingsAreTheFirstSamplesAndNoMean) {
    Film film({{3, 1, 0, 3, 0, 1}, {{"id", 1}}, false, true});
    auto sample = [](int x, int index, float id) {
        return Sample{x, 0, index, 1, {0, 0, 0, 0, 0, 0, id}};
    };
    addTo(film, {sample(0, 0, 3), sample(0, 1, 8), sample(0, 2, 8)});
    addTo(film, {sample(0, 3, 1)});
    addTo(film, {sample(1, 0, 16777216), sample(1, 1, 5)});
    EXPECT_EQ(film.mean(2, 0), (std::vector<float>{3, 16777216, 0}));
    EXPECT_EQ(film.mean(2, 0, FilmHalf::Odd), film.mean(2, 0));
}

/// Splats of all magnitudes and both signs over a film of 16 x 8 and its surroundings.
struct Splats {
    explicit Splats(std::size_t count) : x(count), y(count), values(3 * count) {
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = 20 * uniform(8 * i) - 2, y[i] = 12 * uniform(8 * i + 1) - 2;
            for (int c = 0; c < 3; ++c)
                values[3 * i + c] =
                    (uniform(8 * i + 2 + c) - .3f) * std::exp(20 * uniform(8 * i + 5 + c) - 10);
        }
    }
    std::vector<float> x, y, values;
};

/// Brings splats order[first, last), as one batch.
void bring(Film &film, const Splats &splats, const std::vector<std::size_t> &order,
           std::size_t first, std::size_t last) {
    std::vector<float> x, y, values[3];
    for (std::size_t k = first; k < last; ++k) {
        x.push_back(splats.x[order[k]]), y.push_back(splats.y[order[k]]);
        for (int c = 0; c < 3; ++c)
            values[c].push_back(splats.values[3 * order[k] + c]);
    }
    const float *planes[] = {values[0].data(), values[1].data(), values[2].data()};
    SplatBatch batch;
    batch.count = int(last - first);
    batch.x = x.data(), batch.y = y.data(), batch.values = planes;
    batch.lightPaths = 2 * batch.count; // Every other path is not seen.
    film.add(batch);
}

Film::Settings splatSettings() {
    Film::Settings settings;
    settings.window = {16, 8, 0, 16, 0, 8};
    settings.splats = true;
    return settings;
}

TEST(Film, SplatsInAnyOrderAndFromAnyThreadGiveTheSameBytes) {
    constexpr std::size_t count = 20000, batch = 50;
    const Splats splats(count);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), 0);
    Film whole(splatSettings());
    bring(whole, splats, order, 0, count);
    double sums[16 * 8] = {};
    for (std::size_t i = 0; i < count; ++i)
        if (splats.x[i] >= 0 && splats.x[i] < 16 && splats.y[i] >= 0 && splats.y[i] < 8)
            sums[int(splats.y[i]) * 16 + int(splats.x[i])] += splats.values[3 * i + 1];
    const std::vector<float> green = whole.mean(0, 1);
    for (int i = 0; i < 16 * 8; ++i)
        EXPECT_NEAR(green[i], sums[i] / (2 * count), 1e-5 + 1e-5 * std::fabs(green[i]));

    std::sort(order.begin(), order.end(),
              [](std::size_t a, std::size_t b) { return mixBits(a) < mixBits(b); });
    for (int threads : {1, 2, 4}) {
        ThreadLimit limit(threads);
        Film film(splatSettings());
        parallelFor(count / batch,
                    [&](std::size_t k) { bring(film, splats, order, k * batch, (k + 1) * batch); });
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(film.mean(0, c), whole.mean(0, c)) << threads;
        EXPECT_EQ(film.splats()->saturatedSums(), 0u);
    }
}

TEST(Film, SplatsBeyondTheRangeStayAtItsEndAndAreCounted) {
    const float x = 3.5f, y = 2.5f, huge = 1e15f, one = 1, none = NAN;
    const float *planes[] = {&huge, &one, &none};
    SplatBatch batch;
    batch.count = 1, batch.x = &x, batch.y = &y, batch.values = planes, batch.lightPaths = 1;
    Film film(splatSettings());
    for (int i = 0; i < 9; ++i)
        film.add(batch);
    const std::size_t pixel = 2 * 16 + 3;
    EXPECT_FLOAT_EQ(film.mean(0, 0)[pixel], float(0x1p47 / 9));
    EXPECT_FLOAT_EQ(film.mean(0, 1)[pixel], 1);
    EXPECT_EQ(film.mean(0, 2)[pixel], 0);
    EXPECT_EQ(film.splats()->saturatedSums(), 1u);
    EXPECT_EQ(film.nonFiniteSamples(), 9u);
}

TEST(Film, SplatsJoinWhatSamplesBring) {
    Film film(splatSettings());
    addTo(film, {{5, 5, 0, 1, {.5f, .5f, .5f, 1, 1, 1}}});
    const float x = 5, y = 5.99f, value = 4;
    const float *planes[] = {&value, &value, &value};
    SplatBatch batch;
    batch.count = 1, batch.x = &x, batch.y = &y, batch.values = planes, batch.lightPaths = 16;
    film.add(batch);
    EXPECT_FLOAT_EQ(film.mean(0, 0)[5 * 16 + 5], .75f);
    EXPECT_FLOAT_EQ(film.mean(1, 0)[5 * 16 + 5], 1);
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "light/frame/adaptive_sampling.h"

#include "light/path/split.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace candela {

namespace {

/// Tiles of all passes: parts of one share no pixel with those of another.
constexpr int tileWidth = 16, pixelsOfTile = tileWidth * tileWidth;
/// Pixels that look at each other: an aligned square of 4 x 4, consecutive in Morton order.
constexpr int neighbours = 16;
constexpr int slotsOfWave = PathWave::capacity / cameraDirections;

/// A sixteenth of all samples, within these bounds: below, variances mean little; above, a wave
/// does not hold the pixels that look at each other.
int pilotSamples(int samples) {
    constexpr int least = 16, most = 128;
    static_assert(most * neighbours <= slotsOfWave);
    return std::clamp(int(std::bit_floor(unsigned(samples)) / 16), least, most);
}

/// The variance of one sample of Ci as an estimate of the pixel, from every other of `samples`
/// slots; of the channel where it is largest. With weights of both signs the estimate is what the
/// film makes of them, whose samples vary as w (v - mean of v).
double varianceOfHalf(const PathResults &results, int slot, int samples) {
    const int n = samples / 2;
    double largest = 0;
    for (int c = 0; c < colorSamples; ++c) {
        const auto value = [&](int i) {
            const float v = results.radiance[c][slot + 2 * i];
            return std::isfinite(v) ? double(v) : 0.0;
        };
        double mean = 0;
        for (int i = 0; i < n; ++i)
            mean += value(i) / n;
        double sum = 0, squares = 0;
        for (int i = 0; i < n; ++i) {
            const double part = results.weight[0][slot + 2 * i] * (value(i) - mean);
            sum += part, squares += part * part;
        }
        largest = std::max(largest, (squares - sum * sum / n) / (n - 1));
    }
    return largest;
}

} // namespace

AdaptiveSampling::AdaptiveSampling(const IntegratorSettings &settings)
    : crop_(settings.crop), variance_(settings.variance) {
    const int pilot = pilotSamples(settings.lastSample);
    if (variance_ > 0 && settings.lastSample > pilot)
        pilot_ = pilot;
}

std::size_t AdaptiveSampling::wishes() const {
    return isOn() ? 2 * pixelsOfTile * tilesOver(crop_, tileWidth).size() : 0;
}

int AdaptiveSampling::passEnd(int first) const {
    return first < pilot_ ? pilot_ : std::min(2 * first, candela::passEnd(first));
}

std::size_t AdaptiveSampling::wishOf(const Tile &tile, int pixel) const {
    const int x0 = roundDown(crop_[0], tileWidth), y0 = roundDown(crop_[2], tileWidth);
    const std::size_t columns = std::size_t((crop_[1] - x0 + tileWidth - 1) / tileWidth);
    const std::size_t row = std::size_t((tile.y - y0) / tileWidth);
    const std::size_t column = std::size_t((tile.x - x0) / tileWidth);
    return 2 * ((row * columns + column) * pixelsOfTile + std::size_t(pixel));
}

Halves AdaptiveSampling::halvesOf(const Tile &tile, int pixel, int firstSample,
                                  const SampleWishes &wishes) const {
    if (isPilot(firstSample))
        return Halves::Both;
    const std::int32_t *wish = &wishes[wishOf(tile, pixel)], taken = firstSample / 2;
    return Halves((wish[0] > taken ? int(Halves::Even) : 0) |
                  (wish[1] > taken ? int(Halves::Odd) : 0));
}

std::vector<TilePart> AdaptiveSampling::parts(int first, int last,
                                              const SampleWishes &wishes) const {
    std::vector<TilePart> parts;
    for (const Tile &tile : tilesOver(crop_, tileWidth)) {
        TilePart part{tile, 0, 0};
        int slots = 0;
        for (int pixel = 0; pixel < pixelsOfTile; ++pixel) {
            const int more = std::popcount(unsigned(halvesOf(tile, pixel, first, wishes))) *
                             ((last - first + 1) / 2);
            if (slots + more > slotsOfWave) {
                parts.push_back(part);
                part.first = pixel, slots = 0;
            }
            part.last = pixel + 1, slots += more;
        }
        if (slots > 0)
            parts.push_back(part);
    }
    return parts;
}

void AdaptiveSampling::pixelsOf(const TilePart &part, int firstSample, const SampleWishes &wishes,
                                Pixels &pixels) const {
    candela::pixelsOf(part.tile, pixels.x, pixels.y);
    pixels.halves.clear();
    int taken = 0;
    for (int pixel = part.first; pixel < part.last; ++pixel) {
        const Halves halves = halvesOf(part.tile, pixel, firstSample, wishes);
        if (halves == Halves::None)
            continue;
        pixels.x[taken] = pixels.x[pixel], pixels.y[taken] = pixels.y[pixel];
        pixels.halves.push_back(halves);
        ++taken;
    }
    pixels.x.resize(taken), pixels.y.resize(taken);
}

void AdaptiveSampling::decide(const TilePart &part, const PathResults &results,
                              SampleWishes &wishes) const {
    const auto wish = [&](double variance) {
        const double samples = std::ceil(variance / (2 * variance_));
        return std::int32_t(std::min(samples, double(maximumSamplesPerPixel)));
    };
    for (int block = part.first; block < part.last; block += neighbours)
        for (int half : {0, 1}) {
            double variances[neighbours], mean = 0;
            for (int i = 0; i < neighbours; ++i) {
                const int slot = (block - part.first + i) * pilot_ + half;
                variances[i] = varianceOfHalf(results, slot, pilot_);
                mean += variances[i] / neighbours;
            }
            for (int i = 0; i < neighbours; ++i)
                wishes[wishOf(part.tile, block + i) + std::size_t(1 - half)] =
                    wish(std::max(variances[i], mean));
        }
}

} // namespace candela

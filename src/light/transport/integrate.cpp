// SPDX-License-Identifier: Apache-2.0
// The frame as tiles, tiles as waves. Tiles are squares aligned to absolute pixels and traced
// whole even where the crop window cuts them, so that ray packets, and with them the picture, do
// not depend on the crop.
#include "foundation/base/parallel.h"
#include "light/transport/integrator.h"
#include "light/transport/path_wave.h"

#include <algorithm>
#include <atomic>
#include <vector>

namespace candela {

namespace {

struct Tile {
    int x, y, size;
};

int roundDown(int value, int step) { return value - ((value % step) + step) % step; }

/// Tiles so large that one pass over a tile's pixels fills a wave, and no larger.
int tileSize(int samplesPerPixel) {
    int size = 64;
    while (size > 8 && size * size * std::min(samplesPerPixel, 64) > PathWave::capacity)
        size /= 2;
    return size;
}

std::vector<Tile> tilesOver(const std::array<int, 4> &crop, int size) {
    std::vector<Tile> tiles;
    for (int y = roundDown(crop[2], size); y < crop[3]; y += size)
        for (int x = roundDown(crop[0], size); x < crop[1]; x += size)
            tiles.push_back({x, y, size});
    return tiles;
}

/// The tile's pixels in Morton order: neighbours in the wave are neighbours in the picture.
void pixelsOf(const Tile &tile, std::vector<int> &x, std::vector<int> &y) {
    x.clear();
    y.clear();
    for (int code = 0; code < tile.size * tile.size; ++code) {
        int dx = 0, dy = 0;
        for (int bit = 0; bit < 8; ++bit) {
            dx |= ((code >> (2 * bit)) & 1) << bit;
            dy |= ((code >> (2 * bit + 1)) & 1) << bit;
        }
        x.push_back(tile.x + dx);
        y.push_back(tile.y + dy);
    }
}

void deliver(const PathWave &wave, int planes, SampleSink &sink) {
    const PathResults &results = wave.results();
    std::vector<const float *> values;
    for (int c = 0; c < colorSamples; ++c)
        values.push_back(results.radiance[c]);
    for (int c = 0; c < colorSamples; ++c)
        values.push_back(results.opacity[c]);
    for (int plane = 0; plane < planes; ++plane)
        values.push_back(results.channels[plane]);
    sink.add({wave.slots(), results.x, results.y, results.sampleIndex, results.weight[0],
              values.data()});
}

} // namespace

void integrate(const Scene &scene, const IntegratorSettings &settings,
               const PixelFilterSampler &filter, SampleSink &sink, TransportStatistics &statistics,
               DiagnosticSink &diagnostics) {
    const std::vector<Tile> tiles = tilesOver(settings.crop, tileSize(settings.samplesPerPixel));
    const int planes = int(firstHitPlanes(sink.channels()).size());
    NonFiniteReporter nonFinite(statistics, diagnostics);
    std::atomic<std::size_t> next{0}, done{0};

    parallelFor(std::max(1, threadCount()), [&](std::size_t) {
        PathWave wave(scene, settings, filter, sink.channels(), statistics, nonFinite);
        std::vector<int> x, y;
        for (std::size_t at; (at = next++) < tiles.size();) {
            pixelsOf(tiles[at], x, y);
            const int pixels = int(x.size()), pass = std::max(1, PathWave::capacity / pixels);
            for (int first = 0; first < settings.samplesPerPixel; first += pass) {
                wave.startCamera(pixels, x.data(), y.data(), first,
                                 std::min(first + pass, settings.samplesPerPixel));
                wave.run();
                deliver(wave, planes, sink);
            }
            if (settings.progress)
                settings.progress(double(++done) / double(tiles.size()));
        }
    });
}

} // namespace candela

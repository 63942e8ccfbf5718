// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"
#include "light/path/roulette.h"
#include "light/path/split.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/sobol.h"

#include <algorithm>

namespace candela {

namespace {

void takePaths(const PathWave &wave, PathsAtVertices &paths) {
    const int *ray = wave.chunk.rays.data(), count = wave.chunk.count();
    const ActivePaths &active = wave.active;
    for (int c = 0; c < colorSamples; ++c) {
        lanes::take(count, ray, active.throughput[c], paths.throughput[c]);
        std::fill_n(paths.light[c], count, 0.0f);
    }
    lanes::take(count, ray, active.slot, paths.slot);
    lanes::take(count, ray, active.depth, paths.depth);
    lanes::take(count, ray, active.seen, paths.seen);
    lanes::gather(count, paths.slot, wave.results.keys[0], paths.pixelKey);
    lanes::take(count, ray, active.sampleIndex, paths.sampleIndex);
}

} // namespace

void meet(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const int count = int(chunk.rays.size());
    chunk.vertices.meet(wave.frame.scene, chunk.code, wave.active.rays, wave.hits,
                        chunk.rays.data(), count);
    takePaths(wave, chunk.paths);
    if (chunk.vertices.code().reads(ShaderInput::seed)) {
        float *seed = chunk.vertices.points.input(int(ShaderInput::seed));
        randomBits(count, chunk.paths.pixelKey, chunk.paths.sampleIndex, wave.vertex,
                   reinterpret_cast<std::uint32_t *>(seed));
    }
    drawNumbers(wave, lightPositionPair);
    if (directionsAt(wave) == 1)
        drawNumbers(wave, directionPair);
    // No camera path is deeper than the wave.
    if (wave.frame.scene.readsLightChoice() || wave.vertex + 1 >= rouletteDepth ||
        wave.purpose != Purpose::Camera)
        drawNumbers(wave, lightChoicePair);
}

/// The first two directions of a path are the first four dimensions of one sequence.
void drawNumbers(PathWave &wave, VertexPair pair) {
    VertexChunk &chunk = wave.chunk;
    const PathsAtVertices &paths = chunk.paths;
    float *x = chunk.numbers.x(pair), *y = chunk.numbers.y(pair);
    if (pair == directionPair && wave.vertex == 1)
        sobolFollowingPairs(chunk.count(), paths.pixelKey, paths.sampleIndex,
                            int(cameraPairs) + pair, x, y);
    else
        sobolPairs(chunk.count(), paths.pixelKey, paths.sampleIndex,
                   cameraPairs + wave.vertex * vertexPairs + pair, x, y);
}

} // namespace candela

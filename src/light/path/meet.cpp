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
    static_assert(colorSamples == 3);
    lanes::take(count, ray,
                {{active.throughput[0], paths.throughput[0]},
                 {active.throughput[1], paths.throughput[1]},
                 {active.throughput[2], paths.throughput[2]},
                 {active.slot, paths.slot},
                 {active.depth, paths.depth},
                 {active.seen, paths.seen},
                 {active.sampleIndex, paths.sampleIndex}});
    lanes::gather(count, paths.slot, wave.results.keys[0], paths.pixelKey);
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(paths.light[c], count, 0.0f);
}

} // namespace

void meet(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const int count = int(chunk.rays.size());
    chunk.vertices.meet(wave.frame.scene, chunk.code, wave.active.rays, wave.hits,
                        chunk.rays.data(), count);
    chunk.irradiance = nullptr;
    takePaths(wave, chunk.paths);
    if (chunk.vertices.code().reads(ShaderInput::seed)) {
        float *seed = chunk.vertices.points.input(int(ShaderInput::seed));
        randomBits(count, chunk.paths.pixelKey, chunk.paths.sampleIndex, wave.vertex,
                   reinterpret_cast<std::uint32_t *>(seed));
    }
    if (chunk.vertices.code().reads(ShaderInput::rayDepth))
        std::copy_n(chunk.paths.depth, count,
                    chunk.vertices.points.input(ShaderInput::rayDepth, 0));
    drawNumbers(wave, lightPositionPair);
    if (directionsAt(wave) == 1)
        drawNumbers(wave, directionPair);
    if (drawsLightChoice(wave))
        drawNumbers(wave, lightChoicePair);
}

bool drawsLightChoice(const PathWave &wave) {
    // No camera path is deeper than the wave.
    return wave.frame.scene.lights().readsChoice() || wave.vertex + 1 >= rouletteDepth ||
           wave.purpose != Purpose::Camera;
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

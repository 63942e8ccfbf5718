// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"

#include <cmath>

namespace candela {

namespace {

/// What is not finite is reported and left out.
void dropNonFinite(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    for (int c = 0; c < colorSamples; ++c)
        if (!lanes::allFinite(chunk.count(), chunk.paths.light[c]))
            for (int i = 0; i < chunk.count(); ++i)
                if (!std::isfinite(chunk.paths.light[c][i])) {
                    reportNonFinite(wave, i);
                    for (int k = 0; k < colorSamples; ++k)
                        chunk.paths.light[k][i] = 0;
                }
}

} // namespace

void deliver(PathWave &wave) {
    dropNonFinite(wave);
    const PathsAtVertices &paths = wave.chunk.paths;
    const int count = wave.chunk.count();
    for (int c = 0; c < colorSamples; ++c) {
        float *radiance = wave.results.radiance[c];
        const float *light = paths.light[c];
        if (slotsAreConsecutive(wave)) {
            lanes::add(count, light, radiance + paths.slot[0]);
            continue;
        }
        for (int i = 0; i < count; ++i)
            radiance[paths.slot[i]] += light[i];
    }
}

void reportNonFinite(PathWave &wave, int i) {
    const int slot = wave.chunk.paths.slot[i];
    int sample = wave.results.sampleIndex[slot];
    if (wave.purpose == Purpose::Gathering)
        sample /= GatheredLight::rounds;
    wave.frame.nonFinite.found(wave.chunk.vertices.code().name(), wave.results.x[slot],
                               wave.results.y[slot], sample);
}

} // namespace candela

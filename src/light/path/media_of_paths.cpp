// SPDX-License-Identifier: Apache-2.0
// How paths carry what they are in from surface to surface.
#include "foundation/base/lanes.h"
#include "light/path/steps.h"

#include <algorithm>
#include <cmath>

namespace candela {

void takeMedia(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const int *ray = chunk.rays.data(), count = chunk.count();
    const PathMedia &from = wave.active.media;
    const Planes<std::uint32_t> &around = chunk.vertices.around();
    lanes::take(count, ray, {{from.around[0], around[0]}, {from.around[1], around[1]}});
    for (int c = 0; c < colorSamples; ++c)
        lanes::take(count, ray,
                    {{from.veil[c], chunk.paths.veil[c]}, {from.cover[c], chunk.paths.cover[c]}});
}

void beginMedia(int count, PathMedia &media) {
    for (int word = 0; word < 2; ++word)
        std::fill_n(media.around[word], count, 0u);
    for (int c = 0; c < colorSamples; ++c) {
        lanes::fill(count, 0.0f, media.veil[c]);
        lanes::fill(count, 1.0f, media.cover[c]);
    }
}

void leaveMedia(PathWave &wave, const ConstVec3Planes &direction, int count, int first) {
    VertexChunk &chunk = wave.chunk;
    PathMedia &to = wave.next.media;
    for (int k = 0; k < count; ++k) {
        const int i = chunk.way.lane[k], at = first + k;
        const MediaAround around = chunk.vertices.mediaAlong(i, direction);
        to.around[0][at] = around.inner(), to.around[1][at] = around.outer();
        const SurfaceMedia &surface = chunk.vertices.mediaOf(i);
        to.air[at] = surface.atmosphere;
        to.entered[at] = chunk.vertices.leadsInside(i, direction) ? surface.interior : 0;
        const bool through = chunk.events.event()[i] == straightThrough;
        for (int c = 0; c < colorSamples; ++c) {
            const float passes =
                through ? (1 - chunk.vertices.prepared().Oi[c][i]) * chunk.way.gain[i] : 0.0f;
            to.veil[c][at] = chunk.paths.veil[c][i] * passes;
            to.cover[c][at] = chunk.paths.cover[c][i] * passes;
        }
    }
}

void weighOpacityBehind(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const PathsAtVertices &paths = chunk.paths;
    for (int i = 0; i < chunk.count(); ++i) {
        if (chunk.events.event()[i] != straightThrough)
            continue;
        float &brightest = chunk.way.brightest[i];
        for (int c = 0; c < colorSamples; ++c) {
            const float seen = paths.seen[i] ? paths.cover[c][i] : 0;
            const float worth = std::max(std::fabs(paths.veil[c][i]), seen);
            brightest = std::max(worth * (1 - chunk.vertices.prepared().Oi[c][i]), brightest);
        }
    }
}

} // namespace candela

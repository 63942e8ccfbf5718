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
                    reportNonFinite(wave, i, chunk.vertices.code().name());
                    for (int k = 0; k < colorSamples; ++k)
                        chunk.paths.light[k][i] = 0;
                }
}

/// Branches of a path share its slot, so one after the other.
void addBySlot(int count, const int *slot, const Planes<float> &light,
               const Planes<float> &radiance) {
    static_assert(colorSamples == 3);
    const float *red = light[0], *green = light[1], *blue = light[2];
    float *toRed = radiance[0], *toGreen = radiance[1], *toBlue = radiance[2];
    for (int i = 0; i < count; ++i) {
        const int at = slot[i];
        toRed[at] += red[i], toGreen[at] += green[i], toBlue[at] += blue[i];
    }
}

/// Nothing of them is seen.
void dropHeldOut(PathWave &wave) {
    PathsAtVertices &paths = wave.chunk.paths;
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < wave.chunk.count(); ++i)
            if (paths.heldOut[i])
                paths.light[c][i] = 0;
}

} // namespace

void deliver(PathWave &wave) {
    dropNonFinite(wave);
    if (wave.frame.scene.hasMatte())
        dropHeldOut(wave);
    const PathsAtVertices &paths = wave.chunk.paths;
    const Planes<float> &radiance = wave.results.radiance;
    const int count = wave.chunk.count();
    if (!slotsAreConsecutive(wave))
        return addBySlot(count, paths.slot, paths.light, radiance);
    for (int c = 0; c < colorSamples; ++c)
        lanes::add(count, paths.light[c], radiance[c] + paths.slot[0]);
}

void reportNonFinite(PathWave &wave, int i, const std::string &shader) {
    const int slot = wave.chunk.paths.slot[i];
    int sample = wave.results.sampleIndex[slot];
    if (wave.purpose == Purpose::Gathering)
        sample /= GatheredLight::rounds;
    const int x = wave.results.x[slot], y = wave.results.y[slot];
    wave.frame.nonFinite.found(shader, wave.frame.settings.atPoints
                                           ? "a vertex of the paths to point " + std::to_string(x)
                                           : "pixel (" + std::to_string(x) + ", " +
                                                 std::to_string(y) + "), sample " +
                                                 std::to_string(sample));
}

} // namespace candela

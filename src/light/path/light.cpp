// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "light/path/stages.h"
#include "light/sampling/mis.h"

#include <algorithm>

namespace candela {

namespace {

CANDELA_HOT void weighSamples(int count, const float *__restrict g, const float *__restrict value,
                              const float *__restrict factor, const std::int32_t *__restrict light,
                              float *__restrict result) {
    for (int i = 0; i < count; ++i)
        result[i] = (factor[i] > 0) & (light[i] != 0) ? g[i] * value[i] * factor[i] : 0.0f;
}

/// 1 where rays may be scattered along finite lobes.
CANDELA_HOT void markScattering(int count, const int *__restrict depth, int maxDepth,
                                const float *__restrict finiteProbability,
                                float *__restrict wanted) {
    for (int i = 0; i < count; ++i)
        wanted[i] = (depth[i] < maxDepth) & (finiteProbability[i] > 0) ? 1.0f : 0.0f;
}

/// The samples, and what they are worth beside directions of the mixture.
void sampleLights(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    DirectLight &direct = chunk.direct;
    LightSamples &samples = direct.sample.samples;
    const int count = chunk.count();
    const VertexNumbers &numbers = chunk.numbers;
    markScattering(count, chunk.paths.depth, wave.frame.settings.maxDepth,
                   chunk.events.finiteProbability(), direct.wanted);
    wave.frame.scene.sampleLights(
        lightQuery(chunk.vertices, chunk.N, direct.wanted,
                   {numbers.x(lightChoicePair), numbers.x(lightPositionPair),
                    numbers.y(lightPositionPair)}),
        samples);
    unitDirections(count, samples.L[0], samples.L[1], samples.L[2], direct.unit[0], direct.unit[1],
                   direct.unit[2]);
    chunk.mixture.pdf({direct.unit[0], direct.unit[1], direct.unit[2]}, direct.directionPdf);
    leaveToLightSampling(chunk.vertices.code(), count, samples.light, direct.directionPdf);
    lightSampleFactors(count, samples.pdfSolidAngle, direct.directionPdf,
                       chunk.events.finiteProbability(), direct.wanted, direct.factor);
}

} // namespace

DirectLight::DirectLight(int capacity)
    : sample(capacity), shadow(capacity), unit(3, capacity), response(colorSamples, capacity),
      contribution(colorSamples, capacity), floats(3, capacity), integers(3, capacity) {
    directionPdf = floats[0], wanted = floats[1], factor = floats[2];
    answered = integers[0], inShadow = integers[1], lanes = integers[2];
    std::fill_n(answered, integers.lanes(), finiteRequests);
}

void light(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    if (vertices.Ca(0))
        chunk.gather({vertices.Ca(0), vertices.Ca(1), vertices.Ca(2)});
    if (!wave.frame.scene.hasLights())
        return;
    sampleLights(wave);
    DirectLight &direct = chunk.direct;
    const LightSamples &samples = direct.sample.samples;
    const int count = chunk.count();
    std::array<float *, colorSamples> response, contribution;
    for (int c = 0; c < colorSamples; ++c)
        response[c] = direct.response[c], contribution[c] = direct.contribution[c];
    vertices.scatter({samples.L[0], samples.L[1], samples.L[2]}, direct.answered, samples.light,
                     response.data());
    for (int c = 0; c < colorSamples; ++c)
        weighSamples(count, response[c], samples.value[c], direct.factor, samples.light,
                     contribution[c]);
    const int rays =
        lanesInNeedOfShadowRays(count, samples, contribution.data(), direct.inShadow, direct.lanes);
    wave.frame.statistics.shadowRays +=
        direct.shadow.attenuate(vertices, samples, rays, direct.lanes, contribution.data());
    chunk.gather({contribution[0], contribution[1], contribution[2]});
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/solution_light.h"
#include "light/path/split.h"
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

/// Where light is wanted, and where rays are scattered along finite lobes, too.
CANDELA_HOT void markShallow(int count, const int *__restrict depth, int maxDepth,
                             const float *__restrict finiteTotal, float *__restrict wanted,
                             float *__restrict scattered) {
    for (int i = 0; i < count; ++i) {
        const bool shallow = depth[i] < maxDepth;
        wanted[i] = shallow ? 1.0f : 0.0f;
        scattered[i] = shallow & (finiteTotal[i] > 0) ? 1.0f : 0.0f;
    }
}

/// Of all `directions` together; none where none is followed.
CANDELA_HOT void densityOfAll(int count, float directions, const float *__restrict finiteTotal,
                              float *__restrict pdf) {
    for (int i = 0; i < count; ++i)
        pdf[i] = finiteTotal[i] > 0 ? pdf[i] * directions : 0.0f;
}

/// The samples, and what they are worth beside directions of the mixture.
void sampleLights(PathWave &wave, LightGroup group) {
    VertexChunk &chunk = wave.chunk;
    DirectLight &direct = chunk.direct;
    LightSamples &samples = direct.sample.samples;
    const int count = chunk.count();
    const VertexNumbers &numbers = chunk.numbers;
    wave.frame.scene.lights().sample(
        group,
        lightQuery(chunk.vertices, chunk.N, direct.scattered,
                   {numbers.x(lightChoicePair), numbers.x(lightPositionPair),
                    numbers.y(lightPositionPair)}),
        samples);
    unitDirections(count, samples.L[0], samples.L[1], samples.L[2], direct.unit[0], direct.unit[1],
                   direct.unit[2]);
    chunk.mixture.pdf({direct.unit[0], direct.unit[1], direct.unit[2]}, direct.directionPdf);
    densityOfAll(count, float(directionsAt(wave)), followedTotal(wave), direct.directionPdf);
    leaveToLightSampling(chunk.vertices.code(), count, samples.light, direct.directionPdf);
    lightSampleFactors(count, samples.pdfSolidAngle, direct.directionPdf, direct.wanted,
                       direct.factor);
    if (wave.subpaths)
        weighLightSamplesAmongAll(wave);
}

} // namespace

DirectLight::DirectLight(int capacity)
    : sample(capacity), shadow(capacity), unit(3, capacity), response(colorSamples, capacity),
      contribution(colorSamples, capacity), floats(4, capacity), integers(3, capacity) {
    directionPdf = floats[0], wanted = floats[1], factor = floats[2];
    scattered = floats[3];
    answered = integers[0], inShadow = integers[1], lanes = integers[2];
    std::fill_n(answered, integers.lanes(), finiteRequests);
}

namespace {

/// One sample of the group's lights at each vertex.
void lightFrom(PathWave &wave, LightGroup group) {
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    sampleLights(wave, group);
    DirectLight &direct = chunk.direct;
    const LightSamples &samples = direct.sample.samples;
    const int count = chunk.count();
    if (lanes::allEqual(count, samples.light, 0))
        return;
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

} // namespace

void light(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    if (vertices.prepared().Ca[0])
        chunk.gather(
            {vertices.prepared().Ca[0], vertices.prepared().Ca[1], vertices.prepared().Ca[2]});
    markShallow(chunk.count(), chunk.paths.depth, wave.frame.settings.maxDepth, followedTotal(wave),
                chunk.direct.wanted, chunk.direct.scattered);
    if (wave.solution)
        leaveToSolution(wave, chunk.direct.wanted);
    for (LightGroup group : wave.frame.scene.lights().groupsInUse())
        lightFrom(wave, group);
}

} // namespace candela

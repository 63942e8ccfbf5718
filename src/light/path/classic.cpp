// SPDX-License-Identifier: Apache-2.0
// The stages of `classic` alone.
#include "foundation/base/hot.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/mis.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Paths that carry more than this are followed along all their branches, at so many vertices.
constexpr float leastToSplit = 1.0f / 256;
constexpr int splittingVertices = 8;

CANDELA_HOT void weighRow(int count, const float *__restrict value, const float *__restrict factor,
                          const std::int32_t *__restrict light, float *__restrict Cl) {
    for (int i = 0; i < count; ++i)
        Cl[i] = light[i] != 0 ? value[i] * factor[i] : 0.0f;
}

/// One sample of a light at every vertex, with its shadow.
void sampleRow(PathWave &wave, int light) {
    VertexChunk &chunk = wave.chunk;
    ClassicLight &classic = *wave.classic;
    LightSamples &samples = classic.sample.samples;
    const int count = chunk.count();
    const VertexNumbers &numbers = chunk.numbers;
    const float *u = numbers.x(lightPositionPair), *v = numbers.y(lightPositionPair);
    wave.frame.scene.lights().sampleOne(
        light, lightQuery(chunk.vertices, chunk.N, nullptr, {u, u, v}), samples);
    lightSampleFactors(count, samples.pdfSolidAngle, classic.none[0], classic.wanted,
                       classic.factor);
    const MutableVec3Planes L = classic.rows.L(light);
    for (int c = 0; c < 3; ++c)
        std::copy_n(samples.L[c], count, L[c]);
    std::copy_n(samples.light, count, classic.rows.light(light));
    const std::array<float *, colorSamples> Cl = classic.rows.Cl(light);
    for (int c = 0; c < colorSamples; ++c)
        weighRow(count, samples.value[c], classic.factor, samples.light, Cl[c]);
    const int rays =
        lanesInNeedOfShadowRays(count, samples, Cl.data(), classic.inShadow, classic.lanes);
    wave.frame.statistics.shadowRays +=
        classic.shadow.attenuate(chunk.vertices, samples, rays, classic.lanes, Cl.data());
}

} // namespace

void lightClassic(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    if (!wave.classic)
        wave.classic = std::make_unique<ClassicLight>(VertexChunk::capacity);
    ClassicLight &classic = *wave.classic;
    chunk.N = {classic.none[0], classic.none[0], classic.none[0]};
    std::fill_n(classic.wanted, chunk.count(), 1.0f);
    const int lights = wave.frame.scene.lights().count();
    classic.rows.reserve(lights, chunk.vertices.lanes());
    for (int light = 0; light < lights; ++light)
        sampleRow(wave, light);
    std::array<float *, colorSamples> Ci, Oi;
    for (int c = 0; c < colorSamples; ++c)
        Ci[c] = classic.Ci[c], Oi[c] = classic.Oi[c];
    chunk.vertices.shade(lights, classic.rows.L(0).data(), classic.rows.Cl(0).data(),
                         classic.rows.light(0), chunk.ambient, Ci.data(), Oi.data());
    chunk.gather({Ci[0], Ci[1], Ci[2]});
}

void branch(PathWave &wave) {
    wave.chunk.events.look(wave.chunk.vertices);
    beginEvents(wave, nullptr);
    followEvents(wave, {leastToSplit, leastToSplit, splittingVertices});
}

} // namespace candela

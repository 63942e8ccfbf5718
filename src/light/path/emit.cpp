// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/mis.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Of the rays that met lamps, where they began and what they left there.
void takeOrigins(const PathWave &wave, EmissionPlanes &emission) {
    const int *ray = wave.chunk.rays.data(), count = wave.chunk.count();
    const RayOrigins &from = wave.active.left;
    RayOrigins &to = emission.left;
    const std::array<float *, 3> &origin = wave.active.rays.origin;
    lanes::take(count, ray,
                {{from.pdf, to.pdf},
                 {from.lightSet, to.lightSet},
                 {from.code, to.code},
                 {from.N[0], to.N[0]},
                 {from.N[1], to.N[1]},
                 {from.N[2], to.N[2]},
                 {origin[0], emission.origin[0]},
                 {origin[1], emission.origin[1]},
                 {origin[2], emission.origin[2]}});
}

/// Whether directions from a vertex of that shader may bring the light, and all lights. Sensors
/// have no shader and no wishes.
bool hearsAsIndirect(const Scene &scene, int code, std::int32_t light) {
    return code < 0 ? !scene.lights().areLeftToSamples()
                    : scene.code(code).categories().hearsAsIndirect(light);
}
bool hearsAllAsIndirect(const Scene &scene, int code) {
    return code < 0 ? !scene.lights().areLeftToSamples()
                    : scene.code(code).categories().hearsAllAsIndirect();
}

} // namespace

void leaveOutUnheard(const Scene &scene, int count, const std::int32_t *light,
                     const RayOrigins &left, float *weight) {
    for (int i = 0; i < count; ++i)
        if (light[i] != 0 && left.pdf[i] > 0 &&
            !(scene.lights().isOn(left.lightSet[i], light[i]) &&
              hearsAsIndirect(scene, left.code[i], light[i])))
            weight[i] = 0;
}

void markHeard(const Scene &scene, int count, const RayOrigins &left, float *heard) {
    for (int i = 0; i < count; ++i)
        heard[i] = left.pdf[i] > 0 && hearsAllAsIndirect(scene, left.code[i]) ? 1.0f : 0.0f;
}

void emit(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    ShadingPoints &points = chunk.vertices.points;
    const int count = chunk.count();
    if (lanes::allEqual(count, points.light, 0))
        return;
    EmissionPlanes &emission = chunk.emission;
    std::array<float *, colorSamples> radiance;
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c] = emission.radiance[c], count, 0.0f);
    wave.frame.scene.lights().emission(chunk.code, points, radiance.data());

    takeOrigins(wave, emission);
    const RayOrigins &left = emission.left;
    float *lightPdf = emission.lightPdf[0], *weight = emission.weight[0];
    LightQuery asked;
    asked.count = count;
    asked.P = {emission.origin[0], emission.origin[1], emission.origin[2]};
    asked.N = {left.N[0], left.N[1], left.N[2]};
    asked.lightSet = left.lightSet;
    asked.time = points.input(int(ShaderInput::time));
    markHeard(wave.frame.scene, count, left, emission.heard[0]);
    asked.scattered = emission.heard[0];
    const MutableVec3Planes met{emission.met[0], emission.met[1], emission.met[2]};
    wave.frame.scene.elementPoints(wave.active.rays, wave.hits, chunk.rays.data(), count, met);
    wave.frame.scene.lights().density(asked, points, {met[0], met[1], met[2]}, lightPdf);
    emissionWeights(count, left.pdf, lightPdf, weight);
    if (wave.subpaths)
        weighEmissionAmongAll(wave, weight);
    leaveOutUnheard(wave.frame.scene, count, points.light, left, weight);
    for (float *plane : radiance)
        lanes::multiply(count, weight, plane);
    chunk.gather({radiance[0], radiance[1], radiance[2]});
}

} // namespace candela

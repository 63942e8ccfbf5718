// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/sampling/mis.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// pdf[i] of the direction towards point i on a lamp, per steradian at P: that per unit area over
/// distance and cosine.
CANDELA_HOT void densityFromArea(int count, const ConstVec3Planes &P, const ConstVec3Planes &lamp,
                                 const ConstVec3Planes &Ng, const float *__restrict areaPdf,
                                 float *__restrict pdf) {
    const float *__restrict px = P[0], *__restrict py = P[1], *__restrict pz = P[2];
    const float *__restrict qx = lamp[0], *__restrict qy = lamp[1], *__restrict qz = lamp[2];
    const float *__restrict nx = Ng[0], *__restrict ny = Ng[1], *__restrict nz = Ng[2];
#pragma GCC ivdep // Planes are apart; there are too many to compare.
    for (int i = 0; i < count; ++i) {
        const float x = qx[i] - px[i], y = qy[i] - py[i], z = qz[i] - pz[i];
        const float squared = x * x + y * y + z * z;
        const float height = std::fabs(x * nx[i] + y * ny[i] + z * nz[i]);
        const float normal = std::sqrt(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
        const float cosine = height / (std::sqrt(squared) * normal);
        pdf[i] = areaPdf[i] * squared / (cosine > 1e-9f ? cosine : 1e-9f);
    }
}

/// The density with which light sampling at P, with the normal N and the lights of lightSet, would
/// have chosen the points on lamps.
void lightDensity(int count, const ConstVec3Planes &P, const ConstVec3Planes &,
                  const std::int32_t *, ShadingPoints &points, float *pdfSolidAngle) {
    auto planes = [&](ShaderInput input) {
        const int at = int(input);
        return ConstVec3Planes{points.input(at), points.input(at + 1), points.input(at + 2)};
    };
    densityFromArea(count, P, planes(ShaderInput::P), planes(ShaderInput::Ng), points.lightPdfArea,
                    pdfSolidAngle);
}

/// Of the rays that met lamps, where they began and what they left there.
void takeOrigins(const PathWave &wave, EmissionPlanes &emission) {
    const int *ray = wave.chunk.rays.data(), count = wave.chunk.count();
    const RayOrigins &from = wave.active.left;
    RayOrigins &to = emission.left;
    lanes::take(count, ray, from.pdf, to.pdf);
    lanes::take(count, ray, from.lightSet, to.lightSet);
    lanes::take(count, ray, from.code, to.code);
    for (int c = 0; c < 3; ++c) {
        lanes::take(count, ray, from.N[c], to.N[c]);
        lanes::take(count, ray, wave.active.rays.origin[c], emission.origin[c]);
    }
}

/// Directions bring nothing of lamps that are off for the vertex they left, or that its shader
/// hears by samples of the light alone.
void leaveOutUnheard(const Scene &scene, int count, const std::int32_t *light,
                     const RayOrigins &left, float *weight) {
    for (int i = 0; i < count; ++i)
        if (light[i] != 0 && left.pdf[i] > 0 &&
            !(scene.lightIsOn(left.lightSet[i], light[i]) &&
              scene.code(left.code[i]).hearsAsIndirect(light[i])))
            weight[i] = 0;
}

} // namespace

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
    wave.frame.scene.emission(chunk.code, points, radiance.data());

    takeOrigins(wave, emission);
    const RayOrigins &left = emission.left;
    float *lightPdf = emission.lightPdf[0], *weight = emission.weight[0];
    lightDensity(count, {emission.origin[0], emission.origin[1], emission.origin[2]},
                 {left.N[0], left.N[1], left.N[2]}, left.lightSet, points, lightPdf);
    emissionWeights(count, left.pdf, lightPdf, weight);
    leaveOutUnheard(wave.frame.scene, count, points.light, left, weight);
    for (float *plane : radiance)
        lanes::multiply(count, weight, plane);
    chunk.gather({radiance[0], radiance[1], radiance[2]});
}

} // namespace candela

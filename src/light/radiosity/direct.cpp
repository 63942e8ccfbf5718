// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/direct.h"

#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

DirectQuestion::DirectQuestion()
    : vertices_(capacity), sample_(capacity), shadow_(capacity), I_(3, capacity),
      numbers_(4, capacity), light_(colorSamples, capacity), needed_(2, capacity + laneBlock),
      index_(1, capacity) {
    vertices_.speak(false);
}

void DirectQuestion::ask(const Scene &scene, int code, const SurfacePlaces &places,
                         const Vec3Planes &Ng, const std::uint32_t *key, int samples,
                         std::span<const std::uint8_t> leftOut, float *const *E) {
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(E[c], places.count, 0.0f);
    if (std::ranges::find(leftOut, 0) == leftOut.end())
        return;
    const Vec3Planes I{I_[0], I_[1], I_[2]};
    for (int i = 0; i < places.count; ++i)
        I.set(i, -Ng.get(i));
    vertices_.place(scene, code, places, I, scene.options().camera.shutterOpen);
    for (int s = 0; s < samples; ++s) {
        std::fill_n(index_[0], places.count, std::uint32_t(s));
        sobolPairs(places.count, key, index_[0], 0, numbers_[0], numbers_[1]);
        sobolPairs(places.count, key, index_[0], 1, numbers_[2], numbers_[3]);
        for (LightGroup group : scene.lights().groupsInUse())
            addSample(group, 1 / float(samples), leftOut, E);
    }
}

void DirectQuestion::addSample(LightGroup group, float share, std::span<const std::uint8_t> leftOut,
                               float *const *E) {
    constexpr float pi = std::numbers::pi_v<float>;
    const int count = vertices_.count();
    LightSamples &samples = sample_.samples;
    const ConstVec3Planes N = vertices_.facingPlanes();
    vertices_.scene().lights().sample(
        group, lightQuery(vertices_, N, nullptr, {numbers_[2], numbers_[0], numbers_[1]}), samples);
    float *light[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        light[c] = light_[c];
    for (int i = 0; i < count; ++i) {
        const Vec3 L{samples.L[0][i], samples.L[1][i], samples.L[2][i]};
        const float along = N[0][i] * L.x + N[1][i] * L.y + N[2][i] * L.z;
        const float cosine = along > 0 ? along / length(L) : 0;
        const float pdf = samples.pdfSolidAngle[i];
        const int source = samples.light[i];
        const bool counts = source > 0 && leftOut[std::size_t(source) - 1] == 0;
        const float weight = counts ? cosine * (pdf > 0 ? 1 / pdf : pi) : 0;
        for (int c = 0; c < colorSamples; ++c)
            light[c][i] = weight > 0 ? weight * samples.value[c][i] * share : 0.0f;
    }
    const int rays = lanesInNeedOfShadowRays(count, samples, light, needed_[0], needed_[1]);
    shadow_.attenuate(vertices_, samples, rays, needed_[1], light);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            if (std::isfinite(light[c][i]))
                E[c][i] += light[c][i];
}

} // namespace candela::radiosity

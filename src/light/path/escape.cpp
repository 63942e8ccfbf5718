// SPDX-License-Identifier: Apache-2.0
#include "light/path/escape.h"

#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/path/subpath.h"
#include "light/sampling/mis.h"
#include "light/vertex/vectors.h"
#include "world/scene/light_starts.h"

#include <algorithm>

namespace candela {

namespace {

/// Those that the camera sees along show the background.
void findEscaping(PathWave &wave, std::vector<int> &rays) {
    rays.clear();
    for (int i = 0; i < wave.active.count; ++i)
        if (wave.hits.shape[i] == noHit && wave.active.seen[i] == 0)
            rays.push_back(i);
}

void takeRays(const PathWave &wave, const int *ray, int count, EscapingRays &own) {
    const ActivePaths &active = wave.active;
    const RayOrigins &from = active.left;
    const auto &[ox, oy, oz] = active.rays.origin;
    const auto &[dx, dy, dz] = active.rays.direction;
    lanes::take(count, ray,
                {{from.pdf, own.left.pdf},
                 {from.lightSet, own.left.lightSet},
                 {from.code, own.left.code},
                 {from.N[0], own.left.N[0]},
                 {from.N[1], own.left.N[1]},
                 {from.N[2], own.left.N[2]},
                 {ox, own.origin[0]},
                 {oy, own.origin[1]},
                 {oz, own.origin[2]},
                 {dx, own.direction[0]},
                 {dy, own.direction[1]},
                 {dz, own.direction[2]},
                 {active.rays.time, own.time}});
    const std::int32_t setOfAll = wave.frame.scene.lights().setOfAll();
    for (int i = 0; i < count; ++i) {
        own.lightSet[i] = own.left.lightSet[i] < 0 ? setOfAll : own.left.lightSet[i];
        for (int c = 0; c < 3; ++c)
            own.againstDirection[c][i] = -own.direction[c][i];
    }
}

/// The weights of one light's radiance, in own.answer, among all that find it.
void weigh(PathWave &wave, const int *ray, const LightQuery &query, std::int32_t light,
           EscapingRays &own) {
    const Lights lights = wave.frame.scene.lights();
    const int count = query.count;
    for (int i = 0; i < count; ++i)
        own.lightPdf[i] = own.answer.probability[i] * own.answer.directionPdf[i];
    emissionWeights(count, own.left.pdf, own.lightPdf, own.weight);
    lanes::fill(count, light, own.light);
    if (wave.subpaths) {
        lights.startDensities(count, own.light, constant(own.againstDirection), own.noNormal,
                              query.P, wave.frame.guide, {own.startPosition, own.startDirection});
        for (int i = 0; i < count; ++i)
            own.weight[i] = weightAmongLightPaths(
                wave, ray[i], own.weight[i],
                double(own.startPosition[i]) * own.answer.directionPdf[i], own.startDirection[i]);
    }
    leaveOutUnheard(wave.frame.scene, count, own.light, own.left, own.weight);
    if (!lights.castsShadow(light)) // Samples find it through what stops the rays.
        for (int i = 0; i < count; ++i)
            if (own.left.pdf[i] > 0)
                own.weight[i] = 0;
}

/// It joins what the paths have gathered; branches of a path share its slot.
void deliverTo(PathWave &wave, const int *ray, int count, const EscapingRays &own) {
    const ActivePaths &active = wave.active;
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            wave.results.radiance[c][active.slot[ray[i]]] +=
                active.throughput[c][ray[i]] * own.weight[i] * own.radiance[c][i];
}

} // namespace

EscapingRays::EscapingRays()
    : left(capacity), floats(18, capacity), radiance(colorSamples, capacity),
      integers(2, capacity) {
    origin = {floats[0], floats[1], floats[2]}, direction = {floats[3], floats[4], floats[5]};
    againstDirection = {floats[6], floats[7], floats[8]};
    time = floats[9], heard = floats[10], lightPdf = floats[11], weight = floats[12];
    startPosition = floats[13], startDirection = floats[14];
    answer.probability = floats[15], answer.directionPdf = floats[16];
    std::fill_n(floats[17], capacity, 0.0f);
    noNormal = {floats[17], floats[17], floats[17]};
    for (int c = 0; c < colorSamples; ++c)
        answer.radiance[c] = radiance[c];
    lightSet = integers[0], light = integers[1];
}

void escape(PathWave &wave) {
    const Lights lights = wave.frame.scene.lights();
    if (wave.purpose == Purpose::Light || lights.skies().empty())
        return;
    if (!wave.escaping)
        wave.escaping = std::make_unique<EscapingRays>();
    EscapingRays &own = *wave.escaping;
    findEscaping(wave, own.all);
    for (std::size_t first = 0; first < own.all.size(); first += EscapingRays::capacity) {
        const int *ray = own.all.data() + first;
        LightQuery query;
        query.count = int(std::min<std::size_t>(own.all.size() - first, EscapingRays::capacity));
        takeRays(wave, ray, query.count, own);
        query.P = query.Ps = constant(own.origin);
        query.N = {own.left.N[0], own.left.N[1], own.left.N[2]};
        markHeard(wave.frame.scene, query.count, own.left, own.heard);
        query.scattered = own.heard;
        query.lightSet = own.lightSet, query.time = own.time;
        for (const std::int32_t light : lights.skies()) {
            lights.sky(light, query, constant(own.direction), own.answer);
            weigh(wave, ray, query, light, own);
            deliverTo(wave, ray, query.count, own);
        }
    }
}

} // namespace candela

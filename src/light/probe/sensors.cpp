// SPDX-License-Identifier: Apache-2.0
#include "light/probe/sensors.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/mis.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

constexpr float pi = float(M_PI);
constexpr int chunkSize = VertexChunk::capacity;

/// The slots [first, first + count).
struct Part {
    ProbeSlots &slots;
    int first, count;

    ConstVec3Planes of(const MutableVec3Planes &planes) const {
        return {planes[0] + first, planes[1] + first, planes[2] + first};
    }
    /// The sensor is the first vertex of its samples' paths: its numbers are those of vertex 0, so
    /// that its directions and those at the next vertex are stratified together.
    void draw(VertexPair pair, float *x, float *y) const {
        sobolPairs(count, slots.pixelKey + first, slots.sampleIndex + first,
                   std::uint32_t(int(cameraPairs) + pair), x, y);
    }
};

/// The light of samples times the cosine at the sensor; 0 where there is none or it comes from
/// behind.
CANDELA_HOT void receive(int count, const float *__restrict factor,
                         const std::int32_t *__restrict light, const float *__restrict nx,
                         const float *__restrict ny, const float *__restrict nz,
                         const float *__restrict x, const float *__restrict y,
                         const float *__restrict z, float *__restrict value) {
    for (int i = 0; i < count; ++i) {
        const float cosine = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i];
        const bool counts = (factor[i] > 0) & (light[i] != 0) & (cosine > 0);
        value[i] = counts ? value[i] * factor[i] * cosine : 0.0f;
    }
}

/// Lambert's cosine over the density it was drawn with: pi, but for rounding.
CANDELA_HOT void weighDirections(int count, const float *__restrict pdf, const float *__restrict nx,
                                 const float *__restrict ny, const float *__restrict nz,
                                 const float *__restrict x, const float *__restrict y,
                                 const float *__restrict z, float *__restrict weight) {
    for (int i = 0; i < count; ++i) {
        const float cosine = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i];
        weight[i] = (pdf[i] > 0) & (cosine > 0) ? cosine / pdf[i] : 0.0f;
    }
}

CANDELA_HOT void addTimes(int count, const float *__restrict value, float factor,
                          float *__restrict sum) {
    for (int i = 0; i < count; ++i)
        sum[i] += value[i] * factor;
}

LightQuery queryOf(const Part &part, const SensorLight &work) {
    LightQuery query;
    query.count = part.count;
    query.P = part.of(part.slots.origin);
    query.Ps = part.of(part.slots.Ps);
    query.N = query.Ns = part.of(part.slots.aim);
    query.scattered = work.sharesWithDirections ? work.one : nullptr;
    query.lightSet = work.lightSet;
    query.time = part.slots.time + part.first;
    query.choice = work.choice;
    query.position = {work.u, work.v};
    return query;
}

/// What the light samples in hand bring joins the slots' values.
void addSamples(PathWave &wave, const Part &part, SensorLight &work) {
    const Scene &scene = wave.frame.scene;
    LightSamples &samples = work.sample.samples;
    const Planes<float> &unit = work.unit;
    const int count = part.count;
    const ConstVec3Planes N = part.of(part.slots.aim);
    unitDirections(count, samples.L[0], samples.L[1], samples.L[2], unit[0], unit[1], unit[2]);
    std::fill_n(work.directionPdf, count, 0.0f);
    if (work.sharesWithDirections)
        work.mixture.pdf({unit[0], unit[1], unit[2]}, work.directionPdf);
    lightSampleFactors(count, samples.pdfSolidAngle, work.directionPdf, work.one, work.factor);
    for (float *value : samples.value)
        receive(count, work.factor, samples.light, N[0], N[1], N[2], unit[0], unit[1], unit[2],
                value);
    const int shadowed =
        lanesInNeedOfShadowRays(count, samples, samples.value.data(), work.inShadow, work.shadowed);
    const FreePoints from{scene,
                          count,
                          part.of(part.slots.origin),
                          part.slots.time + part.first,
                          work.around[0],
                          work.around[1],
                          work.air};
    wave.frame.statistics.shadowRays +=
        work.shadow.attenuate(from, samples, shadowed, work.shadowed, samples.value.data());
    for (int c = 0; c < colorSamples; ++c) // Cl is radiance of a white diffuser: E / pi.
        addTimes(count, samples.value[c], pi, part.slots.value[c] + part.first);
}

void addAmbient(const Scene &scene, const Part &part, SensorLight &work) {
    if (!scene.lights().hasAmbient())
        return;
    std::array<float *, colorSamples> ambient;
    for (int c = 0; c < colorSamples; ++c)
        ambient[c] = work.ambient[c];
    scene.lights().ambient(queryOf(part, work), ambient.data());
    for (int c = 0; c < colorSamples; ++c)
        addTimes(part.count, ambient[c], pi, part.slots.value[c] + part.first);
}

/// Direct light.
void lightSensors(PathWave &wave, const Part &part, SensorLight &work) {
    const Scene &scene = wave.frame.scene;
    const Lights lights = scene.lights();
    const ConstVec3Planes N = part.of(part.slots.aim);
    work.mixture.state(part.count,
                       {{N, work.hemisphere, work.one, work.one, work.hemisphere, 0, true, true}},
                       N, nullptr);
    part.draw(lightPositionPair, work.u, work.v);
    part.draw(lightChoicePair, work.choice, work.ignored);
    const LightQuery query = queryOf(part, work);
    if (scene.isClassic()) {
        for (int light = 0; light < lights.count(); ++light) {
            lights.sampleOne(light, query, work.sample.samples);
            addSamples(wave, part, work);
        }
        return;
    }
    for (LightGroup group : lights.groupsInUse()) {
        lights.sample(group, query, work.sample.samples);
        addSamples(wave, part, work);
    }
}

/// Directions to look along for more. The mixture is that of the same sensors.
void drawDirections(const Part &part, SensorLight &work, ProbeRays &rays) {
    float *const to[3] = {rays.direction[0] + part.first, rays.direction[1] + part.first,
                          rays.direction[2] + part.first};
    part.draw(directionPair, work.u, work.v);
    work.mixture.sample(work.u, work.v, {to[0], to[1], to[2]});
    work.mixture.pdf({to[0], to[1], to[2]}, rays.pdf + part.first);
}

/// Paths begin at all slots along `direction`, from a vertex of that normal where it has one.
void start(PathWave &wave, const ProbeSlots &slots, const ProbeRays &rays,
           const ConstVec3Planes &direction, const ConstVec3Planes &N) {
    startGathering(wave, slots.count, rays.lane,
                   {{slots.origin[0], slots.origin[1], slots.origin[2]},
                    direction,
                    N,
                    slots.time,
                    rays.width,
                    rays.spread,
                    rays.pdf,
                    rays.depth,
                    rays.lightSet,
                    -1,
                    nullptr,
                    slots.point,
                    slots.point,
                    slots.pixelKey,
                    slots.sampleIndex});
    wave.frame.statistics.paths += std::uint64_t(slots.count);
}

} // namespace

ProbeSlots::ProbeSlots()
    : floats(10, capacity), integers(1, capacity), keys(2, capacity),
      value(colorSamples, capacity) {
    for (int c = 0; c < 3; ++c)
        Ps[c] = floats[c], origin[c] = floats[3 + c], aim[c] = floats[6 + c];
    time = floats[9];
    point = integers[0];
    pixelKey = keys[0], sampleIndex = keys[1];
}

SensorLight::SensorLight()
    : mixture(chunkSize), sample(chunkSize), shadow(chunkSize), floats(8, chunkSize),
      unit(3, chunkSize), ambient(colorSamples, chunkSize), integers(4, chunkSize + laneBlock),
      around(2, chunkSize) {
    one = floats[0], hemisphere = floats[1];
    choice = floats[2], u = floats[3], v = floats[4], ignored = floats[5];
    directionPdf = floats[6], factor = floats[7];
    lightSet = integers[0], air = integers[1], inShadow = integers[2], shadowed = integers[3];
    std::fill_n(one, chunkSize, 1.0f);
    std::fill_n(hemisphere, chunkSize, 180.0f);
}

ProbeRays::ProbeRays()
    : direction(3, ProbeSlots::capacity), none(1, ProbeSlots::capacity),
      floats(3, ProbeSlots::capacity), integers(3, ProbeSlots::capacity) {
    pdf = floats[0], width = floats[1], spread = floats[2];
    lane = integers[0], depth = integers[1], lightSet = integers[2];
    std::iota(lane, lane + ProbeSlots::capacity, 0);
    std::fill_n(depth, ProbeSlots::capacity, -1); // A sensor scatters nothing.
}

void measureIrradiance(PathWave &wave, ProbeSlots &slots, SensorLight &work, ProbeRays &rays,
                       SensorTakes takes) {
    const Scene &scene = wave.frame.scene;
    const bool looksAround = takes == SensorTakes::All && !scene.isClassic();
    work.sharesWithDirections = looksAround && !scene.lights().areLeftToSamples();
    std::fill_n(work.lightSet, chunkSize, scene.lights().setOfAll());
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(slots.value[c], slots.count, 0.0f);
    for (int first = 0; first < slots.count; first += chunkSize) {
        const Part part{slots, first, std::min(chunkSize, slots.count - first)};
        addAmbient(scene, part, work);
        if (takes != SensorTakes::Ambient)
            lightSensors(wave, part, work);
        if (looksAround)
            drawDirections(part, work, rays);
    }
    if (!looksAround)
        return;
    std::fill_n(rays.lightSet, slots.count, scene.lights().setOfAll());
    spreadOfDirections(slots.count, rays.pdf, rays.spread);
    const ConstVec3Planes direction{rays.direction[0], rays.direction[1], rays.direction[2]};
    const ConstVec3Planes N{slots.aim[0], slots.aim[1], slots.aim[2]};
    start(wave, slots, rays, direction, N);
    follow(wave, 1);
    float *weight = rays.width; // Is 0 again for the next ones.
    weighDirections(slots.count, rays.pdf, N[0], N[1], N[2], direction[0], direction[1],
                    direction[2], weight);
    for (int c = 0; c < colorSamples; ++c)
        lanes::multiplyAdd(slots.count, weight, wave.results.radiance[c], slots.value[c]);
    std::fill_n(weight, slots.count, 0.0f);
}

void measureRadiance(PathWave &wave, ProbeSlots &slots, ProbeRays &rays) {
    std::fill_n(rays.lightSet, slots.count, -1); // pdf and spread are 0 ever since.
    const ConstVec3Planes none{rays.none[0], rays.none[0], rays.none[0]};
    start(wave, slots, rays, {slots.aim[0], slots.aim[1], slots.aim[2]}, none);
    follow(wave);
    for (int c = 0; c < colorSamples; ++c)
        std::copy_n(wave.results.radiance[c], slots.count, slots.value[c]);
}

} // namespace candela

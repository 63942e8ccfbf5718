// SPDX-License-Identifier: Apache-2.0
#include "light/path/light_in_volumes.h"

#include "foundation/base/hash.h"
#include "foundation/base/lanes.h"
#include "light/sampling/mis.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

enum PointPair { onLightPair, lightPair };

/// Shadow rays from a point on the surface that ends the segment start off it, as from the surface
/// itself (docs/ray-offset.md), on the side that the segment lies on.
Vec3 outsideZone(SurfaceVertices &vertices, int i, Vec3 P) {
    const auto at = [i](const ConstVec3Planes &p) { return Vec3{p[0][i], p[1][i], p[2][i]}; };
    const Vec3 N = at(vertices.facingPlanes());
    const float height = dot(P - at(vertices.P()), N), zone = vertices.points.offset[i];
    return std::abs(height) < zone ? P + N * (zone - height) : P;
}

/// Up to a block of the points: where they are, what they are in, and their numbers. Samples of a
/// pixel belong to a sequence at each of the points that a segment asks for in turn.
void takePoints(PathWave &wave, const Crossing &crossing, int first, int count) {
    const VolumeLights &lights = crossing.lights;
    const PointLight &to = crossing.point;
    SurfaceVertices &vertices = wave.chunk.vertices;
    const float *time = vertices.points.input(int(ShaderInput::time));
    const std::uint64_t salt = std::uint64_t(wave.vertex + 1) << 48;
    for (int k = 0; k < count; ++k) {
        const int point = crossing.order[std::size_t(first + k)];
        const int i = lights.lane(point);
        const Vec3 P = outsideZone(vertices, i, lights.point(point));
        to.P[0][k] = P.x, to.P[1][k] = P.y, to.P[2][k] = P.z;
        to.time[k] = time[i];
        to.lightSet[k] = vertices.mediaOf(i).lightSet;
        to.inner[k] = crossing.around[0][i], to.outer[k] = crossing.around[1][i];
        to.atmosphere[k] = crossing.atmosphere[0][i];
        const std::uint64_t ordinal = std::uint64_t(lights.ordinal(point)) << 32;
        to.key[k] = std::uint32_t(mixBits(salt ^ ordinal ^ wave.chunk.paths.pixelKey[i]) >> 32);
        to.sampleIndex[k] = wave.chunk.paths.sampleIndex[i];
    }
    sobolPairs(count, to.key, to.sampleIndex, onLightPair, to.u, to.v);
    sobolPairs(count, to.key, to.sampleIndex, lightPair, to.choice, to.ignored);
}

LightQuery queryOf(const PointLight &points, int count) {
    LightQuery query;
    query.count = count;
    query.P = query.Ps = {points.P[0], points.P[1], points.P[2]};
    query.N = {points.none, points.none, points.none};
    query.lightSet = points.lightSet;
    query.time = points.time;
    query.choice = points.choice;
    query.position = {points.u, points.v};
    return query;
}

/// Every light in turn; of many under `path`, one of each group.
struct LightsInRows {
    explicit LightsInRows(const Scene &scene)
        : lights(scene.lights()),
          every(scene.isClassic() || lights.count() <= Crossing::everyLight) {}

    int rows() const { return every ? lights.count() : int(lights.groupsInUse().size()); }
    void sample(int row, const LightQuery &query, LightSamples &samples) const {
        if (every)
            lights.sampleOne(row, query, samples);
        else
            lights.sample(lights.groupsInUse()[std::size_t(row)], query, samples);
    }

    Lights lights;
    bool every;
};

/// A sample for each of the points [first, first + count), with its shadow.
void lightRow(PathWave &wave, Crossing &crossing, const LightsInRows &rows, int row, int first,
              int count) {
    PointLight &points = crossing.point;
    LightSamples &samples = points.sample.samples;
    LightQuery query = queryOf(points, count);
    if (rows.every)
        query.choice = points.u;
    rows.sample(row, query, samples);
    lightSampleFactors(count, samples.pdfSolidAngle, points.none, points.wanted, points.factor);
    for (int c = 0; c < colorSamples; ++c)
        for (int k = 0; k < count; ++k)
            samples.value[c][k] *= samples.light[k] != 0 ? points.factor[k] : 0.0f;
    const int shadowed = lanesInNeedOfShadowRays(count, samples, samples.value.data(),
                                                 points.inShadow, points.lanes);
    const FreePoints from{wave.frame.scene, count,        {points.P[0], points.P[1], points.P[2]},
                          points.time,      points.inner, points.outer,
                          points.atmosphere};
    wave.frame.statistics.shadowRays +=
        points.shadow.attenuate(from, samples, shadowed, points.lanes, samples.value.data());
    for (int k = 0; k < count; ++k) {
        std::array<float, colorSamples> Cl;
        for (std::size_t c = 0; c < colorSamples; ++c)
            Cl[c] = samples.value[c][k];
        crossing.lights.set(row, crossing.order[std::size_t(first + k)],
                            {samples.L[0][k], samples.L[1][k], samples.L[2][k]}, Cl,
                            samples.light[k]);
    }
}

/// Segment by segment, whatever the lanes are in which they have been asked: so rays share packets
/// with the same ones at every lane width.
void orderPoints(Crossing &crossing) {
    const VolumeLights &lights = crossing.lights;
    std::vector<int> &order = crossing.order;
    order.clear();
    for (int k = lights.lit(); k < lights.points(); ++k)
        order.push_back(k);
    std::ranges::sort(order, {},
                      [&](int k) { return std::pair(lights.lane(k), lights.ordinal(k)); });
}

/// Lights the points that wait for it.
void lightPoints(PathWave &wave, Crossing &crossing) {
    const LightsInRows rows(wave.frame.scene);
    orderPoints(crossing);
    crossing.lights.light(rows.rows());
    const int all = int(crossing.order.size());
    for (int first = 0; first < all; first += VertexChunk::capacity) {
        const int count = std::min(VertexChunk::capacity, all - first);
        takePoints(wave, crossing, first, count);
        for (int row = 0; row < rows.rows(); ++row)
            lightRow(wave, crossing, rows, row, first, count);
    }
}

void askWindow(PathWave &wave, Crossing &crossing, const Segments::Group &group) {
    VolumeLights &lights = crossing.lights;
    lights.begin(wave.chunk.count());
    crossing.segments.ask(group, &lights, false);
    for (int round = 0; round < Crossing::rounds && lights.lit() < lights.points(); ++round) {
        lightPoints(wave, crossing);
        lights.beginRun();
        crossing.segments.ask(group, &lights, false);
    }
    if (group.code->volumeFacts().speaks) {
        lights.beginRun();
        crossing.segments.ask(group, &lights, true);
    }
    if (lights.hasRefused())
        std::call_once(wave.frame.refusedLight, [&] {
            wave.frame.diagnostics.warning({}, "volume shader \"" + group.code->name() +
                                                   "\" asks for light at more than " +
                                                   std::to_string(VolumeLights::mostPoints) +
                                                   " points of a ray; at further ones it is dark");
        });
}

} // namespace

PointLight::PointLight(int capacity)
    : sample(capacity), shadow(capacity), floats(11, capacity), integers(4, capacity),
      keys(4, capacity) {
    P = {floats[0], floats[1], floats[2]};
    time = floats[3], u = floats[4], v = floats[5], choice = floats[6], none = floats[7];
    wanted = floats[8], factor = floats[9], ignored = floats[10];
    std::fill_n(wanted, capacity, 1.0f);
    lightSet = integers[0], atmosphere = integers[1], inShadow = integers[2], lanes = integers[3];
    key = keys[0], sampleIndex = keys[1], inner = keys[2], outer = keys[3];
}

void askLit(PathWave &wave, Crossing &crossing, const Segments::Group &group) {
    for (int first = 0; first < wave.chunk.count(); first += Crossing::window) {
        Segments::Group part = group;
        std::uint16_t any = 0;
        for (int word = 0; word < int(part.active.size()); ++word) {
            const int lane = word * laneBlock;
            if (lane < first || lane >= first + Crossing::window)
                part.active[std::size_t(word)] = 0;
            any |= part.active[std::size_t(word)];
        }
        if (any != 0)
            askWindow(wave, crossing, part);
    }
}

} // namespace candela

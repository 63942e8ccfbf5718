// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"
#include "light/bidir/eye_wave.h"
#include "light/path/stages.h"
#include "light/sampling/mis.h"
#include "light/sampling/sobol.h"
#include "light/vertex/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace candela {

namespace {

constexpr Stage eyeStages[] = {
    meet,       arrive, cross,   emit,  ask,     see,    seeOutputParameters,
    stateLobes, light,  connect, merge, scatter, deliver};
constexpr Stage gatheringStages[] = {meet,
                                     arrive,
                                     cross,
                                     emit,
                                     ask,
                                     see,
                                     lightGathered,
                                     seeOutputParameters,
                                     scatterBesidesFiniteLobes,
                                     deliver};

constexpr double pi = std::numbers::pi;

/// own.vertex, direction and distance; own.lane lists those that have one.
int draw(EyeWave &wave, int turn) {
    VertexChunk &chunk = wave.chunk;
    Connections &own = wave.own;
    const std::vector<LightVertex> &rows = wave.lightVertices->rows;
    const int count = chunk.count();
    randomBits(count, chunk.paths.pixelKey, chunk.paths.sampleIndex,
               0x9e3779b9u + std::uint32_t(wave.vertex * wave.connections + turn), own.bits[0]);
    const ConstVec3Planes P = chunk.vertices.P();
    const float *total = chunk.mixture.total();
    int drawn = 0;
    for (int i = 0; i < count; ++i) {
        own.vertex[i] = -1;
        const std::size_t k = std::size_t(std::uint64_t(own.bits[0][i]) * rows.size() >> 32);
        const LightVertex &vertex = rows[k];
        const bool wanted =
            total[i] > 0 && chunk.paths.depth[i] + vertex.depth + 2 <= wave.frame.settings.maxDepth;
        const Vec3 way = vertex.P - at(P, i);
        const float distance = length(way);
        const Vec3 unit = distance > 0 ? way / distance : Vec3{0, 0, 1};
        for (int c = 0; c < 3; ++c)
            own.direction[c][i] = unit[c];
        own.distance[i] = distance;
        if (!wanted || !(distance > 0) || !std::isfinite(distance))
            continue;
        own.vertex[i] = std::int32_t(k);
        own.lane[drawn++] = i;
    }
    return drawn;
}

/// What the eye's vertices make of light along the connections; those that make nothing are left
/// out.
int respondTo(EyeWave &wave, int drawn) {
    VertexChunk &chunk = wave.chunk;
    Connections &own = wave.own;
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = own.response[c];
    chunk.vertices.scatter(constant(own.direction), own.answered, nullptr, response);
    chunk.mixture.pdf(constant(own.direction), own.eyePdf);
    int left = 0;
    for (int k = 0; k < drawn; ++k) {
        const int i = own.lane[k];
        bool some = false, sound = true;
        for (int c = 0; c < colorSamples; ++c) {
            some |= response[c][i] * chunk.paths.throughput[c][i] != 0;
            sound &= bool(std::isfinite(response[c][i]));
        }
        if (some && sound)
            own.lane[left++] = i;
        else
            own.vertex[i] = -1;
    }
    return left;
}

/// How likely the vertices, seen from the light vertices, would have sent light to where they were
/// seen from.
void seeFromLight(EyeWave &wave) {
    VertexChunk &chunk = wave.chunk;
    Subpaths &ends = *wave.subpaths;
    Connections &own = wave.own;
    const int count = chunk.count();
    std::fill_n(own.eyeReversePdf, count, 0.0f);
    if (!ends.anyEarlier(count))
        return;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < count; ++i)
            ends.seenAlong[c][i] = -own.direction[c][i];
    ends.other.look(chunk.vertices, constant(ends.seenAlong), wave.frame.settings.hemisphereOnly);
    ends.other.pdf(constant(ends.toPrevious), own.eyeReversePdf);
}

/// The light vertices of lanes lane[0..count), all of one code, as rays from the eye's vertices
/// would meet them.
void meetFar(EyeWave &wave, const std::int32_t *lane, int count) {
    Connections &own = wave.own;
    const ConstVec3Planes P = wave.chunk.vertices.P();
    own.farRays.count = count;
    for (int k = 0; k < count; ++k) {
        const int i = lane[k];
        const LightVertex &vertex = wave.lightVertices->rows[own.vertex[i]];
        for (int c = 0; c < 3; ++c) {
            own.farRays.origin[c][k] = P[c][i];
            own.farRays.direction[c][k] = own.direction[c][i];
            own.farHits.Ng[c][k] = vertex.elementNormal[c];
        }
        own.farRays.tMin[k] = 0, own.farRays.tMax[k] = INFINITY;
        own.farRays.time[k] = vertex.time;
        own.farRays.width[k] = vertex.width, own.farRays.spread[k] = 0;
        own.farHits.t[k] = own.distance[i];
        own.farHits.shape[k] = vertex.shape, own.farHits.element[k] = vertex.element;
        own.farHits.instance[k] = vertex.instance;
        own.farHits.u[k] = vertex.u, own.farHits.v[k] = vertex.v;
    }
    std::int32_t *order = own.farIntegers[0];
    std::iota(order, order + count, 0);
    own.far.meet(wave.frame.scene, wave.lightVertices->rows[own.vertex[lane[0]]].code, own.farRays,
                 own.farHits, order, count);
}

/// The connections of lanes lane[0..count), whose light vertices share a code: own.value, and where
/// the shadow rays run.
void weigh(EyeWave &wave, const std::int32_t *lane, int count) {
    Connections &own = wave.own;
    VertexChunk &chunk = wave.chunk;
    const Subpaths &ends = *wave.subpaths;
    meetFar(wave, lane, count);
    const Planes<float> &floats = own.farFloats;
    const MutableVec3Planes toPrevious{floats[0], floats[1], floats[2]};
    const MutableVec3Planes along{floats[3], floats[4], floats[5]};
    const MutableVec3Planes toEye{floats[6], floats[7], floats[8]};
    float *reversePdf = floats[9], *pdf = floats[10];
    std::int32_t *light = own.farIntegers[1];
    for (int k = 0; k < count; ++k) {
        const LightVertex &vertex = wave.lightVertices->rows[own.vertex[lane[k]]];
        for (int c = 0; c < 3; ++c) {
            toPrevious[c][k] = vertex.toPrevious[c];
            along[c][k] = -vertex.toPrevious[c] * vertex.distance;
            toEye[c][k] = -own.direction[c][lane[k]];
        }
        light[k] = vertex.light;
    }
    const bool hemisphere = wave.frame.settings.hemisphereOnly;
    own.fromEye.look(own.far, own.far.input(ShaderInput::I), hemisphere);
    own.fromEye.pdf(constant(toPrevious), reversePdf);
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = own.farResponse[c];
    own.fromEye.scatter(constant(toPrevious), own.answered, light, response);
    own.fromLight.look(own.far, constant(along), hemisphere);
    own.fromLight.pdf(constant(toEye), pdf);
    const MutableVec3Planes end{floats[11], floats[12], floats[13]};
    own.far.rayOrigins(constant(toEye), end);

    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    const ConstVec3Planes farNg = own.far.input(ShaderInput::Ng);
    const double scale = double(wave.lightVertices->rows.size()) /
                         (double(wave.lightVertices->paths) * wave.connections);
    for (int k = 0; k < count; ++k) {
        const int i = lane[k];
        const LightVertex &vertex = wave.lightVertices->rows[own.vertex[i]];
        const Vec3 direction = at(constant(own.direction), i);
        const double perArea = 1 / square(own.distance[i]);
        const double out = std::fabs(double(dot(direction, at(farNg, k))));
        const double in = std::fabs(double(dot(vertex.toPrevious, at(farNg, k))));
        const ReachedVertex ofEye{ends.vertices[i],
                                  pdf[k] * std::fabs(double(dot(direction, at(Ng, i)))) * perArea,
                                  own.eyeReversePdf[i]};
        const ReachedVertex ofLight{vertex.ofPath, own.eyePdf[i] * out * perArea, reversePdf[k]};
        const double weight = misWeightAmong(1, othersOfConnection(ofEye, ofLight, ends.counts));
        const bool shows = !wave.frame.scene.isOneSided(vertex.instance, vertex.shape) ||
                           dot(direction, at(farNg, k)) < 0;
        const double worth = in > 0 && shows ? scale * weight * out * perArea / (in * pi * pi) : 0;
        bool sound = true, some = false;
        for (int c = 0; c < colorSamples; ++c) {
            float &value = own.value[c][i];
            value = float(double(own.response[c][i]) * response[c][k] * vertex.flux[c] * worth);
            sound &= bool(std::isfinite(value)), some |= value != 0;
        }
        if (!sound || !some)
            own.vertex[i] = -1;
        for (int c = 0; c < 3; ++c)
            own.end[c][i] = end[c][k];
    }
}

/// What stands in the way of the connections lane[0..count) weakens own.value.
void shadow(EyeWave &wave, int count) {
    Connections &own = wave.own;
    VertexChunk &chunk = wave.chunk;
    chunk.vertices.rayOrigins(constant(own.direction), own.origin);
    const float *time = chunk.vertices.points.input(int(ShaderInput::time));
    const Scene &scene = wave.frame.scene;
    const bool inMedia = scene.hasVolumes();
    for (int k = 0; k < count; ++k) {
        const int i = own.lane[k];
        if (inMedia) {
            const LightVertex &far = wave.lightVertices->rows[own.vertex[i]];
            own.media.set(k, chunk.vertices.mediaAlong(i, constant(own.direction)),
                          scene.mediaOf(far.instance, far.shape));
        }
        for (int c = 0; c < 3; ++c) {
            own.shadow.origin[c][k] = own.origin[c][i];
            own.shadow.direction[c][k] = own.end[c][i] - own.origin[c][i];
        }
        own.shadow.tMin[k] = 0, own.shadow.tMax[k] = shadowRayEnd, own.shadow.time[k] = time[i];
    }
    own.shadow.count = count;
    float *planes[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        planes[c] = own.transmittance[c];
    const ShadowMedia media = own.media.media(false);
    const bool colored = scene.transmittance(own.shadow, planes, inMedia ? &media : nullptr);
    wave.frame.statistics.shadowRays += count;
    for (int c = 0; c < colorSamples; ++c)
        for (int k = 0; k < count; ++k)
            own.value[c][own.lane[k]] *= planes[colored ? c : 0][k];
}

void connectOnce(EyeWave &wave, int turn) {
    VertexChunk &chunk = wave.chunk;
    Connections &own = wave.own;
    const std::vector<LightVertex> &rows = wave.lightVertices->rows;
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(own.value[c], chunk.count(), 0.0f);
    int count = draw(wave, turn);
    count = respondTo(wave, count);
    if (count == 0)
        return;
    seeFromLight(wave);
    const auto codeOf = [&](std::int32_t i) { return rows[own.vertex[i]].code; };
    std::stable_sort(own.lane, own.lane + count,
                     [&](std::int32_t a, std::int32_t b) { return codeOf(a) < codeOf(b); });
    for (int first = 0; first < count;) {
        int last = first + 1;
        while (last < count && codeOf(own.lane[last]) == codeOf(own.lane[first]))
            ++last;
        weigh(wave, own.lane + first, last - first);
        first = last;
    }
    count = int(std::remove_if(own.lane, own.lane + count,
                               [&](std::int32_t i) { return own.vertex[i] < 0; }) -
                own.lane);
    std::sort(own.lane, own.lane + count);
    for (int i = 0, k = 0; i < chunk.count(); ++i) {
        if (k < count && own.lane[k] == i)
            ++k;
        else
            for (int c = 0; c < colorSamples; ++c)
                own.value[c][i] = 0;
    }
    if (count == 0)
        return;
    shadow(wave, count);
    chunk.gather({own.value[0], own.value[1], own.value[2]});
}

} // namespace

Connections::Connections(int capacity)
    : bits(1, capacity), integers(3, capacity), floats(12, capacity),
      response(colorSamples, capacity), value(colorSamples, capacity), far(capacity),
      farRays(capacity), farHits(capacity), fromEye(capacity), fromLight(capacity),
      farFloats(14, capacity), farResponse(colorSamples, capacity), farIntegers(2, capacity),
      shadow(capacity), media(capacity), transmittance(colorSamples, capacity) {
    vertex = integers[0], lane = integers[1], answered = integers[2];
    std::fill_n(answered, integers.lanes(), finiteRequests);
    direction = {floats[0], floats[1], floats[2]};
    distance = floats[3], eyePdf = floats[4], eyeReversePdf = floats[5];
    origin = {floats[6], floats[7], floats[8]}, end = {floats[9], floats[10], floats[11]};
}

EyeWave::EyeWave(FrameContext &frame, const TechniqueCounts &counts, const LightVertices &vertices,
                 int connections)
    : PathWave(frame, Purpose::Camera, stagesOfEye, counts), lightVertices(&vertices),
      connections(connections), own(VertexChunk::capacity), merging(VertexChunk::capacity) {}

std::span<const Stage> stagesOfEye(const PathWave &, const ShaderCode &code) {
    return code.facts().affine ? std::span<const Stage>(eyeStages) : gatheringStages;
}

void connect(PathWave &path) {
    EyeWave &wave = static_cast<EyeWave &>(path); // Stages of the eye serve eye waves alone.
    if (wave.lightVertices->rows.empty())
        return;
    for (int turn = 0; turn < wave.connections; ++turn)
        connectOnce(wave, turn);
}

} // namespace candela

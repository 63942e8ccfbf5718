// SPDX-License-Identifier: Apache-2.0
// Vertices of camera paths with those of light paths around them, as if they were the same: the
// eye's vertex answers to the light that has met the other one.
#include "foundation/base/lanes.h"
#include "light/bidir/eye_wave.h"
#include "light/path/stages.h"
#include "light/sampling/mis.h"
#include "light/vertex/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;
/// Surfaces are the same if their normals are no farther apart (cosine), and if the light vertex
/// lies no farther above the eye's plane than this part of the radius: walls of a corner and the
/// two sides of a box have light of their own.
constexpr float likeNormals = 0.8f, leastHeight = 0.25f;

/// The light vertex might be the vertex of lane i.
bool mayMerge(EyeWave &wave, int i, const LightVertex &vertex) {
    VertexChunk &chunk = wave.chunk;
    const Vec3 Ng = at(chunk.vertices.input(ShaderInput::Ng), i);
    const float height = std::fabs(dot(vertex.P - at(chunk.vertices.P(), i), Ng));
    return chunk.paths.depth[i] + vertex.depth + 1 <= wave.frame.settings.maxDepth &&
           std::fabs(dot(vertex.Ng, Ng)) >= likeNormals &&
           height <= leastHeight * wave.lightVertices->cells.radius() &&
           wave.frame.scene.lights().isOn(chunk.vertices.points.lightSet[i], vertex.light);
}

/// What the eye's vertices make of the light; pairs that are black are left out.
void respond(EyeWave &wave) {
    VertexChunk &chunk = wave.chunk;
    Merging &own = wave.merging;
    for (int k = 0; k < own.count; ++k) {
        const LightVertex &vertex = wave.lightVertices->rows[own.row[k]];
        put(own.direction, k, vertex.toPrevious);
        own.light[k] = vertex.light;
    }
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = own.response[c];
    chunk.vertices.scatterOf(own.count, own.lane, constant(own.direction), own.answered, own.light,
                             response);
    int left = 0;
    for (int k = 0; k < own.count; ++k) {
        bool some = false, sound = true;
        for (int c = 0; c < colorSamples; ++c) {
            some |= response[c][k] * chunk.paths.throughput[c][own.lane[k]] != 0;
            sound &= bool(std::isfinite(response[c][k]));
        }
        if (!some || !sound)
            continue;
        for (int c = 0; c < 3; ++c)
            own.direction[c][left] = own.direction[c][k];
        for (int c = 0; c < colorSamples; ++c)
            response[c][left] = response[c][k];
        own.lane[left] = own.lane[k], own.row[left] = own.row[k];
        ++left;
    }
    own.count = left;
}

/// How likely the eye's vertices, seen from where the light came from, would have sent it on to
/// where they were seen from; asked where that makes a difference.
void seeFromLight(EyeWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const Subpaths &ends = *wave.subpaths;
    Merging &own = wave.merging;
    int count = 0;
    for (int k = 0; k < own.count; ++k) {
        own.eyeReversePdf[k] = 0;
        const int i = own.lane[k];
        if (!(ends.vertices[i].earlier > 0))
            continue;
        own.unlike[count] = k, own.unlikeLane[count] = i;
        put(own.along, count, -at(constant(own.direction), k));
        put(own.toPrevious, count, at(constant(ends.toPrevious), i));
        ++count;
    }
    if (count == 0)
        return;
    if (!own.approached)
        own.fromLight.approach(chunk.vertices);
    own.approached = true;
    own.fromLight.lookAgain(count, own.unlikeLane, constant(own.along),
                            wave.frame.settings.hemisphereOnly);
    own.fromLight.pdf(constant(own.toPrevious), own.reversePdf);
    for (int k = 0; k < count; ++k)
        own.eyeReversePdf[own.unlike[k]] = own.reversePdf[k];
}

/// The pairs in hand join own.value.
void addPairs(EyeWave &wave) {
    VertexChunk &chunk = wave.chunk;
    Merging &own = wave.merging;
    const Subpaths &ends = *wave.subpaths;
    respond(wave);
    own.mixture.take(chunk.mixture, own.count, own.lane);
    own.mixture.pdf(constant(own.direction), own.eyePdf);
    seeFromLight(wave);
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    const double radius = wave.lightVertices->cells.radius();
    const double perDisc = 1 / (pi * radius * radius * double(wave.lightVertices->paths));
    for (int k = 0; k < own.count; ++k) {
        const int i = own.lane[k];
        const LightVertex &vertex = wave.lightVertices->rows[own.row[k]];
        const double weight =
            misWeightAmong(1, othersOfMerging(ends.vertices[i], own.eyeReversePdf[k], vertex.ofPath,
                                              own.eyePdf[k], ends.counts));
        const double in = std::fabs(double(dot(vertex.toPrevious, at(Ng, i))));
        const double worth = in > 0 ? weight * perDisc / (pi * in) : 0;
        for (int c = 0; c < colorSamples; ++c) {
            const double value = double(own.response[c][k]) * vertex.flux[c] * worth;
            own.value[c][i] += std::isfinite(value) ? float(value) : 0.0f;
        }
    }
    own.count = 0;
}

} // namespace

Merging::Merging(int capacity)
    : integers(6, capacity), floats(12, capacity), response(colorSamples, capacity),
      value(colorSamples, capacity), mixture(capacity), fromLight(capacity) {
    lane = integers[0], row = integers[1], light = integers[2], answered = integers[3];
    unlike = integers[4], unlikeLane = integers[5];
    std::fill_n(answered, integers.lanes(), finiteRequests);
    direction = {floats[0], floats[1], floats[2]}, along = {floats[3], floats[4], floats[5]};
    toPrevious = {floats[6], floats[7], floats[8]};
    eyePdf = floats[9], eyeReversePdf = floats[10], reversePdf = floats[11];
}

void merge(PathWave &path) {
    EyeWave &wave = static_cast<EyeWave &>(path);
    if (!(wave.subpaths->counts.merging > 0) || wave.lightVertices->rows.empty())
        return;
    VertexChunk &chunk = wave.chunk;
    Merging &own = wave.merging;
    own.approached = false;
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(own.value[c], chunk.count(), 0.0f);
    for (int i = 0; i < chunk.count(); ++i) {
        if (!(chunk.mixture.total()[i] > 0))
            continue;
        wave.lightVertices->cells.findNear(at(chunk.vertices.P(), i), own.found);
        for (std::int32_t row : own.found) {
            if (!mayMerge(wave, i, wave.lightVertices->rows[row]))
                continue;
            own.lane[own.count] = i, own.row[own.count] = row;
            if (++own.count == VertexChunk::capacity)
                addPairs(wave);
        }
    }
    if (own.count > 0)
        addPairs(wave);
    chunk.gather({own.value[0], own.value[1], own.value[2]});
}

} // namespace candela

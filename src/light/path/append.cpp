// SPDX-License-Identifier: Apache-2.0
// Paths that go on are packed behind those of the chunks before.
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/vec3.h"
#include "light/path/steps.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

/// The widest cone, as metres a metre, that one direction stands for.
constexpr float widestSpread = 1;

/// A direction stands for a solid angle of 1 / pdf, a cone of the diameter 2 / sqrt(pi pdf).
inline float spreadOf(float pdf) {
    const float own = 2 / std::sqrt(float(M_PI) * (pdf > 0 ? pdf : 1.0f));
    return own < widestSpread ? own : widestSpread;
}

/// Footprints of rays lane[0..count): as wide as the ray that came is at the vertex.
CANDELA_HOT void leaveFootprints(int count, const int *__restrict lane, const int *__restrict ray,
                                 const float *__restrict t, const float *__restrict width,
                                 const float *__restrict spread, const float *__restrict pdf,
                                 float *__restrict nextWidth, float *__restrict nextSpread) {
    for (int k = 0; k < count; ++k) {
        const int i = lane[k], from = ray[i];
        nextWidth[k] = width[from] + spread[from] * t[from];
        nextSpread[k] = pdf[i] > 0 ? spreadOf(pdf[i]) : spread[from];
    }
}

CANDELA_HOT void deepen(int count, int *__restrict depth) {
    for (int k = 0; k < count; ++k)
        ++depth[k];
}

/// The page to append to: what is full waits.
ActivePaths &roomFor(PathWave &wave, int count) {
    if (wave.next.count + count > PathWave::capacity) {
        wave.next.rays.count = wave.next.count;
        wave.waiting.push_back({wave.vertex + 1, std::move(wave.next)});
        if (wave.spare.empty())
            wave.spare.emplace_back(PathWave::capacity, wave.frame.scene.hasVolumes(),
                                    wave.subpaths != nullptr);
        wave.next = std::move(wave.spare.back());
        wave.spare.pop_back();
        wave.next.count = wave.next.rays.count = 0;
    }
    return wave.next;
}

void leaveSurface(VertexChunk &chunk, const ConstVec3Planes &direction, int count, int first,
                  RayBatch &rays) {
    const int *lane = chunk.way.lane;
    const MutableVec3Planes origin{chunk.way.origin[0], chunk.way.origin[1], chunk.way.origin[2]};
    chunk.vertices.rayOrigins(direction, origin);
    lanes::take(count, lane,
                {{origin[0], rays.origin[0] + first},
                 {origin[1], rays.origin[1] + first},
                 {origin[2], rays.origin[2] + first},
                 {direction[0], rays.direction[0] + first},
                 {direction[1], rays.direction[1] + first},
                 {direction[2], rays.direction[2] + first},
                 {chunk.vertices.points.input(int(ShaderInput::time)), rays.time + first}});
    std::fill_n(rays.tMin + first, count, 0.0f);
    lanes::fill(count, INFINITY, rays.tMax + first);
}

/// What finite events leave on their rays.
void rememberVertex(const VertexChunk &chunk, int count, int first, RayOrigins &left) {
    lanes::take(count, chunk.way.lane,
                {{chunk.way.pdf, left.pdf + first},
                 {chunk.N[0], left.N[0] + first},
                 {chunk.N[1], left.N[1] + first},
                 {chunk.N[2], left.N[2] + first},
                 {chunk.vertices.points.lightSet, left.lightSet + first}});
    lanes::fill(count, chunk.code, left.code + first);
}

/// What passes straight on keeps its ray beyond what it has met, and has not been scattered.
void passOn(const ActivePaths &from, const HitBatch &hits, int i, ActivePaths &to, int at) {
    for (int c = 0; c < 3; ++c) {
        to.rays.origin[c][at] = from.rays.origin[c][i];
        to.rays.direction[c][at] = from.rays.direction[c][i];
        to.left.N[c][at] = from.left.N[c][i];
    }
    to.rays.tMin[at] = passing(hits.t[i]);
    to.rays.tMax[at] = from.rays.tMax[i];
    to.rays.width[at] = from.rays.width[i], to.rays.spread[at] = from.rays.spread[i];
    to.left.pdf[at] = from.left.pdf[i];
    to.left.lightSet[at] = from.left.lightSet[i], to.left.code[at] = from.left.code[i];
    to.depth[at] = from.depth[i], to.seen[at] = from.seen[i];
}

/// How much wider the cone of a ray becomes, metres a metre, that leaves vertex i mirrored or bent:
/// a direction turns with the normal, which changes over the footprint.
float spreadByCurvature(ShadingPoints &points, int i, const Vec3 &direction) {
    constexpr float mirrored = 2, bent = 0.5f; // Of the normal's turn; bent by water or glass.
    const auto vec = [&](ShaderInput input) {
        return Vec3{points.input(input, 0)[i], points.input(input, 1)[i],
                    points.input(input, 2)[i]};
    };
    const auto number = [&](ShaderInput input) { return points.input(input, 0)[i]; };
    const Vec3 byU = vec(ShaderInput::dNdu), byV = vec(ShaderInput::dNdv), N = vec(ShaderInput::N);
    const float turn =
        std::max(length(byU * number(ShaderInput::dudx) + byV * number(ShaderInput::dvdx)),
                 length(byU * number(ShaderInput::dudy) + byV * number(ShaderInput::dvdy)));
    const bool isMirrored = dot(direction, N) * dot(vec(ShaderInput::I), N) < 0;
    const float more = turn * (isMirrored ? mirrored : bent);
    return more < widestSpread ? more : widestSpread; // Also of what is no number.
}

/// Mirrors leave directions of any length and no memory of their vertex.
void correctSpecialEvents(PathWave &wave, const ConstVec3Planes &direction, int count, int first) {
    VertexChunk &chunk = wave.chunk;
    const bool bends = wave.frame.scene.bendsRays(chunk.code);
    ActivePaths &to = wave.next;
    for (int k = 0; k < count; ++k) {
        const int i = chunk.way.lane[k], at = first + k;
        if (chunk.events.event()[i] == straightThrough) {
            passOn(wave.active, wave.hits, chunk.rays[i], to, at);
            continue;
        }
        const Vec3 unit = normalize(Vec3{direction[0][i], direction[1][i], direction[2][i]});
        to.rays.direction[0][at] = unit.x, to.rays.direction[1][at] = unit.y;
        to.rays.direction[2][at] = unit.z;
        if (bends)
            to.rays.spread[at] += spreadByCurvature(chunk.vertices.points, i, unit);
        for (int c = 0; c < 3; ++c)
            to.left.N[c][at] = 0;
    }
}

} // namespace

CANDELA_HOT void spreadOfDirections(int count, const float *__restrict pdf,
                                    float *__restrict spread) {
    for (int i = 0; i < count; ++i)
        spread[i] = spreadOf(pdf[i]);
}

void append(PathWave &wave, const ConstVec3Planes &direction, int count) {
    VertexChunk &chunk = wave.chunk;
    ScatterPlanes &way = chunk.way;
    ActivePaths &next = roomFor(wave, count);
    const int first = next.count, *lane = way.lane;
    next.count += count;
    leaveSurface(chunk, direction, count, first, next.rays);
    if (wave.frame.scene.readsFootprints())
        leaveFootprints(count, lane, chunk.rays.data(), wave.hits.t, wave.active.rays.width,
                        wave.active.rays.spread, way.pdf, next.rays.width + first,
                        next.rays.spread + first);
    rememberVertex(chunk, count, first, next.left);
    for (int c = 0; c < colorSamples; ++c)
        lanes::multiply(chunk.count(), way.gain, way.throughput[c]);
    lanes::take(count, lane,
                {{way.throughput[0], next.throughput[0] + first},
                 {way.throughput[1], next.throughput[1] + first},
                 {way.throughput[2], next.throughput[2] + first},
                 {chunk.paths.slot, next.slot + first},
                 {chunk.paths.depth, next.depth + first},
                 {chunk.paths.sampleIndex, next.sampleIndex + first}});
    deepen(count, next.depth + first);
    std::fill_n(next.seen + first, count, 0);
    if (!chunk.events.finite())
        correctSpecialEvents(wave, direction, count, first);
    if (wave.frame.scene.hasVolumes())
        leaveMedia(wave, direction, count, first);
    if (wave.subpaths)
        leaveHistory(wave, count, first);
}

} // namespace candela

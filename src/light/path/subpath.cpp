// SPDX-License-Identifier: Apache-2.0
#include "light/path/subpath.h"

#include "light/path/steps.h"
#include "light/path/wave.h"
#include "light/sampling/mis.h"
#include "light/vertex/reversal.h"
#include "light/vertex/vectors.h"
#include "world/scene/light_starts.h"

#include <algorithm>
#include <cmath>

namespace candela {

Subpaths::Subpaths(int capacity, TechniqueCounts counts)
    : counts(counts), vertices(capacity), leaving(capacity), floats(9, capacity),
      integers(1, capacity), other(capacity) {
    reverseRequest = integers[0];
    toPrevious = {floats[0], floats[1], floats[2]}, seenAlong = {floats[3], floats[4], floats[5]};
    reversePdf = floats[6];
    startPosition = floats[7], startDirection = floats[8];
}

void beginHistory(PathWave &wave) {
    const Camera &camera = wave.frame.scene.camera();
    for (int i = 0; i < wave.slots; ++i)
        wave.active.history[i] =
            edgeOfCamera(wave.subpaths->counts, camera.pdf(wave.active.rays.direction[2][i]),
                         camera.isParallel());
}

void beginHistoryAtPoints(PathWave &wave) {
    ActivePaths &active = wave.active;
    for (int i = 0; i < wave.slots; ++i) {
        active.history[i] = {};
        active.history[i].pdf = active.left.pdf[i] > 0 ? active.left.pdf[i] : 1;
    }
}

void arrive(PathWave &wave) {
    Subpaths &ends = *wave.subpaths;
    VertexChunk &chunk = wave.chunk;
    const std::array<float *, 3> &along = wave.active.rays.direction;
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    for (int i = 0; i < chunk.count(); ++i) {
        const int ray = chunk.rays[i];
        const Vec3 direction{along[0][ray], along[1][ray], along[2][ray]};
        put(ends.toPrevious, i, -direction);
        ends.vertices[i] =
            arriveAlong(wave.active.history[ray], dot(direction, at(Ng, i)), wave.hits.t[ray]);
    }
}

void weighEmissionAmongAll(PathWave &wave, float *weight) {
    Subpaths &ends = *wave.subpaths;
    VertexChunk &chunk = wave.chunk;
    const int count = chunk.count();
    wave.frame.scene.lights().startDensities(
        count, chunk.vertices.points.light, constant(ends.toPrevious),
        chunk.vertices.input(ShaderInput::Ng), chunk.vertices.P(), wave.frame.guide,
        {ends.startPosition, ends.startDirection});
    for (int i = 0; i < count; ++i)
        weight[i] = float(
            misWeightAmong(weight[i], othersOfEmission(ends.vertices[i], ends.startPosition[i],
                                                       ends.startDirection[i])));
}

float weightAmongLightPaths(const PathWave &wave, int ray, float weight, double startPosition,
                            double startDirection) {
    return float(misWeightAmong(weight, othersOfEmission(arriveAtSky(wave.active.history[ray]),
                                                         startPosition, startDirection)));
}

void weighLightSamplesAmongAll(PathWave &wave) {
    Subpaths &ends = *wave.subpaths;
    VertexChunk &chunk = wave.chunk;
    DirectLight &direct = chunk.direct;
    const LightSamples &samples = direct.sample.samples;
    const int count = chunk.count();
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng),
                          unit = {direct.unit[0], direct.unit[1], direct.unit[2]};
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < count; ++i)
            ends.seenAlong[c][i] = -direct.unit[c][i];
    wave.frame.scene.lights().startDensities(
        count, samples.light, constant(ends.seenAlong),
        {samples.normal[0], samples.normal[1], samples.normal[2]}, chunk.vertices.P(),
        wave.frame.guide, {ends.startPosition, ends.startDirection});
    std::fill_n(ends.reversePdf, count, 0.0f);
    if (ends.anyEarlier(count)) {
        ends.other.look(chunk.vertices, constant(ends.seenAlong),
                        wave.frame.settings.hemisphereOnly);
        ends.other.pdf(constant(ends.toPrevious), ends.reversePdf);
    }
    for (int i = 0; i < count; ++i) {
        if (samples.light[i] == 0 || !(samples.probability[i] > 0))
            continue;
        const double started = double(ends.startPosition[i]) * ends.startDirection[i] *
                               std::fabs(double(dot(at(unit, i), at(Ng, i))));
        // At infinity both ends draw the direction in the same way.
        double sampled = samples.probability[i], own = 1;
        const bool hasPlace = samples.distance[i] != INFINITY;
        if (samples.pdfSolidAngle[i] > 0)
            own = misWeight(samples.pdfSolidAngle[i], direct.directionPdf[i]);
        if (samples.pdfSolidAngle[i] > 0 && hasPlace) {
            const Vec3 normal{samples.normal[0][i], samples.normal[1][i], samples.normal[2][i]};
            sampled = samples.pdfSolidAngle[i] * std::fabs(double(dot(at(unit, i), normal)));
        } else if (hasPlace) {
            sampled *= square(samples.distance[i]);
        }
        if (!(sampled > 0))
            continue;
        const double others = othersOfLightSample(ends.vertices[i], ends.counts, started / sampled,
                                                  ends.reversePdf[i]);
        direct.factor[i] *= float(misWeightAmong(own, others) / own);
    }
}

bool Subpaths::anyEarlier(int count) const {
    return std::any_of(vertices.begin(), vertices.begin() + count,
                       [](const PathVertex &vertex) { return vertex.earlier > 0; });
}

/// The direction that the paths take is looked along from the far end.
static void lookAgainst(PathWave &wave, const ConstVec3Planes &direction) {
    Subpaths &ends = *wave.subpaths;
    const int count = wave.chunk.count();
    for (int i = 0; i < count; ++i) {
        const Vec3 unit = normalize(at(direction, i));
        for (int c = 0; c < 3; ++c)
            ends.seenAlong[c][i] = -unit[c];
    }
    ends.other.look(wave.chunk.vertices, constant(ends.seenAlong),
                    wave.frame.settings.hemisphereOnly);
}

void lookBack(PathWave &wave, const ConstVec3Planes &direction) {
    Subpaths &ends = *wave.subpaths;
    VertexChunk &chunk = wave.chunk;
    const std::int32_t *event = chunk.events.event();
    const int count = chunk.count();
    if (std::all_of(event, event + count,
                    [](std::int32_t e) { return e == straightThrough || e == pathEnds; }))
        return;
    lookAgainst(wave, direction);
    if (chunk.events.finite())
        ends.other.pdf(constant(ends.toPrevious), ends.reversePdf);
    else
        reversals(count, ends.other.answers(), constant(ends.toPrevious), ends.reversePdf,
                  ends.reverseRequest);
    const bool affine = chunk.vertices.code().facts().affine;
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    for (int i = 0; i < count; ++i) {
        const bool finite = event[i] == finiteRequests;
        const PathEvent leaving{finite,
                                affine && (finite || ends.reversePdf[i] > 0),
                                chunk.paths.depth[i] == 0,
                                chunk.way.pdf[i],
                                ends.reversePdf[i],
                                std::fabs(dot(at(constant(ends.seenAlong), i), at(Ng, i)))};
        ends.leaving[i] = leaveAlong(ends.vertices[i], leaving, ends.counts);
    }
}

void leaveHistory(PathWave &wave, int count, int first) {
    const VertexChunk &chunk = wave.chunk;
    for (int k = 0; k < count; ++k) {
        const int i = chunk.way.lane[k];
        const bool goesOn = chunk.events.event()[i] == straightThrough;
        wave.next.history[first + k] =
            goesOn ? wave.active.history[chunk.rays[i]] : wave.subpaths->leaving[i];
    }
}

} // namespace candela

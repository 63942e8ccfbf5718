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

double techniquesUpTo(const Subpaths &ends, int i, double reversePdf) {
    return ends.last[i] + square(reversePdf * ends.back[i]) * ends.earlier[i];
}

double techniquesBefore(const Subpaths &ends, int i, double reached, double reversePdf) {
    return square(reached) * (techniquesUpTo(ends, i, reversePdf) + square(ends.counts.merging));
}

double pathTechniquesBefore(const Subpaths &ends, int i, double reached, double reversePdf,
                            bool isFirst) {
    return square(reached) * ((isFirst ? ends.last[i] : 0) +
                              square(reversePdf * ends.back[i]) * ends.earlierOfPath[i]);
}

Subpaths::Subpaths(int capacity, TechniqueCounts counts)
    : counts(counts), doubles(6, capacity), floats(12, capacity), integers(1, capacity),
      other(capacity) {
    reverseRequest = integers[0];
    last = doubles[0], earlier = doubles[1], nextEarlier = doubles[2];
    nextConnections = doubles[3];
    earlierOfPath = doubles[4], nextEarlierOfPath = doubles[5];
    back = floats[0];
    toPrevious = {floats[1], floats[2], floats[3]}, seenAlong = {floats[4], floats[5], floats[6]};
    reversePdf = floats[7], nextPdf = floats[8], nextCosine = floats[9];
    startPosition = floats[10], startDirection = floats[11];
}

void beginHistory(PathWave &wave) {
    SubpathHistory &history = wave.active.history;
    const Camera &camera = wave.frame.scene.camera();
    const double tries = square(wave.subpaths->counts.lightImage);
    for (int i = 0; i < wave.slots; ++i) {
        history.earlier[i] = history.earlierOfPath[i] = 0, history.connections[i] = tries;
        history.pdf[i] = camera.pdf(wave.active.rays.direction[2][i]);
        history.cosine[i] = 0, history.parallel[i] = camera.isParallel() ? 1.0f : 0.0f;
    }
}

void beginHistoryAtPoints(PathWave &wave) {
    const ActivePaths &active = wave.active;
    const SubpathHistory &history = active.history;
    for (int i = 0; i < wave.slots; ++i) {
        history.earlier[i] = history.earlierOfPath[i] = history.connections[i] = 0;
        history.pdf[i] = active.left.pdf[i] > 0 ? active.left.pdf[i] : 1.0f;
        history.cosine[i] = history.parallel[i] = 0;
    }
}

void arrive(PathWave &wave) {
    Subpaths &ends = *wave.subpaths;
    VertexChunk &chunk = wave.chunk;
    const SubpathHistory &history = wave.active.history;
    const std::array<float *, 3> &along = wave.active.rays.direction;
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    for (int i = 0; i < chunk.count(); ++i) {
        const int ray = chunk.rays[i];
        const Vec3 direction{along[0][ray], along[1][ray], along[2][ray]};
        for (int c = 0; c < 3; ++c)
            ends.toPrevious[c][i] = -direction[c];
        const double distance = wave.hits.t[ray];
        const double perArea = history.parallel[ray] != 0 ? 1 : 1 / square(distance);
        const double density =
            history.pdf[ray] * std::fabs(double(dot(direction, at(Ng, i)))) * perArea;
        const double inverse = density > 0 ? 1 / square(density) : 0;
        ends.last[i] = history.connections[ray] * inverse;
        ends.earlier[i] = history.earlier[ray] * inverse;
        ends.earlierOfPath[i] = history.earlierOfPath[ray] * inverse;
        ends.back[i] = float(history.cosine[ray] * perArea);
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
    for (int i = 0; i < count; ++i) {
        const double begun = double(ends.startPosition[i]) * ends.startDirection[i] * ends.back[i];
        weight[i] = float(misWeightAmong(weight[i], square(begun) * ends.earlier[i]));
    }
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
    if (std::any_of(ends.earlier, ends.earlier + count, [](double e) { return e > 0; })) {
        ends.other.look(chunk.vertices, constant(ends.seenAlong),
                        wave.frame.settings.hemisphereOnly);
        ends.other.pdf(constant(ends.toPrevious), ends.reversePdf);
    }
    for (int i = 0; i < count; ++i) {
        if (samples.light[i] == 0 || !(samples.probability[i] > 0))
            continue;
        const double started = double(ends.startPosition[i]) * ends.startDirection[i] *
                               std::fabs(double(dot(at(unit, i), at(Ng, i))));
        double sampled = samples.probability[i], own = 1;
        if (samples.pdfSolidAngle[i] > 0) {
            const Vec3 normal{samples.normal[0][i], samples.normal[1][i], samples.normal[2][i]};
            sampled = samples.pdfSolidAngle[i] * std::fabs(double(dot(at(unit, i), normal)));
            own = misWeight(samples.pdfSolidAngle[i], direct.directionPdf[i]);
        } else if (samples.distance[i] != INFINITY) {
            sampled *= square(samples.distance[i]);
        }
        if (!(sampled > 0))
            continue;
        const double others = techniquesBefore(ends, i, started / sampled, ends.reversePdf[i]);
        direct.factor[i] *= float(misWeightAmong(own, others) / own);
    }
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
        const bool passable = affine && (finite || ends.reversePdf[i] > 0);
        const double last = finite ? ends.last[i] : 0;
        const double back = square(ends.reversePdf[i] * ends.back[i]);
        const double merged = finite ? square(ends.counts.merging) : 0;
        ends.nextEarlier[i] = passable ? last + merged + back * ends.earlier[i] : 0;
        ends.nextEarlierOfPath[i] =
            passable ? (chunk.paths.depth[i] == 0 ? last : 0) + back * ends.earlierOfPath[i] : 0;
        ends.nextConnections[i] = finite ? square(ends.counts.connections) : 0;
        ends.nextPdf[i] = finite ? chunk.way.pdf[i] : 1.0f;
        ends.nextCosine[i] = std::fabs(dot(at(constant(ends.seenAlong), i), at(Ng, i)));
    }
}

void leaveHistory(PathWave &wave, int count, int first) {
    Subpaths &ends = *wave.subpaths;
    const VertexChunk &chunk = wave.chunk;
    const SubpathHistory &from = wave.active.history;
    SubpathHistory &to = wave.next.history;
    for (int k = 0; k < count; ++k) {
        const int i = chunk.way.lane[k], next = first + k, ray = chunk.rays[i];
        const bool goesOn = chunk.events.event()[i] == straightThrough;
        to.earlier[next] = goesOn ? from.earlier[ray] : ends.nextEarlier[i];
        to.earlierOfPath[next] = goesOn ? from.earlierOfPath[ray] : ends.nextEarlierOfPath[i];
        to.connections[next] = goesOn ? from.connections[ray] : ends.nextConnections[i];
        to.pdf[next] = goesOn ? from.pdf[ray] : ends.nextPdf[i];
        to.cosine[next] = goesOn ? from.cosine[ray] : ends.nextCosine[i];
        to.parallel[next] = goesOn ? from.parallel[ray] : 0;
    }
}

} // namespace candela

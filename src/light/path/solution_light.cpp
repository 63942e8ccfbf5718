// SPDX-License-Identifier: Apache-2.0
#include "light/path/solution_light.h"

#include "light/path/split.h"
#include "light/path/stages.h"
#include "light/path/steps.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// Paths of `gather` end where a direction of finite lobes has led; those of the other passes, at
/// their first vertex that has such lobes. What is sampled by light sources is left out of E.
void findEnds(PathWave &wave) {
    SolutionLight &own = *wave.solution;
    const VertexChunk &chunk = wave.chunk;
    const bool gathers =
        wave.frame.settings.finalPass == FinalPass::Gather || wave.purpose == Purpose::Gathering;
    for (int i = 0; i < chunk.count(); ++i)
        own.ends[0][i] = !gathers || wave.active.left.pdf[chunk.rays[std::size_t(i)]] > 0 ? 1 : 0;
}

bool takesDirectLight(const PathWave &wave) {
    return wave.frame.settings.finalPass != FinalPass::Direct || wave.purpose == Purpose::Gathering;
}

void addIndirect(int count, const Planes<float> &indirect, const float *ends, bool alone,
                 const Planes<float> &all) {
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            all[c][i] = ends[i] * ((alone ? 0 : all[c][i]) + indirect[c][i]);
}

/// What the vertices' paths take from the solution, on their side or behind.
void lookUpSide(PathWave &wave, const Planes<float> &irradiance, bool behind) {
    SolutionLight &own = *wave.solution;
    const bool alone = !takesDirectLight(wave);
    radiosity::Solution::Answer answer;
    for (std::size_t c = 0; c < colorSamples; ++c) {
        if (!alone)
            (behind ? answer.directBehind : answer.direct)[c] = irradiance[int(c)];
        (behind ? answer.indirectBehind : answer.indirect)[c] = own.indirect[int(c)];
    }
    answer.isExact = wave.frame.settings.finalPass != FinalPass::Gather;
    wave.frame.solution->irradiance(wave.chunk.vertices, answer);
    addIndirect(wave.chunk.count(), own.indirect, own.ends[0], alone, irradiance);
}

} // namespace

SolutionLight::SolutionLight(int capacity)
    : irradiance(colorSamples, capacity), behind(colorSamples, capacity),
      indirect(colorSamples, capacity), ends(1, capacity), followed(1, capacity),
      direction(3, capacity), pdf(1, capacity), response(colorSamples, capacity),
      answered(1, capacity) {
    for (int c = 0; c < colorSamples; ++c)
        table[c] = irradiance[c];
    std::fill_n(answered[0], capacity, finiteRequests);
}

const float *followedTotal(const PathWave &wave) {
    if (!wave.solution)
        return wave.chunk.mixture.total();
    const SolutionLight &own = *wave.solution;
    for (int i = 0; i < wave.chunk.count(); ++i)
        own.followed[0][i] = own.ends[0][i] > 0 ? 0.0f : wave.chunk.mixture.total()[i];
    return own.followed[0];
}

void leaveToSolution(const PathWave &wave, float *wanted) {
    if (!takesDirectLight(wave))
        return;
    for (int i = 0; i < wave.chunk.count(); ++i)
        if (wave.solution->ends[0][i] > 0)
            wanted[i] = 0;
}

void lookUpSolution(PathWave &wave) {
    SolutionLight &own = *wave.solution;
    findEnds(wave);
    lookUpSide(wave, own.irradiance, false);
    wave.chunk.irradiance =
        wave.chunk.vertices.code().facts().readsIrradiance ? own.table.data() : nullptr;
}

void takeSolution(PathWave &wave) {
    SolutionLight &own = *wave.solution;
    VertexChunk &chunk = wave.chunk;
    const int count = chunk.count();
    // The light stage has taken it, where there is one.
    if (wave.frame.settings.finalPass == FinalPass::Elements &&
        wave.purpose != Purpose::Gathering && chunk.vertices.prepared().Ca[0])
        chunk.gather({chunk.vertices.prepared().Ca[0], chunk.vertices.prepared().Ca[1],
                      chunk.vertices.prepared().Ca[2]});
    if (chunk.irradiance)
        return;
    if (directionsAt(wave) > 1)
        drawNumbers(wave, directionPair);
    chunk.mixture.sample(chunk.numbers.x(directionPair), chunk.numbers.y(directionPair),
                         {own.direction[0], own.direction[1], own.direction[2]});
    const ConstVec3Planes direction{own.direction[0], own.direction[1], own.direction[2]};
    chunk.mixture.pdf(direction, own.pdf[0]);
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = own.response[c];
    chunk.vertices.scatter(direction, own.answered[0], nullptr, g);
    const ConstVec3Planes facing = chunk.vertices.facingPlanes();
    const auto leavesBehind = [&](int i) {
        return !(direction[0][i] * facing[0][i] + direction[1][i] * facing[1][i] +
                     direction[2][i] * facing[2][i] >
                 0);
    };
    bool some = false;
    for (int i = 0; i < count; ++i)
        some |= leavesBehind(i);
    if (some)
        lookUpSide(wave, own.behind, true);
    for (int i = 0; i < count; ++i) {
        const bool isTaken = own.ends[0][i] > 0 && chunk.mixture.total()[i] > 0 &&
                             own.pdf[0][i] > 0 &&
                             chunk.paths.depth[i] < wave.frame.settings.maxDepth;
        const Planes<float> &E = leavesBehind(i) ? own.behind : own.irradiance;
        for (int c = 0; c < colorSamples; ++c)
            g[c][i] = isTaken ? g[c][i] * E[c][i] / (pi * pi * own.pdf[0][i]) : 0.0f;
    }
    chunk.gather({g[0], g[1], g[2]});
}

} // namespace candela

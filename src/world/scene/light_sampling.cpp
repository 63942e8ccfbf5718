// SPDX-License-Identifier: Apache-2.0
// Light samples in batches: every point chooses a source, points are binned by what has to be asked
// of their sources, and each bin is sampled densely: as it lies where it is all there is.
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/scene/absent_lamps.h"
#include "world/scene/light_aims.h"
#include "world/scene/light_blocks.h"
#include "world/scene/light_choices.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"
#include "world/scene/self_occlusion.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr double largestBelow1 = 0x1.fffffffffffffp-1;

/// What a batch of points has drawn, and room to ask about it.
struct SamplingScratch {
    Scratch<std::int32_t> source;
    AlignedScratch probability, across;
    LightBlocks blocks;
    ElementRows rows{lightBatchSize};
    SourcePoints drawn{lightBatchSize};
    LightBatch batch{lightBatchSize};
    ShadingPoints points{lightBatchSize};
    Planes<float> radiance{colorSamples, lightBatchSize};
    Planes<std::uint8_t> isThere{1, lightBatchSize};
};

SamplingScratch &scratch() {
    thread_local SamplingScratch own;
    return own;
}

/// Samples are floats of 24 bits, too few to tell thousands of sources apart. Another sample's low
/// bits fill in the rest.
CANDELA_HOT void widen(int count, const float *__restrict choice, const float *__restrict position,
                       double *__restrict wide) {
    for (int i = 0; i < count; ++i) {
        const double low = double(position[i]) * 4096;
        const double sum = choice[i] + (low - std::floor(low)) * 0x1p-24;
        wide[i] = sum < largestBelow1 ? sum : largestBelow1;
    }
}

/// For who weighs the samples against paths from lights. `normal` is of any length, or null.
void tellPlaces(int count, const float *probability, const float *const *normal, float elementSign,
                const LightSamples &out) {
    if (!out.probability)
        return;
    std::copy_n(probability, count, out.probability);
    for (int i = 0; i < count; ++i) {
        Vec3 N;
        if (normal)
            N = normalize(Vec3{normal[0][i], normal[1][i], normal[2][i]}) * elementSign;
        for (int c = 0; c < 3; ++c)
            out.normal[c][i] = N[c];
    }
}

// ---- Answers, all lanes of a block at once ----

CANDELA_HOT void keepSound(int count, const std::int32_t *__restrict light,
                           const float *__restrict from, float *__restrict value) {
    for (int i = 0; i < count; ++i)
        value[i] = light[i] != 0 ? from[i] : 0.0f;
}

/// One light's answer that is not finite must not spoil what the others give to the same point.
void dropNonFinite(const SceneState &state, int count, float *const *value) {
    for (int c = 0; c < colorSamples; ++c) {
        if (lanes::allFinite(count, value[c]))
            continue;
        for (int i = 0; i < count; ++i)
            if (!std::isfinite(value[c][i])) {
                ++state.nonFiniteLight;
                for (int k = 0; k < colorSamples; ++k)
                    value[k][i] = 0;
            }
    }
}

CANDELA_HOT void turnUnit(int count, Planes3 from, float sign, float *const to[3]) {
    const float *x = from[0], *y = from[1], *z = from[2];
    float *nx = to[0], *ny = to[1], *nz = to[2];
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float scale = sign / std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        nx[i] = x[i] * scale, ny[i] = y[i] * scale, nz[i] = z[i] * scale;
    }
}

/// Values and shadows of those that are to be had.
void take(const SceneState &state, const LightBlock &block, const SourceBin &bin,
          float *const *value) {
    const LightSamples &out = block.out;
    dropNonFinite(state, block.count, value);
    for (int c = 0; c < colorSamples; ++c)
        keepSound(block.count, out.light, value[c], out.value[c]);
    for (int i = 0; i < block.count; ++i)
        out.castsShadow[i] = bin.castsShadow & (out.light[i] != 0);
}

void aimAtSources(const LightBlock &block, const SourceBin &bin, const SamplingScratch &own) {
    const LightSamples &out = block.out;
    aim(block.count, own.drawn.point.data(), own.drawn.normal.data(), bin.frontSign,
        own.rows.offset, block.P.data(), own.drawn.pdf, block.probability, own.rows.light,
        out.L.data(), out.distance, out.pdfSolidAngle, out.light);
}

// ---- Questions ----

/// The sampled points as shading points of one code; I leads to them from who asks.
void meetSources(const SceneState &state, const LightBlock &block, const SurfaceCode &code,
                 SamplingScratch &own) {
    ShadingPoints &points = own.points;
    placePoints(own.rows, own.drawn, points);
    for (int c = 0; c < 3; ++c) {
        subtract(block.count, own.drawn.point[c], block.P[c], points.input(ShaderInput::I, c));
        std::fill_n(points.input(ShaderInput::E, c), block.count, 0.0f);
    }
    std::copy_n(block.time, block.count, points.input(ShaderInput::time, 0));
    evaluatePoints(state.points, state.camera, code, nullptr, points);
}

/// Samples on surfaces of one code that shine: radiance, with a density.
void sampleSurfaces(const SceneState &state, const SourceBin &bin, const LightBlock &block,
                    SamplingScratch &own) {
    meetSources(state, block, state.points.codes[bin.surfaceCode], own);
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c] = own.radiance[c], block.count, 0.0f);
    state.emission(bin.surfaceCode, own.points, radiance);
    aimAtSources(block, bin, own);
    const float *const Ng[3] = {own.points.input(ShaderInput::Ng, 0),
                                own.points.input(ShaderInput::Ng, 1),
                                own.points.input(ShaderInput::Ng, 2)};
    tellPlaces(block.count, block.probability, Ng, 1, block.out);
    take(state, block, bin, radiance);
}

/// Which lights a batch asks.
void takeLights(const SceneState &state, const ElementRows &rows, LightBatch &batch) {
    const std::int32_t *light = rows.light;
    batch.count = rows.count;
    std::fill_n(batch.objectIndex, rows.count, 0);
    if (lanes::allEqual(rows.count, light, light[0]))
        lanes::fill(rows.count, state.lights.lights[light[0]].shader.parameterOffset,
                    batch.parameterOffset);
    else
        for (int k = 0; k < rows.count; ++k)
            batch.parameterOffset[k] = state.lights.lights[light[k]].shader.parameterOffset;
}

/// Flat lamps and spheres whose light shader looks at position and normal alone.
void samplePlain(const SceneState &state, const SourceBin &bin, const LightBlock &block,
                 SamplingScratch &own) {
    LightBatch &batch = own.batch;
    const int count = block.count;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), nullptr);
    batch.readFrom(ShaderInput::P, 3, own.drawn.point.data());
    float *N[3];
    for (int c = 0; c < 3; ++c) {
        N[c] = batch.input(ShaderInput::N, c);
        std::copy_n(block.P[c], count, batch.input(ShaderInput::Ps, c));
    }
    turnUnit(count, own.drawn.normal.data(), bin.elementSign, N);
    batch.hasSurface = true;
    batch.Ns = batch.I = {};
    batch.readFrom(ShaderInput::Ng, 3, N);
    std::copy_n(block.time, count, batch.input(ShaderInput::time));
    takeLights(state, own.rows, batch);
    batch.ask(state, *bin.shader);
    aimAtSources(block, bin, own);
    tellPlaces(count, block.probability, own.drawn.normal.data(), bin.elementSign, block.out);
    take(state, block, bin, batch.Cl.data());
}

/// How far rays start off the surface.
void fillRayOffsets(int count, Planes3 P, Planes3 Ps, float *offset) {
    for (int i = 0; i < count; ++i)
        offset[i] = length(Vec3{P[0][i] - Ps[0][i], P[1][i] - Ps[1][i], P[2][i] - Ps[2][i]});
}

/// What the answers of lights without extent are worth, for what they are chosen with. A classic
/// area light is the mean over its positions: each source counts by its share of them, however many
/// sources there are.
void findWorth(const SceneState &state, const SourceBin &bin, const LightBlock &block,
               const ElementRows &rows, float *worth) {
    const bool isMean = bin.asked == SourceBin::Asked::ClassicArea;
    const float unit = bin.si ? 1 / pi : 1;
    for (int i = 0; i < block.count; ++i) {
        const float whole = isMean ? float(state.lights.lights[rows.light[i]].areaLeft) : 1;
        worth[i] = unit * (isMean ? rows.area[i] / whole : 1) / block.probability[i];
    }
}

/// Directions that rays may meet have a density, and what they are worth is radiance.
void shareWithRays(const SceneState &state, const LightBlock &block, const ElementRows &rows,
                   float *worth) {
    const LightSamples &out = block.out;
    for (int i = 0; i < block.count; ++i) {
        if (out.light[i] == 0)
            continue;
        const Vec3 L = normalize(Vec3{-out.L[0][i], -out.L[1][i], -out.L[2][i]});
        const float density =
            float(state.lights.lights[rows.light[i]].sky->pdfOfDrawn(block.u[i], L));
        if (density > 0)
            worth[i] = density, out.pdfSolidAngle[i] = density * block.probability[i];
    }
}

/// Lights without extent, or taken so.
void sampleDelta(const SceneState &state, const SourceBin &bin, const LightBlock &block,
                 SamplingScratch &own) {
    LightBatch &batch = own.batch;
    const int count = block.count;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), nullptr);
    batch.hasSurface = bin.asked == SourceBin::Asked::ClassicArea;
    batch.Ns = block.Ns, batch.I = block.I;
    std::copy_n(block.time, count, batch.input(ShaderInput::time));
    if (bin.asked == SourceBin::Asked::ClassicArea) {
        // The geometry alone matters; the shapes may have any surface shaders.
        SurfaceCode geometryOnly;
        geometryOnly.wanted.add(bin.shader->shader().whole.inputsRead);
        meetSources(state, block, geometryOnly, own);
        batch.readFrom(ShaderInput::P, int(ShaderInput::Count), own.points.inputTable.data());
        for (auto [input, components] :
             {std::pair{ShaderInput::Ps, 3}, {ShaderInput::lightSample, 2}, {ShaderInput::time, 1}})
            batch.readFrom(input, components, nullptr);
        batch.readFrom(ShaderInput::rayOffset, 1, nullptr);
    } else {
        for (int k = 0; k < count; ++k)
            placePointLight(batch, k, state.lights.lights[own.rows.light[k]], state.points.shutter);
    }
    for (int c = 0; c < 3; ++c)
        std::copy_n(block.Ps[c], count, batch.input(ShaderInput::Ps, c));
    fillRayOffsets(count, block.P.data(), block.Ps.data(), batch.input(ShaderInput::rayOffset));
    std::copy_n(block.u, count, batch.input(ShaderInput::lightSample, 0));
    std::copy_n(block.v, count, batch.input(ShaderInput::lightSample, 1));
    takeLights(state, own.rows, batch);
    batch.ask(state, *bin.shader);
    const LightSamples &out = block.out;
    aimAtDelta(count, batch.L.data(), block.Ps.data(), block.P.data(), bin.distant, own.rows.light,
               out.L.data(), out.distance, out.pdfSolidAngle, out.light);
    tellPlaces(count, block.probability, nullptr, 1, out);
    if (bin.asked == SourceBin::Asked::ClassicArea)
        endBeforeZone(count, own.drawn.point.data(), own.drawn.normal.data(), own.rows.offset,
                      block.P.data(), out.L.data(), out.distance);
    take(state, block, bin, batch.Cl.data());
    float *worth = own.drawn.pdf; // There is no density that would need it.
    findWorth(state, bin, block, own.rows, worth);
    if (bin.isSky)
        shareWithRays(state, block, own.rows, worth);
    for (float *value : out.value)
        lanes::multiply(count, worth, value);
}

void sampleBlock(const SceneState &state, const SourceBin &bin, const LightBlock &block,
                 SamplingScratch &own) {
    own.rows.draw(state.lights, block.count, block.source, block.u);
    own.rows.moveTo(state.points, block.time);
    if (bin.asked == SourceBin::Asked::ClassicArea)
        placeOnElements(own.rows, own.rows.u, block.v, own.drawn);
    else if (bin.asked != SourceBin::Asked::PointShader)
        sampleElements(own.rows, block.P.data(), own.rows.u, block.v, own.drawn);
    const bool cut = bin.asked != SourceBin::Asked::PointShader &&
                     findAbsent(state, own.rows, own.drawn, block.time, own.isThere[0]);
    switch (bin.asked) {
    case SourceBin::Asked::Surface: sampleSurfaces(state, bin, block, own); break;
    case SourceBin::Asked::PlainShader: samplePlain(state, bin, block, own); break;
    case SourceBin::Asked::PointShader:
    case SourceBin::Asked::ClassicArea: sampleDelta(state, bin, block, own);
    }
    for (int i = 0; cut && i < block.count; ++i)
        if (!own.isThere[0][i])
            setBlack(block.out, i);
}

/// Samples the sources that were chosen; lanes without one are black.
void answer(const SceneState &state, const LightBlock &all, SamplingScratch &own) {
    own.blocks.forEach(state.lights, all, [&](const SourceBin &bin, const LightBlock &block) {
        sampleBlock(state, bin, block, own);
    });
}

LightBlock blockOf(const LightQuery &query, const std::int32_t *source, const float *probability,
                   const float *across, const LightSamples &samples) {
    return {query.count, source,     probability, query.P,           query.Ps, query.Ns,
            query.I,     query.time, across,      query.position[1], samples};
}

} // namespace

void Lights::sample(LightGroup group, const LightQuery &query, LightSamples &samples) const {
    if (query.count == 0)
        return;
    SamplingScratch &own = scratch();
    std::int32_t *source = own.source.get(query.count);
    float *probability = own.probability.get(query.count);
    thread_local Scratch<double> choices;
    double *choice = choices.get(query.count);
    widen(query.count, query.choice, query.position[0], choice);
    chooseSources(*state_, group, query, choice, source, probability);
    answer(*state_, blockOf(query, source, probability, query.position[0], samples), own);
}

void Lights::sampleOne(int index, const LightQuery &query, LightSamples &samples) const {
    if (query.count == 0)
        return;
    SamplingScratch &own = scratch();
    const SceneLight &light = state_->lights.lights[index];
    std::int32_t *source = own.source.get(query.count);
    float *probability = own.probability.get(query.count), *across = own.across.get(query.count);
    for (int i = 0; i < query.count; ++i) {
        const bool on = light.isSampled() && state_->lights.on(query.lightSet[i], index + 1);
        source[i] = on ? light.firstSource : -1;
        probability[i] = 1;
        across[i] = query.position[0][i];
        if (!on || light.cumulative.empty())
            continue;
        // One number chooses the piece and, what is left of it, the place along it.
        double choice = query.choice[i];
        const int piece = chooseByCumulative(light.cumulative, choice);
        source[i] += piece;
        across[i] = std::min(float(choice), 0x1.fffffep-1f);
        probability[i] =
            float(light.cumulative[piece] - (piece > 0 ? light.cumulative[piece - 1] : 0));
    }
    answer(*state_, blockOf(query, source, probability, across, samples), own);
    hideBehindItself(*state_, index, query, samples);
}

void Lights::sampleGiven(const std::int32_t *light, const LightQuery &query,
                         LightSamples &samples) const {
    if (query.count == 0)
        return;
    SamplingScratch &own = scratch();
    std::int32_t *source = own.source.get(query.count);
    float *probability = own.probability.get(query.count);
    for (int i = 0; i < query.count; ++i) {
        const bool on = light[i] > 0 && state_->lights.on(query.lightSet[i], light[i]);
        source[i] = on ? state_->lights.lights[light[i] - 1].firstSource : -1;
        probability[i] = 1;
    }
    answer(*state_, blockOf(query, source, probability, query.position[0], samples), own);
}

} // namespace candela

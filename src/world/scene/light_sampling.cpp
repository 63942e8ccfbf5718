// SPDX-License-Identifier: Apache-2.0
// Light samples in batches: every point chooses a source, sources with geometry are sampled as the
// point sees them, and then the points are binned by what has to be asked.
#include "foundation/base/scratch.h"
#include "world/scene/light_choices.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"
#include "world/scene/source_points.h"
#include "world/scene/source_shading.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr double largestBelow1 = 0x1.fffffffffffffp-1;

/// What a batch of points has drawn, and room to ask about it.
struct SamplingScratch {
    Scratch<std::int32_t> source, order;
    AlignedScratch probability, across;
    std::vector<std::int32_t> binStart;
    std::optional<SourcePoints> drawn;
    int capacity = 0;
    LightBatch batch{lightBatchSize};
    ShadingPoints points{lightBatchSize};
    Planes<float> radiance{colorSamples, lightBatchSize};

    void reserve(int count) {
        if (count <= capacity)
            return;
        drawn.emplace(capacity = paddedLanes(count + count / 2));
    }
};

SamplingScratch &scratch() {
    thread_local SamplingScratch own;
    return own;
}

/// Samples are floats of 24 bits, too few to tell thousands of sources apart. The other samples'
/// low bits fill in the rest.
double widened(const LightQuery &query, int i) {
    double low = double(query.position[0][i]) * 4096;
    return std::min(query.choice[i] + (low - std::floor(low)) * 0x1p-24, largestBelow1);
}

/// The points of one call, what they drew, and where the answers go.
struct Job {
    const SceneState &state;
    const LightQuery &query;
    LightSamples &out;
    SamplingScratch &own;
    const std::int32_t *source;
    const float *probability; ///< Of the source, as far as it counts.

    const SceneLight &lightOf(int i) const {
        return state.lights.lights[state.lights.sources[source[i]].light];
    }
    /// That the sample lies on, of lights with geometry.
    const LightElement &elementOf(int i) const {
        return state.lights.elements[own.drawn->element[i]];
    }
};

void setBlack(LightSamples &samples, int i) {
    samples.L[0][i] = samples.L[1][i] = 0, samples.L[2][i] = 1;
    samples.distance[i] = 0, samples.pdfSolidAngle[i] = 0;
    samples.light[i] = 0, samples.castsShadow[i] = 0;
    for (float *value : samples.value)
        value[i] = 0;
}

/// Direction, distance and density of lane i, whose sample lies on a surface. L ends before the
/// zone in which the light's own elements might stand in the way. False: it isn't to be had.
bool aim(const Job &job, int i) {
    const SourcePoints &drawn = *job.own.drawn;
    const float pdf = drawn.pdf[i] * job.probability[i];
    Vec3 L, normal;
    float largest = 0;
    for (int c = 0; c < 3; ++c) {
        L[c] = drawn.point[c][i] - job.query.P[c][i], normal[c] = drawn.normal[c][i];
        largest = std::max({largest, std::fabs(drawn.point[c][i]), std::fabs(job.query.P[c][i])});
    }
    const float distance = length(L), height = std::fabs(dot(L, normal)) / length(normal);
    if (!(pdf > 0) || !std::isfinite(pdf) || !(distance > 0) || !(height > 0))
        return false;
    constexpr float rounding = 8 * 0x1p-24f;
    const float zone = drawn.offset[i] + rounding * largest;
    const float before = std::max(1 - zone / height, 0.5f);
    LightSamples &out = job.out;
    for (int c = 0; c < 3; ++c)
        out.L[c][i] = L[c] * before;
    out.distance[i] = distance * before;
    out.pdfSolidAngle[i] = pdf;
    out.castsShadow[i] = job.lightOf(i).castsShadow;
    return true;
}

/// The sampled points as shading points of one code; I leads to them from who asks.
void meetSources(const Job &job, const SurfaceCode &code, const std::int32_t *lanes, int count) {
    ShadingPoints &points = job.own.points;
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < count; ++k)
            points.input(ShaderInput::I, c)[k] =
                job.own.drawn->point[c][lanes[k]] - job.query.P[c][lanes[k]];
    meetDrawn(job.state, code, *job.own.drawn, count, lanes, points);
    for (int k = 0; k < count; ++k)
        points.input(ShaderInput::time, 0)[k] = job.query.time[lanes[k]];
}

/// Lanes of lights that shine, whose radiance planes have: the answer, or black.
void deliverFinite(const Job &job, const std::int32_t *lanes, int count,
                   const float *const *radiance) {
    for (int k = 0; k < count; ++k) {
        const int i = lanes[k];
        if (!aim(job, i)) {
            setBlack(job.out, i);
            continue;
        }
        for (int c = 0; c < colorSamples; ++c)
            job.out.value[c][i] = radiance[c][k];
    }
}

/// Samples on surfaces of one code that shine: radiance, with a density.
void sampleFinite(const Job &job, int code, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    meetSources(job, job.state.points.codes[code], lanes, count);
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c] = own.radiance[c], count, 0.0f);
    job.state.emission(code, own.points, radiance);
    deliverFinite(job, lanes, count, radiance);
}

/// Flat lamps and spheres whose light shader looks at position and normal alone: asked at once,
/// all of one shader.
void samplePlain(const Job &job, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    LightBatch &batch = own.batch;
    const SourcePoints &drawn = *own.drawn;
    const PointTables &tables = job.state.points;
    batch.count = count;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), nullptr);
    for (int k = 0; k < count; ++k) {
        const int i = lanes[k];
        const LightElement &element = job.elementOf(i);
        const Appearance &appearance =
            tables.appearances[tables.appearanceOf(element.instance, element.shape)];
        const Vec3 normal{drawn.normal[0][i], drawn.normal[1][i], drawn.normal[2][i]};
        const float scale = appearance.elementSign / length(normal);
        for (int c = 0; c < 3; ++c) {
            batch.input(ShaderInput::P, c)[k] = drawn.point[c][i];
            batch.input(ShaderInput::N, c)[k] = batch.input(ShaderInput::Ng, c)[k] =
                normal[c] * scale;
            batch.input(ShaderInput::Ps, c)[k] = job.query.P[c][i];
        }
        batch.input(ShaderInput::time)[k] = job.query.time[i];
        batch.parameterOffset[k] = job.lightOf(i).shader.parameterOffset;
        batch.objectIndex[k] = 0;
    }
    batch.ask(job.state, *job.lightOf(lanes[0]).shader.code);
    deliverFinite(job, lanes, count, batch.Cl.data());
}

/// Lights without extent (or taken so), all of one shader code.
void sampleDelta(const Job &job, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    LightBatch &batch = own.batch;
    const ShaderCode &code = *job.lightOf(lanes[0]).shader.code;
    batch.count = count;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), nullptr);
    const bool area = job.lightOf(lanes[0]).kind == LightKind::ClassicArea;
    if (area) {
        // The geometry alone matters; the shapes may have any surface shaders.
        SurfaceCode geometryOnly;
        geometryOnly.wanted.add(code);
        meetSources(job, geometryOnly, lanes, count);
        batch.readFrom(ShaderInput::P, int(ShaderInput::Count), own.points.inputTable.data());
        for (auto [input, components] :
             {std::pair{ShaderInput::Ps, 3}, {ShaderInput::lightSample, 2}, {ShaderInput::time, 1}})
            batch.readFrom(input, components, nullptr);
    }
    for (int k = 0; k < count; ++k) {
        const int i = lanes[k];
        const SceneLight &light = job.lightOf(i);
        if (!area)
            placePointLight(batch, k, light);
        batch.parameterOffset[k] = light.shader.parameterOffset;
        batch.objectIndex[k] = 0;
        for (int c = 0; c < 3; ++c)
            batch.input(ShaderInput::Ps, c)[k] = job.query.Ps[c][i];
        for (int c = 0; c < 2; ++c)
            batch.input(ShaderInput::lightSample, c)[k] = job.query.position[c][i];
        batch.input(ShaderInput::time)[k] = job.query.time[i];
    }
    batch.ask(job.state, code);

    LightSamples &out = job.out;
    for (int k = 0; k < count; ++k) {
        const int i = lanes[k];
        const SceneLight &light = job.lightOf(i);
        const Vec3 L{-batch.L[0][k], -batch.L[1][k], -batch.L[2][k]};
        const float distance = length(L);
        if (!(distance > 0) || !std::isfinite(distance)) {
            setBlack(out, i);
            continue;
        }
        for (int c = 0; c < 3; ++c)
            out.L[c][i] = L[c] + (job.query.Ps[c][i] - job.query.P[c][i]);
        const bool distant = light.kind == LightKind::Distant;
        out.distance[i] = distant ? std::numeric_limits<float>::infinity() : distance;
        out.pdfSolidAngle[i] = 0;
        out.castsShadow[i] = light.castsShadow;
        const float scale = (light.si ? 1 / pi : 1) / job.probability[i];
        for (int c = 0; c < colorSamples; ++c)
            out.value[c][i] = batch.Cl[c][k] * scale;
    }
}

/// Bins: surface codes for finite lights, then the light table's batches for all others.
int binOf(const Job &job, int i) {
    const PointTables &tables = job.state.points;
    const SceneLight &light = job.lightOf(i);
    if (!light.finite() || (light.plain && light.kind == LightKind::Area))
        return int(tables.codes.size()) + light.batch;
    if (light.surfaceCode >= 0)
        return light.surfaceCode;
    const LightElement &element = job.elementOf(i);
    return tables.appearances[tables.appearanceOf(element.instance, element.shape)].code;
}

void runBin(const Job &job, int bin, const std::int32_t *lanes, int count) {
    if (bin < int(job.state.points.codes.size()))
        sampleFinite(job, bin, lanes, count);
    else if (job.lightOf(lanes[0]).finite())
        samplePlain(job, lanes, count);
    else
        sampleDelta(job, lanes, count);
}

/// Sorts the lanes by bin and runs each, in blocks.
void runBins(const Job &job) {
    SamplingScratch &own = job.own;
    const int count = job.query.count;
    const int bins = int(job.state.points.codes.size()) + job.state.lights.batches;
    std::int32_t *bin = own.order.get(2 * std::size_t(count)), *order = bin + count;
    own.binStart.assign(bins + 1, 0);
    for (int i = 0; i < count; ++i) {
        bin[i] = job.source[i] < 0 ? -1 : binOf(job, i);
        if (bin[i] >= 0)
            ++own.binStart[bin[i] + 1];
    }
    for (int b = 0; b < bins; ++b)
        own.binStart[b + 1] += own.binStart[b];
    for (int i = 0; i < count; ++i)
        if (bin[i] >= 0)
            order[own.binStart[bin[i]]++] = i;
    // Filling has moved each start to its bin's end.
    for (int b = 0, first = 0; b < bins; ++b)
        for (int last = own.binStart[b]; first < last;) {
            const int n = std::min(lightBatchSize, last - first);
            runBin(job, b, order + first, n);
            first += n;
        }
}

/// Samples the sources that were chosen; lanes without one are black.
void answer(const Job &job, const float *u, const float *v) {
    const LightTable &lights = job.state.lights;
    for (int i = 0; i < job.query.count; ++i) {
        if (job.source[i] < 0)
            setBlack(job.out, i);
        else
            job.out.light[i] = lights.sources[job.source[i]].light + 1;
    }
    sampleSources(lights, {job.query.count, job.source, job.query.P}, u, v, false, *job.own.drawn);
    runBins(job);
}

} // namespace

void Scene::sampleLights(const LightQuery &query, LightSamples &samples) const {
    SamplingScratch &own = scratch();
    own.reserve(query.count);
    std::int32_t *source = own.source.get(query.count);
    float *probability = own.probability.get(query.count);
    thread_local Scratch<double> choices;
    double *choice = choices.get(query.count);
    for (int i = 0; i < query.count; ++i)
        choice[i] = widened(query, i);
    chooseSources(*state_, query, choice, source, probability);
    answer({*state_, query, samples, own, source, probability}, query.position[0],
           query.position[1]);
}

void Scene::sampleLight(int index, const LightQuery &query, LightSamples &samples) const {
    SamplingScratch &own = scratch();
    own.reserve(query.count);
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
        if (light.finite())
            probability[i] =
                float(light.cumulative[piece] - (piece > 0 ? light.cumulative[piece - 1] : 0));
    }
    answer({*state_, query, samples, own, source, probability}, across, query.position[1]);
}

} // namespace candela

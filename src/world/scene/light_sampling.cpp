// SPDX-License-Identifier: Apache-2.0
// Light samples in batches: first every point chooses its light, then the points are binned by
// what has to be asked, and each bin is asked at once.
#include "world/scene/flat_light.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr double largestBelow1 = 0x1.fffffffffffffp-1;

/// What a point has drawn.
struct Drawn {
    std::int32_t light; ///< Index, -1 = none.
    std::int32_t bin;
    double choice; ///< Uniform again, for the triangle.
};

struct SamplingScratch {
    Scratch<Drawn> drawn;
    Scratch<std::int32_t> order;
    std::vector<std::int32_t> binStart;
    Scratch<std::uint32_t> primitive, triangle;
    Scratch<float> u, v;
    std::optional<LightBatch> batch;
    std::optional<ShadingPoints> points;
    std::optional<Planes<float>> radiance;

    SamplingScratch() {
        batch.emplace(lightBatchSize);
        points.emplace(lightBatchSize);
        radiance.emplace(colorSamples, lightBatchSize);
    }
};

SamplingScratch &scratch() {
    thread_local SamplingScratch own;
    return own;
}

/// Samples are floats of 24 bits, too few to tell the triangles of thousands of lights apart. The
/// other samples' low bits fill in the rest.
double widened(const LightQuery &query, int i) {
    double low = double(query.position[0][i]) * 4096;
    return std::min(query.choice[i] + (low - std::floor(low)) * 0x1p-24, largestBelow1);
}

/// The job: points of one call, and where the answers go.
struct Job {
    const SceneState &state;
    const LightQuery &query;
    LightSamples &samples;
    bool chosen; ///< Lights were chosen by power, so probabilities count.
    SamplingScratch &own;
};

void setBlack(LightSamples &samples, int i) {
    samples.L[0][i] = samples.L[1][i] = 0, samples.L[2][i] = 1;
    samples.distance[i] = 0, samples.pdfSolidAngle[i] = 0;
    samples.light[i] = 0, samples.castsShadow[i] = 0;
    for (int c = 0; c < colorSamples; ++c)
        samples.value[c][i] = 0;
}

/// Light samples on surfaces of one code that emit: radiance, with a density.
void sampleFinite(const Job &job, int code, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    ShadingPoints &points = *own.points;
    std::uint32_t *primitive = own.primitive.get(count), *triangle = own.triangle.get(count);
    job.state.evaluate({count, primitive, triangle, own.u.get(count), own.v.get(count)},
                       job.state.codes[code], points);
    auto plane = [&](ShaderInput input, int c = 0) { return points.input(int(input) + c); };
    for (int k = 0; k < count; ++k) {
        for (int c = 0; c < 3; ++c) {
            plane(ShaderInput::I, c)[k] = plane(ShaderInput::P, c)[k] - job.query.P[c][lanes[k]];
            plane(ShaderInput::E, c)[k] = 0;
        }
        plane(ShaderInput::time)[k] = job.query.time[lanes[k]];
    }
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c] = (*own.radiance)[c], count, 0.0f);
    job.state.emission(code, points, radiance);

    LightSamples &out = job.samples;
    for (int k = 0; k < count; ++k) {
        int i = lanes[k];
        const SceneLight &light = job.state.lights.lights[own.drawn.get(0)[i].light];
        Vec3 L{plane(ShaderInput::I, 0)[k], plane(ShaderInput::I, 1)[k],
               plane(ShaderInput::I, 2)[k]};
        Vec3 Ng{plane(ShaderInput::Ng, 0)[k], plane(ShaderInput::Ng, 1)[k],
                plane(ShaderInput::Ng, 2)[k]};
        float distance2 = dot(L, L), distance = std::sqrt(distance2);
        float cosine = std::abs(dot(L, Ng)) / (distance * length(Ng));
        float pdf = points.lightPdfArea[k] * distance2 / cosine;
        if (!job.chosen)
            pdf /= light.probability;
        if (!(pdf > 0) || !std::isfinite(pdf)) {
            setBlack(out, i);
            continue;
        }
        // Ends before the zone in which the light's own dicing might stand in the way.
        float before = std::max(1 - points.offset[k] / (distance * cosine), 0.5f);
        for (int c = 0; c < 3; ++c)
            out.L[c][i] = L[c] * before;
        out.distance[i] = distance * before;
        out.pdfSolidAngle[i] = pdf;
        out.castsShadow[i] = light.castsShadow;
        for (int c = 0; c < colorSamples; ++c)
            out.value[c][i] = radiance[c][k];
    }
}

/// P and what else a classic area light's shader may read of its surface.
void placeClassicAreas(const Job &job, const ShaderCode &lightCode, int count) {
    SamplingScratch &own = job.own;
    std::uint32_t *primitive = own.primitive.get(count), *triangle = own.triangle.get(count);
    // The geometry alone matters; the primitives may have any surface shaders.
    SceneCode geometryOnly;
    geometryOnly.wanted.add(lightCode);
    ShadingPoints &points = *own.points;
    job.state.evaluate({count, primitive, triangle, own.u.get(count), own.v.get(count)},
                       geometryOnly, points);
    own.batch->readFrom(ShaderInput::P, int(ShaderInput::Count), points.inputTable.data());
}

/// Lights without extent (or taken so), all of one shader code.
void sampleDelta(const Job &job, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    LightBatch &batch = *own.batch;
    const auto &lights = job.state.lights.lights;
    const Drawn *drawn = own.drawn.get(0);
    auto lightOf = [&](int k) -> const SceneLight & { return lights[drawn[lanes[k]].light]; };
    batch.count = count;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), nullptr);
    bool area = lightOf(0).kind == LightKind::ClassicArea;
    if (area)
        placeClassicAreas(job, *lightOf(0).shader.code, count);
    for (int k = 0; k < count; ++k) {
        int i = lanes[k];
        if (!area)
            placePointLight(batch, k, lightOf(k));
        batch.parameterOffset[k] = lightOf(k).shader.parameterOffset;
        batch.objectIndex[k] = area ? own.points->objectIndex[k] : 0;
        for (int c = 0; c < 3; ++c)
            batch.input(ShaderInput::Ps, c)[k] = job.query.P[c][i];
        for (int c = 0; c < 2; ++c)
            batch.input(ShaderInput::lightSample, c)[k] = job.query.position[c][i];
        batch.input(ShaderInput::time)[k] = job.query.time[i];
    }
    auto ownPlanes = [&](ShaderInput input, int components) {
        batch.readFrom(input, components, nullptr);
    };
    ownPlanes(ShaderInput::Ps, 3), ownPlanes(ShaderInput::lightSample, 2);
    ownPlanes(ShaderInput::time, 1);
    batch.ask(job.state, *lightOf(0).shader.code);

    LightSamples &out = job.samples;
    for (int k = 0; k < count; ++k) {
        int i = lanes[k];
        const SceneLight &light = lightOf(k);
        Vec3 L{-batch.L[0][k], -batch.L[1][k], -batch.L[2][k]};
        float distance = length(L);
        if (!(distance > 0) || !std::isfinite(distance)) {
            setBlack(out, i);
            continue;
        }
        for (int c = 0; c < 3; ++c)
            out.L[c][i] = L[c];
        bool distant = light.kind == LightKind::Distant;
        out.distance[i] = distant ? std::numeric_limits<float>::infinity() : distance;
        out.pdfSolidAngle[i] = 0;
        out.castsShadow[i] = light.castsShadow;
        float scale = (light.si ? 1 / pi : 1) / (job.chosen ? light.probability : 1);
        for (int c = 0; c < colorSamples; ++c)
            out.value[c][i] = batch.Cl[c][k] * scale;
    }
}

bool needsPlace(LightKind kind) {
    return kind == LightKind::Area || kind == LightKind::Emitter || kind == LightKind::ClassicArea;
}

/// Bins: surface codes for finite lights, then the light table's batches for the others.
void draw(const Job &job, int i, int light, double choice, Drawn &drawn) {
    LightSamples &out = job.samples;
    const auto &table = job.state.lights;
    drawn = {light, -1, choice};
    const SceneLight &chosen = table.lights[light];
    bool canBeSampled = chosen.kind != LightKind::None && chosen.kind != LightKind::Ambient;
    if (!canBeSampled || !table.on(job.query.lightSet[i], light + 1)) {
        setBlack(out, i);
        return;
    }
    out.light[i] = light + 1;
    if (chosen.finite()) {
        drawn.bin = chosen.surfaceCode;
        if (drawn.bin >= 0)
            return;
        // The triangle decides the code; it is found again when the bin is filled.
        double again = choice;
        int place = chooseByCumulative(chosen.cumulative, again);
        drawn.bin = job.state.summaries[chosen.triangles[place].primitive].code;
    } else {
        drawn.bin = int(job.state.codes.size()) + chosen.batch;
    }
}

/// The commonest scene: one flat light, on for all. False if it isn't that.
bool sampleOnlyFlatLight(const SceneState &state, const LightQuery &query, LightSamples &samples) {
    if (!state.lights.isOneFlatLight())
        return false;
    for (int first = 0; first < query.count; first += lightBatchSize) {
        const int count = std::min(lightBatchSize, query.count - first);
        LightQuery part = query;
        part.count = count, part.choice += first;
        LightSamples to = samples;
        for (int c = 0; c < 3; ++c)
            part.P[c] += first, to.L[c] += first;
        part.position[0] += first, part.position[1] += first, part.time += first;
        for (int c = 0; c < colorSamples; ++c)
            to.value[c] += first;
        to.distance += first, to.pdfSolidAngle += first, to.light += first;
        to.castsShadow += first;
        sampleFlatLight(state, state.lights.only, part, true, to);
    }
    return true;
}

void runBin(const Job &job, int bin, const std::int32_t *lanes, int count) {
    SamplingScratch &own = job.own;
    const Drawn *drawn = own.drawn.get(0);
    std::uint32_t *primitive = own.primitive.get(count), *triangle = own.triangle.get(count);
    float *u = own.u.get(count), *v = own.v.get(count);
    for (int k = 0; k < count; ++k) {
        int i = lanes[k];
        const SceneLight &light = job.state.lights.lights[drawn[i].light];
        if (!needsPlace(light.kind))
            break;
        job.state.placeOnLight(light, drawn[i].choice, job.query.position[0][i],
                               job.query.position[1][i], primitive[k], triangle[k], u[k], v[k]);
    }
    int codes = int(job.state.codes.size());
    if (bin < codes)
        sampleFinite(job, bin, lanes, count);
    else
        sampleDelta(job, lanes, count);
}

void runBins(const Job &job) {
    SamplingScratch &own = job.own;
    int count = job.query.count;
    int bins = int(job.state.codes.size()) + job.state.lights.batches;
    const Drawn *drawn = own.drawn.get(count);
    own.binStart.assign(bins + 1, 0);
    for (int i = 0; i < count; ++i)
        if (drawn[i].bin >= 0)
            ++own.binStart[drawn[i].bin + 1];
    for (int bin = 0; bin < bins; ++bin)
        own.binStart[bin + 1] += own.binStart[bin];
    std::int32_t *order = own.order.get(count);
    for (int i = 0; i < count; ++i)
        if (drawn[i].bin >= 0)
            order[own.binStart[drawn[i].bin]++] = i;
    // Filling has moved each start to its bin's end.
    for (int bin = 0, first = 0; bin < bins; ++bin)
        for (int last = own.binStart[bin]; first < last;) {
            int n = std::min(lightBatchSize, last - first);
            runBin(job, bin, order + first, n);
            first += n;
        }
}

} // namespace

void SceneState::placeOnLight(const SceneLight &light, double choice, float x, float y,
                              std::uint32_t &primitive, std::uint32_t &triangle, float &u,
                              float &v) const {
    const auto &place = light.triangles[chooseByCumulative(light.cumulative, choice)];
    primitive = place.primitive, triangle = place.triangle;
    if (triangle == wholeSurface)
        return primitives[primitive].uvDensity->sample(x, y, u, v);
    // The square folded onto the triangle: uniform, and neighbours stay neighbours.
    if (x > y)
        u = x - y / 2, v = y / 2;
    else
        u = x / 2, v = y - x / 2;
}

void Scene::sampleLights(const LightQuery &query, LightSamples &samples) const {
    SamplingScratch &own = scratch();
    Job job{*state_, query, samples, true, own};
    if (!hasLights()) {
        for (int i = 0; i < query.count; ++i)
            setBlack(samples, i);
        return;
    }
    if (sampleOnlyFlatLight(*state_, query, samples))
        return;
    Drawn *drawn = own.drawn.get(query.count);
    for (int i = 0; i < query.count; ++i) {
        double choice = widened(query, i);
        int light = chooseByCumulative(state_->lights.cumulative, choice);
        draw(job, i, light, choice, drawn[i]);
    }
    runBins(job);
}

void Scene::sampleLight(int index, const LightQuery &query, LightSamples &samples) const {
    SamplingScratch &own = scratch();
    Job job{*state_, query, samples, false, own};
    Drawn *drawn = own.drawn.get(query.count);
    for (int i = 0; i < query.count; ++i)
        draw(job, i, index, widened(query, i), drawn[i]);
    runBins(job);
}

} // namespace candela

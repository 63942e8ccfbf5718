// SPDX-License-Identifier: Apache-2.0
// Light samples in batches: every point chooses a source, points are binned by what has to be asked
// of their sources, and each bin is sampled densely: as it lies where it is all there is.
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/scene/absent_lamps.h"
#include "world/scene/light_choices.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"
#include "world/scene/self_occlusion.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr double largestBelow1 = 0x1.fffffffffffffp-1;
constexpr float pointRounding = 8 * 0x1p-24f; ///< Of a point's largest coordinate.

/// Up to lightBatchSize points whose sources share a bin: who asks, and where the answers go.
struct Block {
    int count = 0;
    const std::int32_t *source = nullptr;
    const float *probability = nullptr;                ///< Of the source, as far as it counts.
    std::array<const float *, 3> P{}, Ps{}, Ns{}, I{}; ///< As in LightQuery.
    const float *time = nullptr, *u = nullptr, *v = nullptr;
    LightSamples out;
};

/// Planes for a block that had to be gathered.
struct BlockStorage {
    Planes<float> asked{16, lightBatchSize}, answered{9 + colorSamples, lightBatchSize};
    Planes<std::int32_t> integers{2, lightBatchSize};
    Planes<std::uint8_t> bytes{1, lightBatchSize};
};

/// What a batch of points has drawn, and room to ask about it.
struct SamplingScratch {
    Scratch<std::int32_t> source, order;
    AlignedScratch probability, across;
    std::vector<std::int32_t> binStart;
    BlockStorage block;
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

void setBlack(LightSamples &samples, int i) {
    samples.L[0][i] = samples.L[1][i] = 0, samples.L[2][i] = 1;
    samples.distance[i] = 0, samples.pdfSolidAngle[i] = 0;
    samples.light[i] = 0, samples.castsShadow[i] = 0;
    for (float *value : samples.value)
        value[i] = 0;
    if (samples.probability)
        samples.probability[i] = samples.normal[0][i] = samples.normal[1][i] =
            samples.normal[2][i] = 0;
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

using Planes3 = const float *const *;

/// Direction, distance and density of samples that lie on surfaces; light 0 where they aren't to
/// be had: those that turn their back where rays do not meet it, for one. L ends before the zone in
/// which the light's own elements might stand in the way.
CANDELA_HOT void aim(int count, Planes3 point, Planes3 normal, float frontSign,
                     const float *__restrict offset, Planes3 P, const float *__restrict drawnPdf,
                     const float *__restrict probability, const std::int32_t *__restrict index,
                     float *const L[3], float *__restrict distance, float *__restrict pdf,
                     std::int32_t *__restrict light) {
    const float *x = point[0], *y = point[1], *z = point[2];
    const float *nx = normal[0], *ny = normal[1], *nz = normal[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float most = std::numeric_limits<float>::max();
    auto larger = [](float a, float b) { return a > b ? a : b; };
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float dx = x[i] - px[i], dy = y[i] - py[i], dz = z[i] - pz[i];
        const float seen = std::sqrt(dx * dx + dy * dy + dz * dz);
        const float size = std::sqrt(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
        const float along = dx * nx[i] + dy * ny[i] + dz * nz[i], height = std::fabs(along) / size;
        const float ofLamp = larger(std::fabs(x[i]), larger(std::fabs(y[i]), std::fabs(z[i])));
        const float ofP = larger(std::fabs(px[i]), larger(std::fabs(py[i]), std::fabs(pz[i])));
        const float zone = offset[i] + pointRounding * larger(ofLamp, ofP);
        const float density = drawnPdf[i] * probability[i];
        const bool sound = (density > 0) & (density <= most) & (seen > 0) & (height > 0) &
                           (along * frontSign <= 0);
        const float before = sound ? larger(1 - zone / height, 0.5f) : 0.0f;
        lx[i] = sound ? dx * before : 0.0f;
        ly[i] = sound ? dy * before : 0.0f;
        lz[i] = sound ? dz * before : 1.0f;
        distance[i] = sound ? seen * before : 0.0f;
        pdf[i] = sound ? density : 0.0f;
        light[i] = sound ? index[i] + 1 : 0;
    }
}

/// The same for lights without extent, whose shaders have said L, from the light to Ps. A distant
/// one's is a direction, of any length: the same from wherever a ray starts.
CANDELA_HOT void aimAtDelta(int count, Planes3 given, Planes3 Ps, Planes3 P, bool distant,
                            const std::int32_t *__restrict index, float *const L[3],
                            float *__restrict distance, float *__restrict pdf,
                            std::int32_t *__restrict light) {
    const float *x = given[0], *y = given[1], *z = given[2];
    const float *sx = Ps[0], *sy = Ps[1], *sz = Ps[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float most = std::numeric_limits<float>::max();
    const float shifts = distant ? 0.0f : 1.0f;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        const bool sound = (length > 0) & (length <= most);
        const float far = distant ? std::numeric_limits<float>::infinity() : length;
        lx[i] = sound ? (sx[i] - px[i]) * shifts - x[i] : 0.0f;
        ly[i] = sound ? (sy[i] - py[i]) * shifts - y[i] : 0.0f;
        lz[i] = sound ? (sz[i] - pz[i]) * shifts - z[i] : 1.0f;
        distance[i] = sound ? far : 0.0f;
        pdf[i] = 0;
        light[i] = sound ? index[i] + 1 : 0;
    }
}

/// Ends L before the zone in which the light's own elements might stand in the way, where it leads
/// to the point of the element that was drawn; shaders may say another L.
CANDELA_HOT void endBeforeZone(int count, Planes3 point, Planes3 normal,
                               const float *__restrict offset, Planes3 P, float *const L[3],
                               float *__restrict distance) {
    const float *x = point[0], *y = point[1], *z = point[2];
    const float *nx = normal[0], *ny = normal[1], *nz = normal[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float same = 1e-4f;
    auto larger = [](float a, float b) { return a > b ? a : b; };
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float dx = x[i] - px[i], dy = y[i] - py[i], dz = z[i] - pz[i];
        const float off = std::fabs(dx - lx[i]) + std::fabs(dy - ly[i]) + std::fabs(dz - lz[i]);
        const float size = std::sqrt(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
        const float height = std::fabs(lx[i] * nx[i] + ly[i] * ny[i] + lz[i] * nz[i]) / size;
        const float ofLamp = larger(std::fabs(x[i]), larger(std::fabs(y[i]), std::fabs(z[i])));
        const float ofP = larger(std::fabs(px[i]), larger(std::fabs(py[i]), std::fabs(pz[i])));
        const float zone = offset[i] + pointRounding * larger(ofLamp, ofP);
        const bool isThere = (off <= same * distance[i]) & (height > 0);
        const float before = isThere ? larger(1 - zone / height, 0.5f) : 1.0f;
        lx[i] *= before, ly[i] *= before, lz[i] *= before;
        distance[i] *= before;
    }
}

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
void take(const SceneState &state, const Block &block, const SourceBin &bin, float *const *value) {
    const LightSamples &out = block.out;
    dropNonFinite(state, block.count, value);
    for (int c = 0; c < colorSamples; ++c)
        keepSound(block.count, out.light, value[c], out.value[c]);
    for (int i = 0; i < block.count; ++i)
        out.castsShadow[i] = bin.castsShadow & (out.light[i] != 0);
}

void aimAtSources(const Block &block, const SourceBin &bin, const SamplingScratch &own) {
    const LightSamples &out = block.out;
    aim(block.count, own.drawn.point.data(), own.drawn.normal.data(), bin.frontSign,
        own.rows.offset, block.P.data(), own.drawn.pdf, block.probability, own.rows.light,
        out.L.data(), out.distance, out.pdfSolidAngle, out.light);
}

// ---- Questions ----

/// The sampled points as shading points of one code; I leads to them from who asks.
void meetSources(const SceneState &state, const Block &block, const SurfaceCode &code,
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
void sampleSurfaces(const SceneState &state, const SourceBin &bin, const Block &block,
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
void samplePlain(const SceneState &state, const SourceBin &bin, const Block &block,
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
void findWorth(const SceneState &state, const SourceBin &bin, const Block &block,
               const ElementRows &rows, float *worth) {
    const bool isMean = bin.asked == SourceBin::Asked::ClassicArea;
    const float unit = bin.si ? 1 / pi : 1;
    for (int i = 0; i < block.count; ++i) {
        const float whole = isMean ? float(state.lights.lights[rows.light[i]].areaLeft) : 1;
        worth[i] = unit * (isMean ? rows.area[i] / whole : 1) / block.probability[i];
    }
}

/// Lights without extent, or taken so.
void sampleDelta(const SceneState &state, const SourceBin &bin, const Block &block,
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
    for (float *value : out.value)
        lanes::multiply(count, worth, value);
}

void sampleBlock(const SceneState &state, const SourceBin &bin, const Block &block,
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
    LightSamples out = block.out;
    for (int i = 0; cut && i < block.count; ++i)
        if (!own.isThere[0][i])
            setBlack(out, i);
}

// ---- From the lanes of a call to blocks, and back ----

/// The lanes [first, first + count), where they lie.
Block part(const Block &all, int first, int count) {
    Block block = all;
    block.count = count;
    for (auto *planes : {&block.P, &block.Ps, &block.Ns, &block.I})
        for (const float *&plane : *planes)
            if (plane)
                plane += first;
    for (const float **plane : {&block.probability, &block.time, &block.u, &block.v})
        *plane += first;
    block.source += first;
    LightSamples &out = block.out;
    for (float *&plane : out.L)
        plane += first;
    for (float *&plane : out.value)
        plane += first;
    out.distance += first, out.pdfSolidAngle += first;
    out.light += first, out.castsShadow += first;
    if (out.probability) {
        out.probability += first;
        for (float *&plane : out.normal)
            plane += first;
    }
    return block;
}

/// The bin's light shaders are told more of what they light than where it is.
bool isToldOfSurfaces(const SourceBin &bin) {
    return bin.asked == SourceBin::Asked::PointShader
               ? readsWhatIsLit(*bin.shader, false)
               : bin.asked == SourceBin::Asked::ClassicArea && readsWhatIsLit(*bin.shader, true);
}

/// The lanes lane[0..count), gathered, to be asked of the bin.
Block gathered(const Block &all, const SourceBin &bin, const std::int32_t *lane, int count,
               BlockStorage &storage) {
    Block block;
    block.count = count;
    int plane = 0;
    auto take = [&](const float *from) {
        float *to = storage.asked[plane++];
        lanes::gather(count, lane, from, to);
        return to;
    };
    for (int c = 0; c < 3; ++c)
        block.P[c] = take(all.P[c]), block.Ps[c] = take(all.Ps[c]);
    for (int c = 0; c < 3 && isToldOfSurfaces(bin); ++c) {
        block.Ns[c] = all.Ns[c] ? take(all.Ns[c]) : nullptr;
        block.I[c] = all.I[c] ? take(all.I[c]) : nullptr;
    }
    block.probability = take(all.probability), block.time = take(all.time);
    block.u = take(all.u), block.v = take(all.v);
    lanes::gather(count, lane, all.source, storage.integers[0]);
    block.source = storage.integers[0];
    const Planes<float> &answered = storage.answered;
    block.out.L = {answered[0], answered[1], answered[2]};
    block.out.distance = answered[3], block.out.pdfSolidAngle = answered[4];
    for (int c = 0; c < colorSamples; ++c)
        block.out.value[c] = answered[5 + c];
    block.out.light = storage.integers[1], block.out.castsShadow = storage.bytes[0];
    if (all.out.probability) {
        constexpr int first = 5 + colorSamples;
        block.out.probability = answered[first];
        block.out.normal = {answered[first + 1], answered[first + 2], answered[first + 3]};
    }
    return block;
}

void putBack(const LightSamples &from, const std::int32_t *lane, int count, LightSamples &to) {
    auto put = [&](const auto *answers, auto *plane) {
        for (int k = 0; k < count; ++k)
            plane[lane[k]] = answers[k];
    };
    for (int c = 0; c < 3; ++c)
        put(from.L[c], to.L[c]);
    for (int c = 0; c < colorSamples; ++c)
        put(from.value[c], to.value[c]);
    put(from.distance, to.distance), put(from.pdfSolidAngle, to.pdfSolidAngle);
    put(from.light, to.light), put(from.castsShadow, to.castsShadow);
    if (to.probability) {
        put(from.probability, to.probability);
        for (int c = 0; c < 3; ++c)
            put(from.normal[c], to.normal[c]);
    }
}

/// bin[i] of the lanes' sources, -1 where there is none.
CANDELA_HOT void lookUpBins(int count, const std::int32_t *__restrict source,
                            const std::int32_t *__restrict table, int stride,
                            std::int32_t *__restrict bin) {
    for (int i = 0; i < count; ++i)
        bin[i] = source[i] < 0 ? -1 : table[stride * (source[i] < 0 ? 0 : source[i])];
}

/// The lanes that have a source, by bin; own.binStart[b] becomes the end of bin b.
const std::int32_t *sortByBin(int count, const std::int32_t *bin, int bins, SamplingScratch &own,
                              std::int32_t *order) {
    own.binStart.assign(bins + 1, 0);
    for (int i = 0; i < count; ++i)
        if (bin[i] >= 0)
            ++own.binStart[bin[i] + 1];
    for (int b = 0; b < bins; ++b)
        own.binStart[b + 1] += own.binStart[b];
    for (int i = 0; i < count; ++i)
        if (bin[i] >= 0)
            order[own.binStart[bin[i]]++] = i;
    return order;
}

/// Samples the sources that were chosen; lanes without one are black.
void answer(const SceneState &state, Block all, SamplingScratch &own) {
    const LightTable &table = state.lights;
    if (table.sources.empty()) {
        for (int i = 0; i < all.count; ++i)
            setBlack(all.out, i);
        return;
    }
    std::int32_t *bin = own.order.get(2 * std::size_t(all.count)), *order = bin + all.count;
    constexpr int words = sizeof(LightSource) / sizeof(std::int32_t);
    const bool oneSource = lanes::allEqual(all.count, all.source, all.source[0]);
    lookUpBins(oneSource ? 1 : all.count, all.source, &table.sources[0].bin, words, bin);
    if (bin[0] >= 0 && (oneSource || lanes::allEqual(all.count, bin, bin[0]))) {
        for (int first = 0; first < all.count; first += lightBatchSize)
            sampleBlock(state, table.bins[bin[0]],
                        part(all, first, std::min(lightBatchSize, all.count - first)), own);
        return;
    }
    if (oneSource)
        std::fill_n(bin, all.count, bin[0]);
    for (int i = 0; i < all.count; ++i)
        if (bin[i] < 0)
            setBlack(all.out, i);
    sortByBin(all.count, bin, int(table.bins.size()), own, order);
    for (int b = 0, first = 0; b < int(table.bins.size()); ++b)
        for (int last = own.binStart[b]; first < last;) {
            const int n = std::min(lightBatchSize, last - first);
            const Block block = gathered(all, table.bins[b], order + first, n, own.block);
            sampleBlock(state, table.bins[b], block, own);
            putBack(block.out, order + first, n, all.out);
            first += n;
        }
}

Block blockOf(const LightQuery &query, const std::int32_t *source, const float *probability,
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

// SPDX-License-Identifier: Apache-2.0
#include "light/path/albedo.h"

#include "foundation/base/hash.h"
#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Directions of a sample, powers of 2 so that they stay stratified over samples.
constexpr int directionsOfAffine = 4, directionsOfGathered = 16;
/// Apart from the sequences of paths.
constexpr std::uint64_t albedoKey = 0x616c6265646fu;

int directionsFor(const SurfaceVertices &vertices) {
    if (!vertices.code().facts().affine)
        return directionsOfGathered;
    const std::vector<ConePlanes> &cones = vertices.prepared().cones;
    const bool noiseless = cones.size() == 1 && cones[0].exact && cones[0].first;
    return noiseless ? 1 : directionsOfAffine;
}

void address(const PathsAtVertices &paths, int count, int directions, AlbedoPlanes &own) {
    for (int i = 0; i < count; ++i) {
        own.pixelKey[i] = std::uint32_t(mixBits(albedoKey << 32 ^ paths.pixelKey[i]) >> 32);
        own.sampleIndex[i] = paths.sampleIndex[i] * std::uint32_t(directions);
    }
}

/// The next direction of every vertex; `pdf` is 0 where there is none.
ConstVec3Planes nextDirection(int count, AlbedoPlanes &own) {
    sobolPairs(count, own.pixelKey, own.sampleIndex, 0, own.numbers[0], own.numbers[1]);
    const Planes<float> &to = own.direction;
    own.mixture.sample(own.numbers[0], own.numbers[1], {to[0], to[1], to[2]});
    const ConstVec3Planes direction{to[0], to[1], to[2]};
    own.mixture.pdf(direction, own.pdf[0]);
    for (int i = 0; i < count; ++i)
        ++own.sampleIndex[i];
    return direction;
}

/// What one of `directions` is worth: see eventScales() in scatter.cpp.
CANDELA_HOT void directionWorth(int count, const float *__restrict total, int directions,
                                float *__restrict pdf) {
    constexpr float pi = float(M_PI);
    const float share = 1.0f / float(directions);
    for (int i = 0; i < count; ++i) {
        const bool some = (total[i] > 0) & (pdf[i] > 0);
        pdf[i] = some ? share / (pi * (some ? pdf[i] : 1.0f)) : 0.0f;
    }
}

/// Lanes without a direction answer 0, whatever the shader said.
CANDELA_HOT void addAnswers(int count, const float *__restrict response,
                            const float *__restrict worth, float *__restrict sum) {
    for (int i = 0; i < count; ++i)
        sum[i] += worth[i] > 0 ? response[i] * worth[i] : 0.0f;
}

void askAlongDirections(SurfaceVertices &vertices, int directions, AlbedoPlanes &own) {
    const int count = vertices.count();
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = own.response[c];
    for (int k = 0; k < directions; ++k) {
        const ConstVec3Planes direction = nextDirection(count, own);
        directionWorth(count, own.mixture.total(), directions, own.pdf[0]);
        vertices.scatter(direction, own.answered[0], nullptr, response);
        for (int c = 0; c < colorSamples; ++c)
            addAnswers(count, response[c], own.pdf[0], own.sum[c]);
    }
}

std::array<float *, colorSamples> shade(SurfaceVertices &vertices, int rows, AlbedoPlanes &own,
                                        const Planes<float> &to) {
    std::array<float *, colorSamples> Ci, Oi;
    for (int c = 0; c < colorSamples; ++c)
        Ci[c] = to[c], Oi[c] = own.opacity[c];
    vertices.shade(rows, own.rows.L(0).data(), own.rows.Cl(0).data(), own.rows.light(0), nullptr,
                   Ci.data(), Oi.data());
    return Ci;
}

/// All directions at once, as GatheredLight gives them; what the shader sends in darkness is its
/// emission.
void askWithAll(SurfaceVertices &vertices, int directions, AlbedoPlanes &own) {
    const int count = vertices.count();
    own.rows.reserve(directionsOfGathered, vertices.lanes());
    for (int k = 0; k < directions; ++k) {
        const ConstVec3Planes direction = nextDirection(count, own);
        directionWorth(count, own.mixture.total(), directions, own.pdf[0]);
        const MutableVec3Planes L = own.rows.L(k);
        for (int c = 0; c < 3; ++c)
            std::copy_n(direction[c], count, L[c]);
        std::fill_n(own.rows.light(k), count, 0);
        for (float *Cl : own.rows.Cl(k))
            std::copy_n(own.pdf[0], count, Cl);
    }
    vertices.speak(false);
    const auto lit = shade(vertices, directions, own, own.response);
    const auto dark = shade(vertices, 0, own, own.darkness);
    vertices.speak(true);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            own.sum[c][i] = lit[c][i] - dark[c][i];
}

/// The shader's cones; for shaders that are not affine in the light, whose cones' importance says
/// nothing, a cosine lobe.
void stateMixture(SurfaceVertices &vertices, AlbedoPlanes &own) {
    const ConstVec3Planes facing = vertices.facingPlanes();
    std::vector<ConePlanes> cones = vertices.prepared().cones;
    if (!vertices.code().facts().affine) {
        const float *angle = own.cosineLobe[0], *one = own.cosineLobe[1];
        cones = {{facing, angle, one, one, angle, 0, true, false}};
    }
    own.mixture.state(vertices.count(), cones, facing, own.events.transmission());
}

/// True where light goes on in single directions.
bool goesStraight(const SurfaceVertices &vertices, const AlbedoPlanes &own, int i) {
    const float *through = own.events.transmission();
    bool straight = through && through[i] > 0;
    for (const ConePlanes &cone : vertices.prepared().cones)
        straight |= cone.first && !(cone.kindAngle[i] > 0) && cone.importance[i] > 0;
    return straight;
}

/// NaN is reported as elsewhere and counts as black.
void finish(PathWave &wave, AlbedoPlanes &own) {
    SurfaceVertices &vertices = wave.chunk.vertices;
    const float *total = own.mixture.total(), *completed = vertices.prepared().completed;
    for (int i = 0; i < vertices.count(); ++i) {
        const bool mirror = !(total[i] > 0) && goesStraight(vertices, own, i);
        bool finite = true;
        for (int c = 0; c < colorSamples; ++c)
            finite &= bool(std::isfinite(own.sum[c][i]));
        if (!finite)
            reportNonFinite(wave, i, vertices.code().name());
        const bool black = !finite || (completed && !(completed[i] > 0));
        for (int c = 0; c < colorSamples; ++c) {
            const float answer = black ? 0.0f : mirror ? 1.0f : own.sum[c][i];
            own.sum[c][i] = std::clamp(answer, 0.0f, 1.0f);
        }
    }
}

} // namespace

AlbedoPlanes::AlbedoPlanes(int capacity)
    : mixture(capacity), events(capacity), keys(2, capacity), pixelKey(keys[0]),
      sampleIndex(keys[1]), numbers(2, capacity), direction(3, capacity), pdf(1, capacity),
      cosineLobe(2, capacity), response(colorSamples, capacity), opacity(colorSamples, capacity),
      darkness(colorSamples, capacity), answered(1, capacity), sum(colorSamples, capacity) {
    std::fill_n(answered[0], answered.lanes(), finiteRequests);
    std::fill_n(cosineLobe[0], cosineLobe.lanes(), 180.0f);
    std::fill_n(cosineLobe[1], cosineLobe.lanes(), 1.0f);
}

std::array<const float *, colorSamples> seeAlbedo(PathWave &wave) {
    SurfaceVertices &vertices = wave.chunk.vertices;
    if (!wave.albedo)
        wave.albedo = std::make_unique<AlbedoPlanes>(VertexChunk::capacity);
    AlbedoPlanes &own = *wave.albedo;
    const int directions = directionsFor(vertices);
    own.events.look(vertices);
    stateMixture(vertices, own);
    address(wave.chunk.paths, vertices.count(), directions, own);
    std::array<const float *, colorSamples> result;
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(own.sum[c], vertices.count(), 0.0f);
        result[c] = own.sum[c];
    }
    if (vertices.code().facts().affine)
        askAlongDirections(vertices, directions, own);
    else
        askWithAll(vertices, directions, own);
    finish(wave, own);
    return result;
}

} // namespace candela

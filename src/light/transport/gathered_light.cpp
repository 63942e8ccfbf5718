// SPDX-License-Identifier: Apache-2.0
#include "light/transport/gathered_light.h"

#include "foundation/base/hash.h"
#include "foundation/base/lanes.h"
#include "light/transport/path_wave.h"
#include "light/transport/sobol.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// The dimension pairs of a round. The path that it sends out begins on a surface, so it leaves
/// those of the camera free.
enum RoundPair { onLightPair, alongPair, choicePair, roundPairs };
static_assert(int(roundPairs) <= int(cameraPairs));

} // namespace

GatheredLight::GatheredLight(int capacity, std::unique_ptr<PathWave> wave)
    : wave_(std::move(wave)), mixture_(capacity), light_(capacity), shadow_(capacity),
      keys_(2, capacity), random_(2 * roundPairs, capacity), weights_(4, capacity),
      vectors_(6, capacity), black_(2 * colorSamples, capacity),
      rows_(3 + colorSamples, 2 * rounds * paddedLanes(capacity)),
      rowLights_(1, 2 * rounds * paddedLanes(capacity)) {
    std::fill_n(weights_[1], weights_.lanes(), 1.0f);
}

GatheredLight::~GatheredLight() = default;

int GatheredLight::gather(SurfaceVertices &vertices, const GatherQuery &query, float *const *Ci) {
    const int count = vertices.count();
    lanes_.clear();
    for (int i = 0; i < count; ++i) {
        weights_[0][i] = query.depth[i] < query.maxDepth ? 1.0f : 0.0f;
        if (query.depth[i] < query.maxDepth)
            lanes_.push_back(i);
    }
    stateMixture(vertices, query);
    address(query, count);
    row_ = 0;
    int traced = 0;
    for (int round = 0; round < rounds; ++round) {
        for (int pair = 0; pair < roundPairs; ++pair)
            sobolPairs(count, keys_[0], keys_[1], std::uint32_t(pair), random_[2 * pair],
                       random_[2 * pair + 1]);
        if (vertices.scene().hasLights())
            traced += addLightRow(vertices);
        if (wave_)
            addDirectionRow(vertices, query);
        for (int i = 0; i < count; ++i)
            ++keys_[1][i];
    }
    shade(vertices, row_, query.ambient, Ci);
    subtractEmission(vertices, Ci);
    return traced;
}

/// Rounds are samples of a sequence that belongs to the pixel and the number of the vertex.
void GatheredLight::address(const GatherQuery &query, int count) {
    const std::uint64_t salt = std::uint64_t(query.vertex + 1) << 32;
    for (int i = 0; i < count; ++i) {
        keys_[0][i] = std::uint32_t(mixBits(salt | query.pixelKey[i]) >> 32);
        keys_[1][i] = query.sampleIndex[i] * std::uint32_t(rounds);
    }
}

/// All finite cones that the shader states, and a cosine lobe, in equal parts: the importance of
/// a cone is the answer to a unit of light, which says little where answers don't add up.
void GatheredLight::stateMixture(SurfaceVertices &vertices, const GatherQuery &query) {
    const int count = vertices.count();
    std::vector<ConePlanes> cones;
    if (!query.hemisphereOnly)
        cones = vertices.cones();
    const int own = int(cones.size());
    if (importance_.planes() < own + 3)
        importance_ = Planes<float>(own + 3, vertices.lanes());
    for (int k = 0; k < own; ++k) {
        float *importance = importance_[3 + k];
        for (int i = 0; i < count; ++i) {
            const auto &axis = cones[k].axis;
            bool stated = axis[0][i] != 0 || axis[1][i] != 0 || axis[2][i] != 0;
            importance[i] = stated ? 1.0f : 0.0f;
        }
        cones[k].importance = importance;
    }
    float *angle = importance_[0], *one = importance_[1], *cosine = importance_[2];
    std::fill_n(angle, count, 180.0f);
    std::fill_n(one, count, 1.0f);
    std::fill_n(cosine, count, 1.0f);
    cones.push_back({vertices.facingPlanes(), angle, one, cosine, angle, 0, true});
    mixture_.state(count, cones, vertices.facingPlanes(), query.transmits);
}

MutableVec3Planes GatheredLight::rowL() const {
    const int at = row_ * vectors_.lanes();
    return {rows_[0] + at, rows_[1] + at, rows_[2] + at};
}

std::array<float *, colorSamples> GatheredLight::rowCl() const {
    std::array<float *, colorSamples> Cl;
    for (int c = 0; c < colorSamples; ++c)
        Cl[c] = rows_[3 + c] + row_ * vectors_.lanes();
    return Cl;
}

std::int32_t *GatheredLight::rowLight() const { return rowLights_[0] + row_ * vectors_.lanes(); }

/// One light by chance, weighted against the chance that a direction finds it.
int GatheredLight::addLightRow(SurfaceVertices &vertices) {
    const int count = vertices.count();
    LightQuery query;
    query.count = count;
    query.P = vertices.P();
    query.lightSet = vertices.points.lightSet;
    query.time = vertices.points.input(int(ShaderInput::time));
    query.choice = random_[2 * choicePair];
    query.position = {random_[2 * onLightPair], random_[2 * onLightPair + 1]};
    LightSamples &samples = light_.samples;
    vertices.scene().sampleLights(query, samples);

    ConstVec3Planes L{samples.L[0], samples.L[1], samples.L[2]};
    float *mixturePdf = weights_[2], *weight = weights_[3];
    std::fill_n(mixturePdf, count, 0.0f);
    if (wave_) {
        unitDirections(count, L[0], L[1], L[2], vectors_[0], vectors_[1], vectors_[2]);
        mixture_.pdf({vectors_[0], vectors_[1], vectors_[2]}, mixturePdf);
    }
    lightWeights(count, samples.pdfSolidAngle, mixturePdf, weights_[1], weights_[0], weight);

    for (int c = 0; c < 3; ++c)
        std::copy_n(L[c], count, rowL()[c]);
    std::copy_n(samples.light, count, rowLight());
    const auto Cl = rowCl();
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            Cl[c][i] = samples.light[i] != 0 && weight[i] > 0
                           ? samples.value[c][i] * weight[i] * (1.0f / rounds)
                           : 0.0f;
    shadowed_.clear();
    for (int i : lanes_) {
        bool lit = false;
        for (int c = 0; c < colorSamples; ++c)
            lit |= Cl[c][i] != 0;
        if (lit && samples.castsShadow[i])
            shadowed_.push_back(i);
    }
    ++row_;
    return shadow_.attenuate(vertices, samples, int(shadowed_.size()), shadowed_.data(), Cl.data());
}

/// What comes along a direction of the mixture, from paths of its own.
void GatheredLight::addDirectionRow(SurfaceVertices &vertices, const GatherQuery &query) {
    const int count = vertices.count();
    MutableVec3Planes direction{vectors_[0], vectors_[1], vectors_[2]};
    MutableVec3Planes origin{vectors_[3], vectors_[4], vectors_[5]};
    ConstVec3Planes along{direction[0], direction[1], direction[2]};
    float *pdf = weights_[2];
    mixture_.sample(random_[2 * alongPair], random_[2 * alongPair + 1], direction);
    mixture_.pdf(along, pdf);
    vertices.rayOrigins(along, origin);

    wave_->startGathering(int(lanes_.size()), lanes_.data(),
                          {{origin[0], origin[1], origin[2]},
                           along,
                           vertices.points.input(int(ShaderInput::time)),
                           pdf,
                           query.depth,
                           vertices.points.lightSet,
                           query.x,
                           query.y,
                           keys_[0],
                           keys_[1]});
    wave_->run();

    const auto Cl = rowCl();
    for (int c = 0; c < 3; ++c)
        std::copy_n(along[c], count, rowL()[c]);
    std::fill_n(rowLight(), count, 0);
    for (int c = 0; c < colorSamples; ++c) {
        const float *radiance = wave_->results().radiance[c];
        std::fill_n(Cl[c], count, 0.0f);
        for (std::size_t ray = 0; ray < lanes_.size(); ++ray) {
            const int i = lanes_[ray];
            Cl[c][i] = pdf[i] > 0 ? radiance[ray] / (pi * pdf[i] * rounds) : 0.0f;
        }
    }
    ++row_;
}

void GatheredLight::shade(SurfaceVertices &vertices, int rows, const float *const *ambient,
                          float *const *Ci) {
    std::array<float *, 3> L{rows_[0], rows_[1], rows_[2]};
    std::array<float *, colorSamples> Cl, Oi;
    for (int c = 0; c < colorSamples; ++c) {
        Cl[c] = rows_[3 + c];
        Oi[c] = black_[colorSamples + c];
    }
    vertices.shade(rows, L.data(), Cl.data(), rowLights_[0], ambient, Ci, Oi.data());
}

/// A shader's own emission is what it sends in darkness. Where it makes the surface a light, hits
/// and light samples count it.
void GatheredLight::subtractEmission(SurfaceVertices &vertices, float *const *Ci) {
    const int count = vertices.count();
    if (!vertices.code().facts().emits || lanes::allEqual(count, vertices.points.light, 0))
        return;
    std::array<float *, colorSamples> dark;
    for (int c = 0; c < colorSamples; ++c)
        dark[c] = black_[c];
    shade(vertices, 0, nullptr, dark.data());
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            Ci[c][i] -= dark[c][i];
}

} // namespace candela

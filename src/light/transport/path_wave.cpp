// SPDX-License-Identifier: Apache-2.0
#include "light/transport/path_wave.h"

#include "foundation/base/hot.h"
#include "light/transport/sobol.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// The dimension pairs of a path: three for the camera, then four a vertex.
enum CameraPair { filterPair, lensPair, timePair, cameraPairs };
enum VertexPair { lightPositionPair, directionPair, lightChoicePair, eventPair, vertexPairs };

/// Roulette begins when a path has scattered this often (DEPS section 8, rule 7).
constexpr int rouletteDepth = 3;

/// Paths through stacks of transparent surfaces end here, whatever the depth allows.
constexpr int mostVertices = 1000;

/// The weight of emission that a direction of density lastPdf found, against light sampling.
CANDELA_HOT void emissionWeights(int count, const float *__restrict lastPdf,
                                 const float *__restrict distance,
                                 const float *__restrict areaPdf, const float *__restrict cosine,
                                 float *__restrict weight) {
    for (int i = 0; i < count; ++i) {
        float pb = lastPdf[i];
        float pl = areaPdf[i] * distance[i] * distance[i] / std::max(std::fabs(cosine[i]), 1e-9f);
        float shared = pb * pb / (pb * pb + pl * pl);
        weight[i] = pb > 0 ? shared : 1.0f;
    }
}

} // namespace

PathWave::PathWave(const Scene &scene, const IntegratorSettings &settings,
                   const PixelFilterSampler &filter, std::span<const ChannelInfo> channels,
                   TransportStatistics &statistics, NonFiniteReporter &nonFinite)
    : scene_(scene), settings_(settings), filter_(filter), firstHit_(firstHitPlanes(channels)),
      statistics_(statistics), nonFinite_(nonFinite), results_(capacity, int(firstHit_.size())),
      active_(capacity), next_(capacity), hits_(capacity), order_(capacity),
      binStart_(scene.codeCount() + 1), vertices_(chunk), mixture_(chunk), events_(chunk),
      direct_(chunk), classic_(chunk), state_(colorSamples + 2, chunk),
      stateIntegers_(4, chunk), keys_(2, chunk), random_(2 * vertexPairs, chunk),
      answers_(3 * colorSamples, chunk), scratch_(8, chunk) {}

// ---- The camera ----

void PathWave::startCamera(int pixels, const int *x, const int *y, int first, int last) {
    slots_ = 0;
    for (int pixel = 0; pixel < pixels; ++pixel) {
        std::uint32_t key = pixelKey(x[pixel], y[pixel], settings_.seed);
        for (int sample = first; sample < last; ++sample, ++slots_) {
            results_.x[slots_] = x[pixel], results_.y[slots_] = y[pixel];
            results_.sampleIndex[slots_] = sample;
            results_.keys[0][slots_] = key;
        }
    }
    for (int c = 0; c < colorSamples; ++c) {
        std::fill_n(results_.radiance[c], slots_, 0.0f);
        std::fill_n(results_.opacity[c], slots_, 0.0f);
    }
    for (int plane = 0; plane < results_.channels.planes(); ++plane)
        std::fill_n(results_.channels[plane], slots_, firstHit_[plane].background);

    Planes<float> numbers(8, slots_);
    const std::uint32_t *samples = reinterpret_cast<const std::uint32_t *>(results_.sampleIndex);
    for (int pair = 0; pair < cameraPairs; ++pair)
        sobolPairs(slots_, results_.keys[0], samples, pair, numbers[2 * pair],
                   numbers[2 * pair + 1]);
    float *rasterX = numbers[6], *rasterY = numbers[7];
    for (int i = 0; i < slots_; ++i) {
        FilterSample at = filter_.sample(numbers[0][i], numbers[1][i]);
        rasterX[i] = float(results_.x[i]) + 0.5f + at.dx;
        rasterY[i] = float(results_.y[i]) + 0.5f + at.dy;
        results_.weight[0][i] = at.weight;
    }
    scene_.camera().rays(slots_, rasterX, rasterY, numbers[2], numbers[3], numbers[4],
                         active_.rays);
    active_.rays.count = active_.count = slots_;
    for (int i = 0; i < slots_; ++i) {
        for (int c = 0; c < colorSamples; ++c)
            active_.throughput[c][i] = 1;
        active_.lastPdf[i] = active_.travelled[i] = 0;
        active_.slot[i] = i;
        active_.depth[i] = 0;
        active_.lightSet[i] = -1;
        active_.seen[i] = 1;
    }
    statistics_.paths += slots_;
    statistics_.cameraRays += slots_;
}

void PathWave::run() {
    for (int iteration = 0; active_.count > 0 && iteration < mostVertices; ++iteration) {
        traceAndShade(iteration);
        std::swap(active_, next_);
        statistics_.bounceRays += active_.count;
    }
}

// ---- One vertex of all paths ----

void PathWave::traceAndShade(int iteration) {
    scene_.intersect(active_.rays, hits_,
                     iteration == 0 ? Coherence::Primary : Coherence::Secondary);
    binByCode();
    next_.count = next_.rays.count = 0;
    for (int code = 0; code < scene_.codeCount(); ++code)
        for (int at = binStart_[code]; at < binStart_[code + 1]; at += chunk)
            shadeChunk(code, order_.data() + at, std::min(chunk, binStart_[code + 1] - at),
                       iteration);
    next_.rays.count = next_.count;
}

/// Counting sort: order_ lists the hits of each code in the order of their rays.
void PathWave::binByCode() {
    std::fill(binStart_.begin(), binStart_.end(), 0);
    for (int i = 0; i < active_.count; ++i)
        if (hits_.primitive[i] != noHit)
            ++binStart_[scene_.codeOf(hits_.primitive[i]) + 1];
    for (std::size_t code = 1; code < binStart_.size(); ++code)
        binStart_[code] += binStart_[code - 1];
    binNext_ = binStart_;
    for (int i = 0; i < active_.count; ++i)
        if (hits_.primitive[i] != noHit)
            order_[binNext_[scene_.codeOf(hits_.primitive[i])]++] = i;
}

void PathWave::shadeChunk(int code, const int *order, int count, int iteration) {
    vertices_.meet(scene_, code, active_.rays, hits_, order, count);
    gatherState(order, count);
    if (vertices_.code().reads(ShaderInput::seed)) {
        float *seed = vertices_.points.input(int(ShaderInput::seed));
        randomBits(count, keys_[0], keys_[1], iteration, reinterpret_cast<std::uint32_t *>(seed));
    }
    addEmission();

    std::array<float *, colorSamples> ambient;
    bool lit = scene_.hasAmbient() && vertices_.code().facts().readsAmbient;
    for (int c = 0; c < colorSamples; ++c) {
        ambient[c] = answers_[2 * colorSamples + c];
        if (lit)
            std::fill_n(ambient[c], count, 0.0f);
    }
    if (lit)
        scene_.ambient(count, vertices_.P(), vertices_.points.lightSet, ambient.data());
    vertices_.prepare(lit ? ambient.data() : nullptr);
    addVisible(order);
    for (int pair = 0; pair < vertexPairs; ++pair)
        sobolPairs(count, keys_[0], keys_[1], cameraPairs + iteration * vertexPairs + pair,
                   random_[2 * pair], random_[2 * pair + 1]);
    if (settings_.kind == IntegratorKind::Classic)
        lightClassic(lit ? ambient.data() : nullptr);
    else
        lightPath();
    scatterOn();
}

void PathWave::gatherState(const int *order, int count) {
    for (int i = 0; i < count; ++i) {
        int at = order[i], slot = active_.slot[at];
        for (int c = 0; c < colorSamples; ++c)
            state_[c][i] = active_.throughput[c][at];
        state_[colorSamples][i] = active_.lastPdf[at];
        state_[colorSamples + 1][i] = active_.travelled[at] + hits_.t[at];
        stateIntegers_[0][i] = slot;
        stateIntegers_[1][i] = active_.depth[at];
        stateIntegers_[2][i] = active_.lightSet[at];
        stateIntegers_[3][i] = active_.seen[at];
        keys_[0][i] = results_.keys[0][slot];
        keys_[1][i] = results_.sampleIndex[slot];
    }
}

/// radiance += throughput * contribution; what is not finite is reported and left out.
void PathWave::addToRadiance(const float *const *contribution) {
    const int *slot = stateIntegers_[0];
    for (int i = 0; i < vertices_.count(); ++i) {
        float added[colorSamples], sum = 0;
        for (int c = 0; c < colorSamples; ++c) {
            added[c] = state_[c][i] * contribution[c][i];
            sum += added[c];
        }
        if (!std::isfinite(sum)) {
            nonFinite_.found(vertices_.code().name(), results_.x[slot[i]], results_.y[slot[i]],
                             results_.sampleIndex[slot[i]]);
            continue;
        }
        for (int c = 0; c < colorSamples; ++c)
            results_.radiance[c][slot[i]] += added[c];
    }
}

void PathWave::addEmission() {
    const int count = vertices_.count();
    const std::int32_t *light = vertices_.points.light;
    if (std::all_of(light, light + count, [](std::int32_t l) { return l == 0; }))
        return;
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c) {
        radiance[c] = answers_[c];
        std::fill_n(radiance[c], count, 0.0f);
    }
    scene_.emission(vertices_.codeIndex(), vertices_.points, radiance);

    float *cosine = scratch_[0], *weight = scratch_[1];
    ConstVec3Planes I = vertices_.input(ShaderInput::I);
    for (int i = 0; i < count; ++i) {
        Vec3 direction = normalize({I[0][i], I[1][i], I[2][i]});
        cosine[i] = dot(direction, vertices_.facing(i));
    }
    emissionWeights(count, state_[colorSamples], state_[colorSamples + 1],
                    vertices_.points.lightPdfArea, cosine, weight);
    const int *lightSet = stateIntegers_[2];
    for (int i = 0; i < count; ++i) {
        bool shinesThere = light[i] == 0 || lightSet[i] < 0 || state_[colorSamples][i] == 0 ||
                           scene_.lightIsOn(lightSet[i], light[i]);
        for (int c = 0; c < colorSamples; ++c)
            radiance[c][i] *= shinesThere ? weight[i] : 0;
    }
    addToRadiance(radiance);
}

/// What the camera sees at first hand: opacity, and the channels of the first surface.
void PathWave::addVisible(const int *order) {
    const int *slot = stateIntegers_[0], *seen = stateIntegers_[3];
    for (int i = 0; i < vertices_.count(); ++i)
        if (seen[i])
            for (int c = 0; c < colorSamples; ++c)
                results_.opacity[c][slot[i]] += state_[c][i] * vertices_.Oi(c)[i];
    for (std::size_t plane = 0; plane < firstHit_.size(); ++plane) {
        const FirstHitPlane &from = firstHit_[plane];
        for (int i = 0; i < vertices_.count(); ++i) {
            if (!seen[i] || active_.travelled[order[i]] != 0)
                continue;
            float &value = results_.channels[int(plane)][slot[i]];
            if (from.primitive)
                value = float(vertices_.points.primitive[i] + 1);
            else if (from.input >= 0)
                value = vertices_.points.input(from.input)[i];
        }
    }
}

// ---- Light and the way on ----

/// Every light at once, as RI 3.1 has it; what is left to follow is trace() and what shines
/// through.
void PathWave::lightClassic(const float *const *ambient) {
    float *Ci[colorSamples], *Oi[colorSamples];
    for (int c = 0; c < colorSamples; ++c) {
        Ci[c] = answers_[c];
        Oi[c] = answers_[colorSamples + c];
    }
    statistics_.shadowRays +=
        classic_.shade(vertices_, 1, random_[2 * lightPositionPair],
                       random_[2 * lightPositionPair + 1], ambient, Ci, Oi);
    addToRadiance(Ci);
    float *noFiniteLobe = scratch_[2];
    std::fill_n(noFiniteLobe, vertices_.count(), 0.0f);
    events_.choose(vertices_, noFiniteLobe, random_[2 * eventPair]);
}

/// One light by chance, and the choice of the event by which the path goes on.
void PathWave::lightPath() {
    const int count = vertices_.count();
    float *contribution[colorSamples];
    std::array<const float *, colorSamples> ambient;
    for (int c = 0; c < colorSamples; ++c) {
        contribution[c] = answers_[c];
        ambient[c] = vertices_.Ca(c);
    }
    if (ambient[0])
        addToRadiance(ambient.data());
    stateMixture();
    events_.choose(vertices_, mixture_.total(), random_[2 * eventPair]);
    if (!scene_.hasLights())
        return;
    float *wanted = scratch_[2];
    for (int i = 0; i < count; ++i)
        wanted[i] = stateIntegers_[1][i] < settings_.maxDepth ? 1 : 0;
    statistics_.shadowRays += direct_.gather(
        vertices_, mixture_, events_.finiteProbability(), wanted, random_[2 * lightChoicePair],
        random_[2 * lightPositionPair], random_[2 * lightPositionPair + 1], contribution);
    addToRadiance(contribution);
}

void PathWave::stateMixture() {
    float *transmits = scratch_[3];
    ScatteringEvents::transmission(vertices_, transmits);
    if (!settings_.hemisphereOnly) {
        mixture_.state(vertices_.count(), vertices_.cones(), vertices_.facingPlanes(), transmits);
        return;
    }
    // A cosine lobe about the facing normal, as important as all finite cones together.
    float *angle = scratch_[4], *exponent = scratch_[5], *importance = scratch_[6];
    mixture_.state(vertices_.count(), vertices_.cones(), vertices_.facingPlanes(), transmits);
    std::copy_n(mixture_.total(), vertices_.count(), importance);
    std::fill_n(angle, vertices_.count(), 180.0f);
    std::fill_n(exponent, vertices_.count(), 1.0f);
    mixture_.state(vertices_.count(),
                   {{vertices_.facingPlanes(), angle, exponent, importance, angle, 0, true}},
                   vertices_.facingPlanes(), transmits);
}

void PathWave::scatterOn() {
    const int count = vertices_.count();
    MutableVec3Planes direction = events_.direction();
    if (events_.any(finiteRequests, count)) {
        MutableVec3Planes sampled{scratch_[3], scratch_[4], scratch_[5]};
        mixture_.sample(random_[2 * directionPair], random_[2 * directionPair + 1], sampled);
        for (int i = 0; i < count; ++i)
            if (events_.event()[i] == finiteRequests)
                for (int c = 0; c < 3; ++c)
                    direction[c][i] = sampled[c][i];
        mixture_.pdf({direction[0], direction[1], direction[2]}, scratch_[6]);
    }
    followEvents(random_[2 * lightChoicePair + 1]);
}

void PathWave::followEvents(const float *roulette) {
    const int count = vertices_.count();
    MutableVec3Planes direction = events_.direction();
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = answers_[c];
    vertices_.scatter({direction[0], direction[1], direction[2]}, events_.event(), nullptr, g);
    const float *mixturePdf = scratch_[6];
    for (int i = 0; i < count; ++i) {
        std::int32_t event = events_.event()[i];
        if (event == pathEnds)
            continue;
        bool through = event == straightThrough;
        if (!through && stateIntegers_[1][i] >= settings_.maxDepth)
            continue;
        bool finite = event == finiteRequests;
        float pdf = finite ? mixturePdf[i] * events_.probability()[i] : 0;
        float scale = finite ? 1 / (pi * pdf) : 1 / events_.probability()[i];
        Color throughput;
        float brightest = 0;
        for (int c = 0; c < colorSamples; ++c) {
            float factor = through ? 1 - vertices_.Oi(c)[i] : g[c][i];
            throughput[c] = state_[c][i] * factor * scale;
            brightest = std::max(brightest, std::fabs(throughput[c]));
        }
        if (!(brightest > 0))
            continue;
        if (!std::isfinite(brightest)) {
            int slot = stateIntegers_[0][i];
            nonFinite_.found(vertices_.code().name(), results_.x[slot], results_.y[slot],
                             results_.sampleIndex[slot]);
            continue;
        }
        if (stateIntegers_[1][i] >= rouletteDepth) {
            float survival = std::min(0.95f, std::sqrt(brightest));
            if (roulette[i] >= survival)
                continue;
            for (int c = 0; c < colorSamples; ++c)
                throughput[c] /= survival;
        }
        append(i, {direction[0][i], direction[1][i], direction[2][i]}, throughput, event, pdf);
    }
}

void PathWave::append(int i, Vec3 direction, const Color &throughput, std::int32_t event,
                      float pdf) {
    const int at = next_.count++;
    const bool through = event == straightThrough;
    ConstVec3Planes P = vertices_.P();
    Vec3 unit = normalize(direction);
    Vec3 origin = Scene::offsetOrigin({P[0][i], P[1][i], P[2][i]}, vertices_.facing(i), unit,
                                      vertices_.points.offset[i]);
    RayBatch &rays = next_.rays;
    rays.originX[at] = origin.x, rays.originY[at] = origin.y, rays.originZ[at] = origin.z;
    rays.directionX[at] = unit.x, rays.directionY[at] = unit.y, rays.directionZ[at] = unit.z;
    rays.tMax[at] = INFINITY;
    rays.time[at] = vertices_.points.input(int(ShaderInput::time))[i];
    for (int c = 0; c < colorSamples; ++c)
        next_.throughput[c][at] = throughput[c];
    next_.lastPdf[at] = through ? state_[colorSamples][i] : pdf;
    next_.travelled[at] = through ? state_[colorSamples + 1][i] : 0;
    next_.slot[at] = stateIntegers_[0][i];
    next_.depth[at] = stateIntegers_[1][i] + (through ? 0 : 1);
    next_.lightSet[at] = through ? stateIntegers_[2][i] : vertices_.points.lightSet[i];
    next_.seen[at] = through ? stateIntegers_[3][i] : 0;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "light/transport/path_wave.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "light/transport/sobol.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// Roulette begins at this vertex of a path, counted from the first it meets as 1, and only with
/// paths whose throughput is less than this: measured on scene A, 16 % more efficient than roulette
/// from the third vertex on with the root of the throughput itself.
constexpr int rouletteDepth = 2;
constexpr float rouletteBelow = 0.4f;

/// Paths through stacks of transparent surfaces end here, whatever the depth allows.
constexpr int mostVertices = 1000;

/// The weight of emission that a direction of density lastPdf found, against light sampling.
CANDELA_HOT void emissionWeights(int count, const float *__restrict lastPdf,
                                 const float *__restrict distance, const float *__restrict areaPdf,
                                 const float *__restrict cosine, float *__restrict weight) {
    for (int i = 0; i < count; ++i) {
        float pb = lastPdf[i], height = std::fabs(cosine[i]);
        float pl = areaPdf[i] * distance[i] * distance[i] / (height > 1e-9f ? height : 1e-9f);
        float shared = pb * pb / (pb * pb + pl * pl);
        weight[i] = pb > 0 ? shared : 1.0f;
    }
}

/// Cosine between unit normals and incoming directions of any length.
CANDELA_HOT void incidentCosines(int count, const float *__restrict nx, const float *__restrict ny,
                                 const float *__restrict nz, const float *__restrict ix,
                                 const float *__restrict iy, const float *__restrict iz,
                                 float *__restrict cosine) {
    for (int i = 0; i < count; ++i) {
        float squared = ix[i] * ix[i] + iy[i] * iy[i] + iz[i] * iz[i];
        float along = nx[i] * ix[i] + ny[i] * iy[i] + nz[i] * iz[i];
        cosine[i] = along / std::sqrt(squared > 0 ? squared : 1.0f);
    }
}

/// What the chosen event makes of a unit of light: 1/(pi pdf) for finite lobes, 1/q else; and
/// the density that the direction carries, 0 for events without a choice of direction.
CANDELA_HOT void eventScales(int count, const std::int32_t *__restrict event,
                             const float *__restrict probability,
                             const float *__restrict mixturePdf, const int *__restrict depth,
                             int maxDepth, float *__restrict scale, float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        bool finite = event[i] == finiteRequests, through = event[i] == straightThrough;
        bool goesOn = (event[i] != pathEnds) & (through | (depth[i] < maxDepth));
        float density = finite ? mixturePdf[i] * probability[i] : 0.0f;
        float divisor = finite ? pi * density : probability[i];
        pdf[i] = density;
        scale[i] = goesOn & (divisor > 0) ? 1 / (divisor > 0 ? divisor : 1.0f) : 0.0f;
    }
}

/// The throughput after the event in all channels, and the largest of them (NaN stays).
CANDELA_HOT void nextThroughput(int count, const std::array<const float *, colorSamples> &from,
                                const std::array<const float *, colorSamples> &response,
                                const std::array<const float *, colorSamples> &opacity,
                                const std::int32_t *__restrict event, const float *__restrict scale,
                                const std::array<float *, colorSamples> &to,
                                float *__restrict brightest) {
    static_assert(colorSamples == 3);
    const float *__restrict f0 = from[0], *__restrict f1 = from[1], *__restrict f2 = from[2];
    const float *__restrict g0 = response[0], *__restrict g1 = response[1];
    const float *__restrict g2 = response[2];
    const float *__restrict o0 = opacity[0], *__restrict o1 = opacity[1];
    const float *__restrict o2 = opacity[2];
    float *__restrict t0 = to[0], *__restrict t1 = to[1], *__restrict t2 = to[2];
    for (int i = 0; i < count; ++i) {
        bool through = event[i] == straightThrough, goesOn = scale[i] > 0;
        float red = goesOn ? f0[i] * (through ? 1 - o0[i] : g0[i]) * scale[i] : 0.0f;
        float green = goesOn ? f1[i] * (through ? 1 - o1[i] : g1[i]) * scale[i] : 0.0f;
        float blue = goesOn ? f2[i] * (through ? 1 - o2[i] : g2[i]) * scale[i] : 0.0f;
        float largest = std::fabs(red);
        largest = !(std::fabs(green) <= largest) ? std::fabs(green) : largest;
        largest = !(std::fabs(blue) <= largest) ? std::fabs(blue) : largest;
        t0[i] = red, t1[i] = green, t2[i] = blue;
        brightest[i] = largest;
    }
}

/// Russian roulette: survivors[i] != 0 for paths that go on, whose throughput is then to be
/// multiplied by gain. It divides survivors and is no part of any density.
CANDELA_HOT void playRoulette(int count, const float *__restrict brightest,
                              const int *__restrict depth, const float *__restrict chance,
                              int *__restrict survives, float *__restrict gain) {
    for (int i = 0; i < count; ++i) {
        float root = std::sqrt((brightest[i] > 0 ? brightest[i] : 0.0f) * (1 / rouletteBelow));
        float odds = (depth[i] + 1 >= rouletteDepth) & (root < 1) ? root : 1.0f;
        survives[i] = (brightest[i] > 0) & (chance[i] < odds);
        gain[i] = 1 / (odds > 0 ? odds : 1.0f);
    }
}

CANDELA_HOT void chooseDirections(int count, const std::int32_t *__restrict event,
                                  const float *__restrict finite, float *__restrict direction) {
    for (int i = 0; i < count; ++i)
        direction[i] = event[i] == finiteRequests ? finite[i] : direction[i];
}

CANDELA_HOT void markShallow(int count, const int *__restrict depth, int maxDepth,
                             float *__restrict wanted) {
    for (int i = 0; i < count; ++i)
        wanted[i] = depth[i] < maxDepth ? 1.0f : 0.0f;
}

} // namespace

PathWave::PathWave(const Scene &scene, const IntegratorSettings &settings,
                   const PixelFilterSampler &filter, std::span<const ChannelInfo> channels,
                   TransportStatistics &statistics, NonFiniteReporter &nonFinite, Purpose purpose)
    : scene_(scene), settings_(settings), filter_(filter),
      firstHit_(purpose == Purpose::Camera ? firstHitPlanes(channels)
                                           : std::vector<FirstHitPlane>()),
      statistics_(statistics), nonFinite_(nonFinite), purpose_(purpose),
      results_(capacity, int(firstHit_.size())), active_(capacity), next_(capacity),
      hits_(capacity), cameraNumbers_(2 * cameraPairs, capacity), bins_(scene, capacity),
      vertices_(chunk), mixture_(chunk), events_(chunk), direct_(chunk), classic_(chunk),
      state_(2 * colorSamples + 2, chunk), stateIntegers_(6, chunk), keys_(2, chunk),
      random_(2 * vertexPairs, chunk), answers_(3 * colorSamples, chunk), scratch_(8, chunk) {}

// ---- Paths as a whole ----

void PathWave::run() {
    for (int iteration = 0; active_.count > 0 && iteration < mostVertices; ++iteration) {
        traceAndShade(iteration);
        std::swap(active_, next_);
        statistics_.bounceRays += active_.count;
    }
}

// ---- One vertex of all paths ----

void PathWave::traceAndShade(int iteration) {
    bool fromCamera = iteration == 0 && purpose_ == Purpose::Camera;
    scene_.intersect(active_.rays, hits_, fromCamera ? Coherence::Primary : Coherence::Secondary);
    bins_.sort(active_.count, hits_.shape);
    next_.count = next_.rays.count = 0;
    for (int bin = 0; bin < bins_.count(); ++bin) {
        std::span<const int> rays = bins_.rays(bin);
        for (; !rays.empty(); rays = rays.subspan(std::min<std::size_t>(chunk, rays.size())))
            shadeChunk(scene_.codeOfBin(bin), rays.data(), std::min<int>(chunk, int(rays.size())),
                       iteration);
    }
    next_.rays.count = next_.count;
}

void PathWave::shadeChunk(int code, const int *order, int count, int iteration) {
    iteration_ = iteration;
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
    for (int pair : {lightPositionPair, directionPair})
        sampleNumbers(pair);
    // Roulette, too, takes a number of this pair; and no camera path is deeper than the wave.
    if (scene_.readsLightChoice() || iteration + 1 >= rouletteDepth || purpose_ != Purpose::Camera)
        sampleNumbers(lightChoicePair);
    if (settings_.kind == IntegratorKind::Classic)
        lightClassic(lit ? ambient.data() : nullptr);
    else if (!vertices_.code().facts().affine)
        lightGathered(lit ? ambient.data() : nullptr);
    else
        lightPath();
    scatterOn();
    deliverLight();
}

/// The numbers of one of this vertex's dimension pairs, into random_. The first two directions of
/// a path are the first four dimensions of one sequence.
void PathWave::sampleNumbers(int pair) {
    float *x = random_[2 * pair], *y = random_[2 * pair + 1];
    if (pair == directionPair && iteration_ == 1)
        sobolFollowingPairs(vertices_.count(), keys_[0], keys_[1], cameraPairs + pair, x, y);
    else
        sobolPairs(vertices_.count(), keys_[0], keys_[1],
                   cameraPairs + iteration_ * vertexPairs + pair, x, y);
}

void PathWave::gatherState(const int *order, int count) {
    for (int c = 0; c < colorSamples; ++c) {
        lanes::take(count, order, active_.throughput[c], throughput(c));
        std::fill_n(gathered(c), count, 0.0f);
    }
    order_ = order;
    hasHistory_ = false;
    lanes::take(count, order, active_.slot, slot());
    lanes::take(count, order, active_.depth, depth());
    lanes::take(count, order, active_.seen, seen());
    lanes::gather(count, slot(), reinterpret_cast<const int *>(results_.keys[0]),
                  reinterpret_cast<int *>(keys_[0]));
    lanes::gather(count, slot(), results_.sampleIndex, reinterpret_cast<int *>(keys_[1]));
}

/// What the last scattering left: few vertices ask for it.
void PathWave::takeHistory() {
    if (std::exchange(hasHistory_, true))
        return;
    const int count = vertices_.count();
    lanes::take(count, order_, active_.lastPdf, lastPdf());
    lanes::take(count, order_, hits_.t, travelled());
    lanes::take(count, order_, active_.travelled, scratch_[0]);
    lanes::add(count, scratch_[0], travelled());
    lanes::take(count, order_, active_.lightSet, lastLightSet());
}

/// gathered += throughput * contribution
void PathWave::gatherLight(const float *const *contribution) {
    for (int c = 0; c < colorSamples; ++c)
        lanes::multiplyAdd(vertices_.count(), throughput(c), contribution[c], gathered(c));
}

/// The light gathered at the vertices joins what their paths have; what is not finite is
/// reported and left out.
void PathWave::deliverLight() {
    const int count = vertices_.count();
    for (int c = 0; c < colorSamples; ++c)
        if (!lanes::allFinite(count, gathered(c)))
            for (int i = 0; i < count; ++i)
                if (!std::isfinite(gathered(c)[i])) {
                    reportNonFinite(i);
                    for (int k = 0; k < colorSamples; ++k)
                        gathered(k)[i] = 0;
                }
    for (int c = 0; c < colorSamples; ++c) {
        float *radiance = results_.radiance[c];
        const float *light = gathered(c);
        if (slotsAreConsecutive()) {
            lanes::add(count, light, radiance + slot()[0]);
            continue;
        }
        for (int i = 0; i < count; ++i)
            radiance[slot()[i]] += light[i];
    }
}

/// As long as no path has ended or been binned apart: at most first vertices.
bool PathWave::slotsAreConsecutive() const {
    const int count = vertices_.count();
    return iteration_ == 0 && slot()[count - 1] - slot()[0] == count - 1;
}

void PathWave::reportNonFinite(int i) {
    int at = slot()[i];
    int sample = results_.sampleIndex[at];
    if (purpose_ == Purpose::Gathering)
        sample /= GatheredLight::rounds;
    nonFinite_.found(vertices_.code().name(), results_.x[at], results_.y[at], sample);
}

void PathWave::addEmission() {
    const int count = vertices_.count();
    const std::int32_t *light = vertices_.points.light;
    if (lanes::allEqual(count, light, 0))
        return;
    takeHistory();
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c) {
        radiance[c] = answers_[c];
        std::fill_n(radiance[c], count, 0.0f);
    }
    scene_.emission(vertices_.codeIndex(), vertices_.points, radiance);

    float *cosine = scratch_[0], *weight = scratch_[1];
    ConstVec3Planes I = vertices_.input(ShaderInput::I), n = vertices_.facingPlanes();
    incidentCosines(count, n[0], n[1], n[2], I[0], I[1], I[2], cosine);
    emissionWeights(count, lastPdf(), travelled(), vertices_.points.lightPdfArea, cosine, weight);
    for (int i = 0; i < count; ++i)
        if (light[i] != 0 && lastLightSet()[i] >= 0 && lastPdf()[i] > 0 &&
            !scene_.lightIsOn(lastLightSet()[i], light[i]))
            weight[i] = 0;
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            radiance[c][i] *= weight[i];
    gatherLight(radiance);
}

/// What the camera sees at first hand: opacity, and the channels of the first surface.
void PathWave::addVisible(const int *order) {
    const int count = vertices_.count();
    if (lanes::allEqual(count, seen(), 0))
        return;
    for (int c = 0; c < colorSamples; ++c) {
        float *opacity = results_.opacity[c];
        const float *through = throughput(c), *Oi = vertices_.Oi(c);
        if (slotsAreConsecutive()) { // All of them are seen.
            lanes::multiplyAdd(count, through, Oi, opacity + slot()[0]);
            continue;
        }
        for (int i = 0; i < count; ++i)
            if (seen()[i])
                opacity[slot()[i]] += through[i] * Oi[i];
    }
    for (std::size_t plane = 0; plane < firstHit_.size(); ++plane) {
        const FirstHitPlane &from = firstHit_[plane];
        for (int i = 0; i < count; ++i) {
            if (!seen()[i] || active_.travelled[order[i]] != 0)
                continue;
            float &value = results_.channels[int(plane)][slot()[i]];
            if (from.primitive)
                value = float(vertices_.points.primitive[i] + 1);
            else if (from.input >= 0)
                value = vertices_.points.input(from.input)[i];
        }
    }
}

// ---- Light and the way on ----

/// Every light at once, as RI 3.1 has it.
void PathWave::lightClassic(const float *const *ambient) {
    float *Ci[colorSamples], *Oi[colorSamples];
    for (int c = 0; c < colorSamples; ++c) {
        Ci[c] = answers_[c];
        Oi[c] = answers_[colorSamples + c];
    }
    statistics_.shadowRays += classic_.shade(vertices_, 1, random_[2 * lightPositionPair],
                                             random_[2 * lightPositionPair + 1], ambient, Ci, Oi);
    gatherLight(Ci);
    events_.look(vertices_);
    chooseBesidesFiniteLobes();
}

/// Where all finite light has been given, trace() and what shines through are left to follow.
void PathWave::chooseBesidesFiniteLobes() {
    float *noFiniteLobe = scratch_[2];
    std::fill_n(noFiniteLobe, vertices_.count(), 0.0f);
    sampleNumbers(eventPair);
    events_.choose(vertices_, noFiniteLobe, random_[2 * eventPair]);
}

/// One light by chance, and the choice of the event by which the path goes on.
void PathWave::lightPath() {
    float *contribution[colorSamples];
    std::array<const float *, colorSamples> ambient;
    for (int c = 0; c < colorSamples; ++c) {
        contribution[c] = answers_[c];
        ambient[c] = vertices_.Ca(c);
    }
    if (ambient[0])
        gatherLight(ambient.data());
    events_.look(vertices_);
    stateMixture();
    if (events_.needsChoice())
        sampleNumbers(eventPair);
    events_.choose(vertices_, mixture_.total(), random_[2 * eventPair]);
    if (!scene_.hasLights())
        return;
    float *wanted = scratch_[2];
    markShallow(vertices_.count(), depth(), settings_.maxDepth, wanted);
    statistics_.shadowRays += direct_.gather(
        vertices_, mixture_, events_.finiteProbability(), wanted, random_[2 * lightChoicePair],
        random_[2 * lightPositionPair], random_[2 * lightPositionPair + 1], contribution);
    gatherLight(contribution);
}

/// Many samples at once, for shaders that no single one can be asked about.
void PathWave::lightGathered(const float *const *ambient) {
    if (!gatheredLight_) {
        std::unique_ptr<PathWave> wave;
        if (purpose_ == Purpose::Camera)
            wave = std::make_unique<PathWave>(scene_, settings_, filter_,
                                              std::span<const ChannelInfo>(), statistics_,
                                              nonFinite_, Purpose::Gathering);
        gatheredLight_ = std::make_unique<GatheredLight>(chunk, std::move(wave));
    }
    events_.look(vertices_);
    int *x = stateIntegers_[4], *y = stateIntegers_[5];
    lanes::gather(vertices_.count(), slot(), results_.x, x);
    lanes::gather(vertices_.count(), slot(), results_.y, y);
    float *Ci[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        Ci[c] = answers_[c];
    statistics_.shadowRays +=
        gatheredLight_->gather(vertices_,
                               {keys_[0], keys_[1], x, y, depth(), settings_.maxDepth, iteration_,
                                settings_.hemisphereOnly, events_.transmission(), ambient},
                               Ci);
    gatherLight(Ci);
    chooseBesidesFiniteLobes();
}

void PathWave::stateMixture() {
    const float *transmits = events_.transmission();
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
    float *mixturePdf = scratch_[6];
    if (events_.any(finiteRequests, count)) {
        MutableVec3Planes sampled{scratch_[3], scratch_[4], scratch_[5]};
        mixture_.sample(random_[2 * directionPair], random_[2 * directionPair + 1], sampled);
        for (int c = 0; c < 3; ++c)
            chooseDirections(count, events_.event(), sampled[c], direction[c]);
        mixture_.pdf({direction[0], direction[1], direction[2]}, mixturePdf);
    }
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = answers_[c];
    vertices_.scatter({direction[0], direction[1], direction[2]}, events_.event(), nullptr, g);

    float *scale = scratch_[3], *pdf = scratch_[4], *brightest = scratch_[5];
    eventScales(count, events_.event(), events_.probability(), mixturePdf, depth(),
                settings_.maxDepth, scale, pdf);
    nextThroughput(count, {throughput(0), throughput(1), throughput(2)}, {g[0], g[1], g[2]},
                   {vertices_.Oi(0), vertices_.Oi(1), vertices_.Oi(2)}, events_.event(), scale,
                   {answers_[colorSamples], answers_[colorSamples + 1], answers_[colorSamples + 2]},
                   brightest);
    if (!lanes::allFinite(count, brightest))
        for (int i = 0; i < count; ++i)
            if (!std::isfinite(brightest[i])) {
                reportNonFinite(i);
                brightest[i] = 0;
            }
    int *survives = stateIntegers_[4], *lane = stateIntegers_[5];
    float *gain = scratch_[7];
    playRoulette(count, brightest, depth(), random_[2 * lightChoicePair + 1], survives, gain);
    append(lanes::compactUnequal(count, survives, 0, lane), lane, gain, pdf);
}

/// Survivors go on behind those of the chunks before.
void PathWave::append(int count, const int *lane, const float *gain, const float *pdf) {
    const int first = next_.count;
    next_.count += count;
    MutableVec3Planes direction = events_.direction();
    MutableVec3Planes origin{scratch_[0], scratch_[1], scratch_[2]};
    vertices_.rayOrigins({direction[0], direction[1], direction[2]}, origin);

    RayBatch &rays = next_.rays;
    auto take = [&](const float *from, float *to) { lanes::take(count, lane, from, to + first); };
    take(origin[0], rays.origin[0]), take(origin[1], rays.origin[1]),
        take(origin[2], rays.origin[2]);
    take(direction[0], rays.direction[0]), take(direction[1], rays.direction[1]);
    take(direction[2], rays.direction[2]);
    take(vertices_.points.input(int(ShaderInput::time)), rays.time);
    std::fill_n(rays.tMax + first, count, INFINITY);
    for (float *plane : {rays.tMin, rays.width, rays.spread})
        std::fill_n(plane + first, count, 0.0f);
    for (int c = 0; c < colorSamples; ++c) {
        float *next = answers_[colorSamples + c];
        lanes::multiply(vertices_.count(), gain, next);
        take(next, next_.throughput[c]);
    }
    take(pdf, next_.lastPdf);
    std::fill_n(next_.travelled + first, count, 0.0f);
    lanes::take(count, lane, slot(), next_.slot + first);
    lanes::take(count, lane, depth(), next_.depth + first);
    lanes::take(count, lane, vertices_.points.lightSet, next_.lightSet + first);
    std::fill_n(next_.seen + first, count, 0);

    for (int at = first; at < next_.count; ++at)
        ++next_.depth[at];
    if (events_.needsChoice())
        correctSpecialEvents(count, lane, first);
}

/// Directions of mirrors and of what passes straight through have any length; and what passes has
/// not been scattered.
void PathWave::correctSpecialEvents(int count, const int *lane, int first) {
    takeHistory();
    MutableVec3Planes direction = events_.direction();
    for (int k = 0; k < count; ++k) {
        const int i = lane[k], at = first + k;
        if (events_.event()[i] == finiteRequests)
            continue;
        Vec3 unit = normalize({direction[0][i], direction[1][i], direction[2][i]});
        next_.rays.direction[0][at] = unit.x, next_.rays.direction[1][at] = unit.y;
        next_.rays.direction[2][at] = unit.z;
        if (events_.event()[i] != straightThrough)
            continue;
        --next_.depth[at];
        next_.lastPdf[at] = lastPdf()[i];
        next_.travelled[at] = travelled()[i];
        next_.lightSet[at] = lastLightSet()[i];
        next_.seen[at] = seen()[i];
    }
}

} // namespace candela

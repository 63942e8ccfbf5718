// SPDX-License-Identifier: Apache-2.0
// Light goes on at a vertex: directions are drawn as the light sees the surface, and what becomes
// of it is what an eye that looks against it would see (Veach 1997, 5.3: adjoint scattering).
#include "foundation/base/lanes.h"
#include "light/bidir/light_wave.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/vertex/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace candela {

namespace {

/// By how much the view that tells the ratio of refraction is turned, radians.
constexpr float tilt = 0.02f;

/// Roulette is milder with what mirrors and glass pass on: faint reflections of a lamp are seen by
/// nobody else, and paths from lights that meet them are few.
constexpr float oneDirectionShare = 0.1f;

/// An eye that light goes on to along `towards` would see vertex i.
bool showsFront(LightWave &wave, int i, Vec3 towards) {
    const ShadingPoints &points = wave.chunk.vertices.points;
    const ConstVec3Planes Ng = wave.chunk.vertices.input(ShaderInput::Ng);
    return !wave.frame.scene.isOneSided(points.instance[i], points.shape[i]) ||
           dot(towards, at(Ng, i)) > 0;
}

/// The square of the ratio of refraction, from where light comes over where it goes, of what goes
/// on along the delta request `request`; 1 of mirrors, 0 where it can't be told. A view that is
/// turned out of the plane of both directions tells it, whatever normal the shader takes: along the
/// axis of the turn the directions' components have this ratio.
class RefractionRatio {
public:
    RefractionRatio(LightWave &wave, const ConstVec3Planes &direction) : wave_(wave) {
        const Subpaths &ends = *wave.subpaths;
        const int count = wave.chunk.count();
        planes_ = Planes<float>(6, count);
        for (int i = 0; i < count; ++i) {
            const Vec3 along = -at(constant(ends.toPrevious), i);
            Vec3 axis = cross(along, normalize(at(direction, i)));
            if (dot(axis, axis) < 1e-6f)
                axis = cross(along, std::fabs(along.x) < 0.7f ? Vec3{1, 0, 0} : Vec3{0, 1, 0});
            axis = normalize(axis);
            const Vec3 turned = along * std::cos(tilt) + axis * std::sin(tilt);
            for (int c = 0; c < 3; ++c)
                planes_[c][i] = turned[c], planes_[3 + c][i] = axis[c];
        }
        wave.tilted.look(wave.chunk.vertices, {planes_[0], planes_[1], planes_[2]},
                         wave.frame.settings.hemisphereOnly);
    }

    float squared(int i, std::int32_t request) const {
        for (const ConePlanes &cone : wave_.tilted.answers().cones) {
            if (cone.request != request || !cone.first)
                continue;
            if (cone.kindAngle[i] > 0 || !(cone.importance[i] > 0))
                return 0;
            const Vec3 along = normalize(at(cone.axis, i));
            const float ratio =
                dot(along, {planes_[3][i], planes_[4][i], planes_[5][i]}) / std::sin(tilt);
            return ratio * ratio;
        }
        return 0;
    }

private:
    LightWave &wave_;
    Planes<float> planes_;
};

/// `scale` is what roulette measures the largest channel by.
void setThroughput(LightWave &wave, int i, const std::array<float, colorSamples> &before,
                   const std::array<float, colorSamples> &factor, float scale) {
    ScatterPlanes &way = wave.chunk.way;
    float brightest = 0;
    for (int c = 0; c < colorSamples; ++c) {
        way.throughput[c][i] = before[c] * factor[c];
        const float size = std::fabs(way.throughput[c][i]);
        brightest = !(size <= brightest) ? size : brightest;
    }
    way.brightest[i] = std::isfinite(brightest) && scale > 0 ? brightest / scale : 0.0f;
}

/// What has arrived with path i, and what roulette measures by.
void goOnWith(LightWave &wave, int i, const std::array<float, colorSamples> &factor) {
    const Planes<float> &arrived = wave.chunk.paths.throughput;
    setThroughput(wave, i, {arrived[0][i], arrived[1][i], arrived[2][i]}, factor,
                  wave.brightness[0][wave.chunk.paths.slot[i]]);
}

/// Straight on goes what the ray carries: what a light without extent sends is asked behind, too.
void passOn(LightWave &wave, int i) {
    const Planes<float> &carried = wave.active.throughput;
    const int ray = wave.chunk.rays[i];
    std::array<float, colorSamples> before, through;
    float brightest = 0;
    for (int c = 0; c < colorSamples; ++c) {
        before[c] = carried[c][ray];
        through[c] = 1 - wave.chunk.vertices.prepared().Oi[c][i];
        brightest = std::max(brightest, std::fabs(before[c]));
    }
    const bool isFirst = wave.chunk.paths.depth[i] == 0;
    setThroughput(wave, i, before, through,
                  isFirst ? brightest : wave.brightness[0][wave.chunk.paths.slot[i]]);
}

/// Those along chunk.events, which have no choice of direction.
void passOneDirection(LightWave &wave, const ConstVec3Planes &direction) {
    VertexChunk &chunk = wave.chunk;
    Subpaths &ends = *wave.subpaths;
    const std::int32_t *event = chunk.events.event();
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = chunk.way.response[c];
    const bool straight = std::all_of(event, event + chunk.count(), [](std::int32_t e) {
        return e == straightThrough || e == pathEnds;
    });
    const bool affine = chunk.vertices.code().facts().affine;
    std::optional<RefractionRatio> ratio;
    if (!straight && affine) {
        ends.other.scatter(constant(ends.toPrevious), ends.reverseRequest, wave.arrival.light,
                           response);
        ratio.emplace(wave, direction);
    }
    for (int i = 0; i < chunk.count(); ++i) {
        std::array<float, colorSamples> factor{};
        chunk.way.pdf[i] = 0;
        if (event[i] == straightThrough) {
            passOn(wave, i);
            continue;
        }
        const bool passes = affine && event[i] != pathEnds && ends.reversePdf[i] > 0 &&
                            chunk.paths.depth[i] < wave.frame.settings.maxDepth &&
                            showsFront(wave, i, at(direction, i));
        const float squared = passes ? ratio->squared(i, event[i]) : 0.0f;
        for (int c = 0; c < colorSamples; ++c)
            factor[c] = passes ? response[c][i] * squared : 0.0f;
        goOnWith(wave, i, factor);
    }
}

/// Along directions of the finite lobes.
void passFinite(LightWave &wave, const ConstVec3Planes &direction) {
    VertexChunk &chunk = wave.chunk;
    Subpaths &ends = *wave.subpaths;
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = chunk.way.response[c];
    ends.other.scatter(constant(ends.toPrevious), chunk.events.event(), wave.arrival.light,
                       response);
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    for (int i = 0; i < chunk.count(); ++i) {
        std::array<float, colorSamples> factor{};
        const float in = std::fabs(dot(at(constant(ends.toPrevious), i), at(Ng, i)));
        const float out = std::fabs(dot(at(direction, i), at(Ng, i)));
        const bool goesOn = chunk.events.event()[i] == finiteRequests && chunk.way.pdf[i] > 0 &&
                            in > 0 && chunk.paths.depth[i] + 1 < wave.frame.settings.maxDepth &&
                            showsFront(wave, i, at(direction, i));
        const float scale =
            goesOn ? out / (in * std::numbers::pi_v<float> * chunk.way.pdf[i]) : 0.0f;
        for (int c = 0; c < colorSamples; ++c)
            factor[c] = goesOn ? response[c][i] * scale : 0.0f;
        goOnWith(wave, i, factor);
    }
}

void goOn(LightWave &wave, const ConstVec3Planes &direction) {
    VertexChunk &chunk = wave.chunk;
    ScatterPlanes &way = chunk.way;
    lookBack(wave, direction);
    if (chunk.events.finite())
        passFinite(wave, direction);
    else
        passOneDirection(wave, direction);
    const float below = chunk.events.finite() ? rouletteBelow : rouletteBelow * oneDirectionShare;
    const RouletteThresholds thresholds{
        below, chunk.events.kinds() > 0 ? rouletteBelow * firstRouletteShare : 0};
    playRoulette(chunk.count(), way.brightest, chunk.paths.depth, thresholds,
                 chunk.numbers.roulette(), way.survives, way.gain);
    if (wave.vertex >= thresholds.splittingVertices && chunk.events.kinds() > 0)
        shareOnePath(chunk.count(), chunk.events.share(), chunk.numbers.roulette(), way.survives,
                     way.gain);
    append(wave, direction, lanes::compactUnequal(chunk.count(), way.survives, 0, way.lane));
}

} // namespace

void askAgainstLight(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path);
    VertexChunk &chunk = wave.chunk;
    SurfaceVertices &vertices = chunk.vertices;
    vertices.prepare(nullptr);
    stateLobes(wave);
    // Straight through goes what an eye would see from beyond.
    Subpaths &ends = *wave.subpaths;
    const ShadingPoints &points = vertices.points;
    bool clear = chunk.events.transmission() != nullptr;
    for (int i = 0; i < chunk.count() && !clear; ++i)
        clear = wave.frame.scene.isOneSided(points.instance[i], points.shape[i]);
    if (!clear)
        return;
    ends.other.look(vertices, constant(ends.toPrevious), wave.frame.settings.hemisphereOnly);
    const ConstVec3Planes Ng = vertices.input(ShaderInput::Ng);
    for (int i = 0; i < chunk.count(); ++i) {
        // From behind nobody sees a one-sided surface: light that meets its front passes, too.
        const bool unseen = wave.frame.scene.isOneSided(points.instance[i], points.shape[i]) &&
                            dot(at(constant(ends.toPrevious), i), at(Ng, i)) > 0;
        for (int c = 0; c < colorSamples; ++c)
            vertices.setOpacity(c, i, unseen ? 0 : ends.other.answers().Oi[c][i]);
    }
    chunk.events.look(vertices);
}

void scatterLight(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path);
    VertexChunk &chunk = wave.chunk;
    const bool affine = chunk.vertices.code().facts().affine;
    beginEvents(wave, affine ? chunk.mixture.total() : nullptr);
    if (affine && chunk.events.takeFinite(chunk.count(), chunk.mixture.total())) {
        const Planes<float> &sampled = chunk.way.sampled;
        chunk.mixture.sample(chunk.numbers.x(directionPair), chunk.numbers.y(directionPair),
                             {sampled[0], sampled[1], sampled[2]});
        const ConstVec3Planes direction{sampled[0], sampled[1], sampled[2]};
        chunk.mixture.pdf(direction, chunk.way.pdf);
        goOn(wave, direction);
    }
    for (int kind = 0; kind < chunk.events.kinds(); ++kind) {
        if (!chunk.events.takeKind(chunk.vertices, kind))
            continue;
        numberKind(wave, kind);
        const MutableVec3Planes direction = chunk.events.direction();
        goOn(wave, constant(direction));
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Light paths as the camera sees them: each vertex is connected with the lens.
#include "foundation/base/lanes.h"
#include "light/bidir/light_wave.h"
#include "light/sampling/mis.h"
#include "light/vertex/vectors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// What `path` finds more seldom than this, light paths being 1, it does not find.
constexpr double leastOfPath = 1e-9;

/// The vertices that may be seen: on the frame and on a side that shows.
int findSeen(LightWave &wave) {
    VertexChunk &chunk = wave.chunk;
    LightImage &image = wave.image;
    const auto [width, height] = wave.frame.scene.options().format.effectiveResolution();
    const PixelFilterRecord &filter = wave.frame.filter.record();
    const float reach = wave.tally ? float(wave.tally->reach) : 0;
    const float beyondX = filter.xWidth + reach * float(width),
                beyondY = filter.yWidth + reach * float(height);
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    const ShadingPoints &points = chunk.vertices.points;
    int seen = 0;
    for (int i = 0; i < chunk.count(); ++i) {
        const float x = image.sights.x[i], y = image.sights.y[i];
        const bool onFrame = x > -beyondX && x < float(width) + beyondX && y > -beyondY &&
                             y < float(height) + beyondY;
        if (!(image.sights.distance[i] > 0) || !onFrame ||
            chunk.paths.depth[i] + 1 > wave.frame.settings.maxDepth)
            continue;
        const Vec3 direction = at(constant(image.sights.direction), i);
        if (wave.frame.scene.isOneSided(points.instance[i], points.shape[i]) &&
            dot(direction, at(Ng, i)) > 0)
            continue;
        image.lane[seen++] = i;
    }
    return seen;
}

/// What comes through from the vertices lane[0..count) to the lens, asked from the lens.
void traceFromLens(LightWave &wave, int count) {
    LightImage &image = wave.image;
    VertexChunk &chunk = wave.chunk;
    chunk.vertices.rayOrigins(constant(image.towardsLens), image.end);
    const float *time = chunk.vertices.points.input(int(ShaderInput::time));
    const bool inMedia = wave.frame.scene.hasVolumes();
    for (int k = 0; k < count; ++k) {
        const int i = image.lane[k];
        if (inMedia)
            image.media.set(k, {}, chunk.vertices.mediaOf(i));
        const Vec3 lens = at(constant(image.sights.origin), i);
        const Vec3 way = at(constant(image.end), i) - lens;
        for (int c = 0; c < 3; ++c)
            image.rays.origin[c][k] = lens[c], image.rays.direction[c][k] = way[c];
        image.rays.tMin[k] = image.sights.nearest[i] / image.sights.distance[i];
        image.rays.tMax[k] = shadowRayEnd;
        image.rays.time[k] = time[i];
    }
    image.rays.count = count;
    float *planes[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        planes[c] = image.transmittance[c];
    const ShadowMedia media = image.media.media(true);
    if (!wave.frame.scene.transmittance(image.rays, planes, inMedia ? &media : nullptr))
        for (int c = 1; c < colorSamples; ++c)
            std::copy_n(planes[0], count, planes[c]);
    wave.frame.statistics.shadowRays += count;
}

/// seen[c][i] of the vertices lane[0..count), before what stands in the way; those that are black
/// are left out. Returns how many are left.
int weigh(LightWave &wave, int count) {
    LightImage &image = wave.image;
    VertexChunk &chunk = wave.chunk;
    Subpaths &ends = *wave.subpaths;
    const ConstVec3Planes Ng = chunk.vertices.input(ShaderInput::Ng);
    const bool parallel = wave.frame.scene.camera().isParallel();
    int left = 0;
    for (int k = 0; k < count; ++k) {
        const int i = image.lane[k];
        const double out =
            std::fabs(double(dot(at(constant(image.sights.direction), i), at(Ng, i))));
        const double in = std::fabs(double(dot(at(constant(ends.toPrevious), i), at(Ng, i))));
        const double perArea =
            parallel ? 1 : 1 / (double(image.sights.distance[i]) * image.sights.distance[i]);
        const double reached = double(image.sights.pdf[i]) * out * perArea;
        const double path = ends.vertices[i].techniquesOfPath(reached, ends.reversePdf[i],
                                                              chunk.paths.depth[i] == 0);
        const double weight =
            ends.counts.besidePath
                ? (path > 0 ? 0.0 : 1.0)
                : misWeightAmong(1,
                                 othersOfLightImage({ends.vertices[i], reached, ends.reversePdf[i]},
                                                    ends.counts));
        image.pathGain[i] =
            float(1 / (weight * std::max(std::sqrt(path) / ends.counts.lightImage, leastOfPath)));
        const double scale = in > 0 ? weight * image.sights.importance[i] * out / (in * pi) : 0;
        bool some = false, sound = true;
        for (int c = 0; c < colorSamples; ++c) {
            float &value = image.seen[c][i];
            value = float(double(chunk.paths.throughput[c][i]) * image.response[c][i] * scale);
            some |= value != 0, sound &= bool(std::isfinite(value));
        }
        if (some && sound)
            image.lane[left++] = i;
    }
    return left;
}

void note(LightTally &tally, const LightImage &image, int slot, int i, int k,
          const SplatPlace &place) {
    const int cell = tally.cellAt(place.x, place.y);
    if (cell < 0 && !(tally.reach > 0))
        return;
    double Y = 0;
    for (int c = 0; c < colorSamples; ++c)
        Y += double(luminanceWeights[c]) * image.seen[c][i] * image.transmittance[c][k];
    Y *= place.weight;
    if (cell < 0) {
        const double beyond = tally.beyondFrame(place.x, place.y), nearness = 1 / (1 + beyond);
        tally.splats.push_back({slot, cell, std::fabs(Y) * nearness * nearness, beyond});
        return;
    }
    LightTally::Cell &to = tally.values[cell];
    to.sum += Y, to.squares += Y * Y;
    if (std::fabs(Y) / tally.samples * image.pathGain[i] > to.seldom)
        to.pathSquares += Y * Y * image.pathGain[i];
    if (tally.keepsSplats)
        tally.splats.push_back({slot, cell, std::fabs(Y), 0});
}

void splat(LightWave &wave, int count) {
    LightImage &image = wave.image;
    for (int k = 0; k < count; ++k) {
        const int i = image.lane[k];
        if (image.transmittance[0][k] == 0 && image.transmittance[1][k] == 0 &&
            image.transmittance[2][k] == 0)
            continue;
        const SplatPlace place = wave.pixels.choose(image.sights.x[i], image.sights.y[i],
                                                    wave.chunk.numbers.x(lightChoicePair)[i]);
        if (place.weight == 0)
            continue;
        if (wave.tally)
            note(*wave.tally, image, wave.chunk.paths.slot[i], i, k, place);
        image.x.push_back(place.x), image.y.push_back(place.y);
        for (int c = 0; c < colorSamples; ++c)
            image.splats[c].push_back(image.seen[c][i] * image.transmittance[c][k] * place.weight);
    }
}

} // namespace

std::array<int, 4> wholeFrame(const Scene &scene) {
    const auto [width, height] = scene.options().format.effectiveResolution();
    return {0, width, 0, height};
}

int LightTally::cellAt(float x, float y) const {
    const auto [x0, x1, y0, y1] = frame;
    const int column = int(std::floor((x - float(x0)) / float(x1 - x0) * cells));
    const int row = int(std::floor((y - float(y0)) / float(y1 - y0) * cells));
    const bool inside = column >= 0 && column < cells && row >= 0 && row < cells;
    return inside ? row * cells + column : -1;
}

double LightTally::beyondFrame(float x, float y) const {
    const auto [x0, x1, y0, y1] = frame;
    const auto beyond = [](double low, double high, double at) {
        return std::max({low - at, at - high, 0.0}) / (high - low);
    };
    return std::max(beyond(x0, x1, x), beyond(y0, y1, y));
}

LightImage::LightImage(int capacity)
    : floats(13, capacity), response(colorSamples, capacity), seen(colorSamples, capacity),
      integers(2, capacity), rays(capacity), media(capacity), ways(6, capacity),
      transmittance(colorSamples, capacity) {
    sights.origin = {floats[0], floats[1], floats[2]};
    sights.direction = {floats[3], floats[4], floats[5]};
    sights.distance = floats[6], sights.nearest = floats[7];
    sights.x = floats[8], sights.y = floats[9];
    sights.importance = floats[10], sights.pdf = floats[11];
    towardsLens = {ways[0], ways[1], ways[2]}, end = {ways[3], ways[4], ways[5]};
    pathGain = floats[12];
    answered = integers[0], lane = integers[1];
    std::fill_n(answered, integers.lanes(), finiteRequests);
}

void showToCamera(PathWave &path) {
    LightWave &wave = static_cast<LightWave &>(path);
    VertexChunk &chunk = wave.chunk;
    Subpaths &ends = *wave.subpaths;
    if (!(ends.counts.lightImage > 0) || !chunk.vertices.code().facts().hasLoops)
        return;
    LightImage &image = wave.image;
    wave.frame.scene.camera().see(chunk.count(), chunk.vertices.P(),
                                  chunk.numbers.x(lightPositionPair),
                                  chunk.numbers.y(lightPositionPair), image.sights);
    int count = findSeen(wave);
    if (count == 0)
        return;
    for (int i = 0; i < chunk.count(); ++i) {
        for (int c = 0; c < 3; ++c)
            image.towardsLens[c][i] = -image.sights.direction[c][i];
    }
    ends.other.look(chunk.vertices, constant(image.sights.direction),
                    wave.frame.settings.hemisphereOnly);
    ends.other.pdf(constant(ends.toPrevious), ends.reversePdf);
    float *response[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        response[c] = image.response[c];
    ends.other.scatter(constant(ends.toPrevious), image.answered, wave.arrival.light, response);
    count = weigh(wave, count);
    if (count == 0)
        return;
    traceFromLens(wave, count);
    splat(wave, count);
}

} // namespace candela

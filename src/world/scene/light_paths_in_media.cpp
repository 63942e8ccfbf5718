// SPDX-License-Identifier: Apache-2.0
// Volumes that paths from lights cross: what such paths must know that camera paths find out on
// their way, and where they cannot know it.
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace candela {

namespace {

/// Of rays that are looked along for the bodies that they begin in: so many faces at the most.
constexpr int mostFaces = 64;

/// Along a ray, straight through everything.
struct BodiesMet {
    std::vector<std::int32_t> entered;   ///< And not yet left.
    std::vector<std::int32_t> beganIn{}; ///< Left without having been entered, the innermost first.

    void meet(std::int32_t interior, bool fromInside) {
        if (!fromInside) {
            entered.push_back(interior);
            return;
        }
        const auto own = std::ranges::find(entered, interior);
        if (own != entered.end())
            entered.erase(own);
        else
            beganIn.push_back(interior);
    }
    MediaAround around() const {
        MediaAround result;
        for (auto body = beganIn.rbegin(); body != beganIn.rend(); ++body)
            result = result.beyond({.interior = *body}, false, true);
        return result;
    }
};

/// The factor of light along a segment depends on where it lies alone, not on what it ends at.
bool dependsOnPlaceAlone(const ShaderCode &code) {
    const std::vector<bool> &reads = code.question(ir::Question::Transmission).function.inputsRead;
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane) {
        const auto isOf = [&](ShaderInput first, int components) {
            return plane >= int(first) && plane < int(first) + components;
        };
        if (reads[std::size_t(plane)] && !isOf(ShaderInput::P, 3) && !isOf(ShaderInput::I, 3) &&
            !isOf(ShaderInput::E, 3) && !isOf(ShaderInput::time, 1) &&
            !isOf(ShaderInput::seed, 1) && !isOf(ShaderInput::pixelCi, maximumColorSamples) &&
            !isOf(ShaderInput::pixelOi, maximumColorSamples))
            return false;
    }
    return true;
}

/// The camera begins paths in some body. Looked for at a few points of the lens and frame.
bool cameraIsInABody(const Scene &scene) {
    constexpr int side = 4, count = side * side;
    const auto [width, height] = scene.options().format.effectiveResolution();
    std::array<float, count> x, y, middle;
    middle.fill(0.5f);
    for (int k = 0; k < count; ++k) {
        x[k] = (float(k % side) + 0.5f) / side * float(width);
        y[k] = (float(k / side) + 0.5f) / side * float(height);
    }
    RayBatch rays(count);
    scene.camera().rays(count, x.data(), y.data(), middle.data(), middle.data(), middle.data(),
                        rays);
    rays.count = count;
    std::fill_n(rays.tMin, count, 0.0f);
    std::array<MediaAround, count> around;
    scene.bodiesAround(rays, around.data());
    return std::ranges::any_of(around, [](const MediaAround &a) { return a != MediaAround(); });
}

} // namespace

bool Scene::hasInteriors() const {
    return std::ranges::any_of(state_->mediaOfAppearance,
                               [](const SurfaceMedia &media) { return media.interior != 0; });
}

void Scene::bodiesAround(const RayBatch &rays, MediaAround *around) const {
    std::vector<BodiesMet> met(std::size_t(rays.count));
    std::vector<int> lane(std::size_t(rays.count));
    std::iota(lane.begin(), lane.end(), 0);
    RayBatch way(rays.count);
    HitBatch hits(rays.count);
    ShadingPoints points(rays.count);
    const auto take = [&](int to, const RayBatch &from, int i) {
        for (int c = 0; c < 3; ++c) {
            way.origin[c][to] = from.origin[c][i];
            way.direction[c][to] = from.direction[c][i];
        }
        way.tMax[to] = INFINITY, way.time[to] = from.time[i];
    };
    for (int i = 0; i < rays.count; ++i)
        take(i, rays, i), way.tMin[i] = rays.tMin[i];
    way.count = rays.count;
    for (int face = 0; face < mostFaces && way.count > 0; ++face) {
        intersect(way, hits, Coherence::Secondary);
        std::vector<int> order;
        for (int i = 0; i < way.count; ++i)
            if (hits.shape[i] != noHit)
                order.push_back(i);
        describedPoints(way, hits, order.data(), int(order.size()), points);
        for (std::size_t k = 0; k < order.size(); ++k) {
            const int i = order[k], to = int(k);
            float side = 0;
            for (int c = 0; c < 3; ++c)
                side += points.input(ShaderInput::Ng, c)[k] * way.direction[c][i];
            const std::int32_t interior = mediaOf(hits.instance[i], hits.shape[i]).interior;
            lane[k] = lane[std::size_t(i)];
            if (interior != 0)
                met[std::size_t(lane[k])].meet(interior, side > 0);
            const float passed = passing(hits.t[i]);
            take(to, way, i);
            way.tMin[to] = passed;
        }
        way.count = int(order.size());
    }
    for (int i = 0; i < rays.count; ++i)
        around[i] = met[std::size_t(i)].around();
}

std::string Scene::whyVolumesStopLightPaths() const {
    for (int number = 1; number < mediaCount(); ++number) {
        const ShaderCode &code = *medium(number).code;
        const std::string name = "volume shader \"" + code.name() + "\": ";
        if (!code.volumeFacts().affine)
            return name + "it does not make light less in proportion";
        if (!dependsOnPlaceAlone(code))
            return name + "what it lets through depends on the surface behind it";
    }
    std::set<std::int32_t> atmospheres;
    for (const SurfaceMedia &media : state_->mediaOfAppearance) {
        if (media.exterior != 0)
            return "surfaces have an Exterior";
        atmospheres.insert(media.atmosphere);
    }
    const bool fromPoints = std::ranges::any_of(state_->emitters.lights, [](const Emitter &light) {
        return light.form == EmitterForm::Point;
    });
    if (fromPoints && atmospheres.size() > 1)
        return "surfaces have different Atmospheres, and lights are points";
    if (hasInteriors() && cameraIsInABody(*this))
        return "the camera stands in a body that has an Interior";
    return "";
}

} // namespace candela

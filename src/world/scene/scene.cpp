// SPDX-License-Identifier: Apache-2.0
#include "world/scene/scene.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/scene/scene_state.h"

#include <cmath>
#include <map>

namespace candela {

namespace {

/// I holds the directions of the rays and becomes what leads from the origins to the hits.
CANDELA_HOT void reachOut(int count, const float *__restrict t, float *__restrict I) {
    for (int i = 0; i < count; ++i)
        I[i] *= t[i];
}

/// P holds the origins of rays, and becomes where they are at t.
CANDELA_HOT void walk(int count, const float *__restrict t, const float *__restrict direction,
                      float *__restrict P) {
    for (int i = 0; i < count; ++i)
        P[i] += t[i] * direction[i];
}

CANDELA_HOT void lookUpBins(int count, const std::uint32_t *__restrict shape,
                            const int *__restrict binOfAppearance, int *__restrict bin) {
    for (int i = 0; i < count; ++i) {
        bool hit = shape[i] != noHit;
        int found = binOfAppearance[hit ? shape[i] : 0];
        bin[i] = hit ? found : -1;
    }
}

/// What the rays tell of where they have met elements: P, Ng, I and the rest.
void meetElements(const PointTables &tables, const RayBatch &rays, const HitBatch &hits,
                  const int *order, ShadingPoints &points) {
    const int count = points.count;
    thread_local AlignedScratch own;
    float *t = own.get(count);
    lanes::take(count, order, hits.t, t);
    lanes::take(count, order, hits.shape, points.shape);
    lanes::take(count, order, hits.element, points.element);
    lanes::take(count, order, hits.instance, points.instance);
    lanes::take(count, order, hits.u, points.u);
    lanes::take(count, order, hits.v, points.v);
    float *Ng[3];
    for (int c = 0; c < 3; ++c) {
        float *P = points.input(ShaderInput::P, c), *I = points.input(ShaderInput::I, c);
        lanes::take(count, order, rays.direction[c], I);
        lanes::take(count, order, rays.origin[c], P);
        walk(count, t, I, P);
        reachOut(count, t, I);
        lanes::take(count, order, hits.Ng[c], Ng[c] = points.input(ShaderInput::Ng, c));
    }
    if (!tables.instances.empty())
        placeElementNormals(tables, count, points.instance, Ng);
    // Shadow rays want the time even where the shader does not.
    lanes::take(count, order, rays.time, points.input(ShaderInput::time, 0));
}

/// How wide the rays' cones are where they have met something.
CANDELA_HOT void widths(int count, const float *__restrict width, const float *__restrict spread,
                        const float *__restrict t, float *__restrict footprint) {
    for (int i = 0; i < count; ++i)
        footprint[i] = width[i] + spread[i] * t[i];
}

} // namespace

Scene::Scene(std::unique_ptr<SceneState> state) : state_(std::move(state)) {}
Scene::~Scene() = default;

const Options &Scene::options() const { return state_->options; }
const Camera &Scene::camera() const { return state_->camera; }
bool Scene::isClassic() const { return state_->classic; }
Scene::Statistics Scene::statistics() const { return state_->statistics; }

void Scene::intersect(const RayBatch &rays, HitBatch &hits, Coherence coherence) const {
    state_->rays->intersect(rays, hits, RayWorld::Which::All, coherence == Coherence::Primary);
}

int Scene::codeCount() const { return int(state_->points.codes.size()); }
const ShaderCode &Scene::code(int index) const { return *state_->points.codes[index].code; }
int Scene::codeOf(const HitBatch &hits, int i) const {
    const PointTables &points = state_->points;
    return points.appearances[points.appearanceOf(hits.instance[i], hits.shape[i])].code;
}

int Scene::binCount() const { return int(state_->codeOfBin.size()); }
int Scene::codeOfBin(int bin) const { return state_->codeOfBin[bin]; }
int Scene::escapedBin() const { return state_->binOfAppearance.back(); }

void Scene::bins(int count, const HitBatch &hits, int *bin) const {
    const PointTables &points = state_->points;
    if (points.instances.empty())
        return lookUpBins(count, hits.shape, state_->binOfAppearance.data(), bin);
    for (int i = 0; i < count; ++i)
        bin[i] =
            hits.shape[i] == noHit
                ? -1
                : state_->binOfAppearance[points.appearanceOf(hits.instance[i], hits.shape[i])];
}

void SceneState::numberBins() {
    std::map<std::pair<int, bool>, int> known;
    for (const Appearance &appearance : points.appearances) {
        auto [place, isNew] =
            known.try_emplace({appearance.code, appearance.light != 0}, int(codeOfBin.size()));
        if (isNew)
            codeOfBin.push_back(appearance.code);
        binOfAppearance.push_back(place->second);
    }
    binOfAppearance.push_back(-1); // Rays that miss look at an entry, too.
}

void Scene::shadingPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                          ShadingPoints &points) const {
    points.count = count;
    if (count == 0)
        return;
    const SurfaceCode &code = state_->points.codes[codeOf(hits, order[0])];
    meetElements(state_->points, rays, hits, order, points);
    const float *footprint = nullptr;
    if (code.wanted.footprint) {
        thread_local AlignedScratch own;
        const int stride = paddedLanes(count);
        float *planes = own.get(4 * std::size_t(stride));
        lanes::take(count, order, rays.width, planes);
        lanes::take(count, order, rays.spread, planes + stride);
        lanes::take(count, order, hits.t, planes + 2 * stride);
        widths(count, planes, planes + stride, planes + 2 * stride, planes + 3 * stride);
        footprint = planes + 3 * stride;
    }
    evaluatePoints(state_->points, state_->camera, code, footprint, points);
    // What has come far is rounded by the way it came.
    addRounding(count,
                {points.input(ShaderInput::I, 0), points.input(ShaderInput::I, 1),
                 points.input(ShaderInput::I, 2)},
                4 * 0x1p-24f, points.offset);
    for (int c = 0; c < 3 && code.wanted.E; ++c)
        std::fill_n(points.input(ShaderInput::E, c), count, 0.0f);
}

void Scene::elementPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                          const std::array<float *, 3> &point) const {
    thread_local AlignedScratch own;
    const int stride = paddedLanes(count);
    float *t = own.get(2 * std::size_t(stride)), *direction = t + stride;
    lanes::take(count, order, hits.t, t);
    for (int c = 0; c < 3; ++c) {
        lanes::take(count, order, rays.direction[c], direction);
        lanes::take(count, order, rays.origin[c], point[c]);
        walk(count, t, direction, point[c]);
    }
}

void Scene::bind(int code, const ShadingPoints &points, ShaderArgs &args) const {
    bindPoints(state_->points, code, points, args);
}

Vec3 Scene::offsetOrigin(Vec3 P, Vec3 Ng, Vec3 direction, float offset) {
    float length = std::sqrt(dot(Ng, Ng));
    if (!(length > 0))
        return P;
    float side = dot(Ng, direction) < 0 ? -offset : offset;
    return P + Ng * (side / length);
}

std::span<const LightGroup> Scene::lightGroupsInUse() const { return state_->lights.groups; }

bool Scene::hasAmbient() const { return !state_->lights.ambient.empty(); }
bool Scene::readsLightChoice() const { return !state_->lights.isSingle; }
int Scene::lightCount() const { return int(state_->lights.lights.size()); }
bool Scene::lightIsOn(std::int32_t lightSet, std::int32_t light) const {
    return state_->lights.on(lightSet, light);
}

} // namespace candela

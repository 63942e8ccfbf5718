// SPDX-License-Identifier: Apache-2.0
#include "world/scene/scene.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "world/scene/scene_state.h"
#include "world/scene/surface_points.h"

#include <cmath>
#include <map>

namespace candela {

namespace {

struct HitScratch {
    Scratch<std::uint32_t> primitive, triangle;
    Scratch<float> u, v;
};

/// I holds the directions of the rays and becomes what leads from the origins to the hits.
CANDELA_HOT void reachOut(int count, const float *__restrict t, float *__restrict I) {
    for (int i = 0; i < count; ++i)
        I[i] *= t[i];
}

CANDELA_HOT void lookUpBins(int count, const std::uint32_t *__restrict primitive,
                            const int *__restrict binOfPrimitive, int *__restrict bin) {
    for (int i = 0; i < count; ++i) {
        bool hit = primitive[i] != noHit;
        int found = binOfPrimitive[hit ? primitive[i] : 0];
        bin[i] = hit ? found : -1;
    }
}

/// I = t times the ray's direction, and what else the rays tell.
void fillFromRays(const RayBatch &rays, const HitBatch &hits, const int *order,
                  const WantedInputs &wanted, ShadingPoints &points) {
    thread_local Scratch<float> own;
    float *t = own.get(points.count);
    lanes::take(points.count, order, hits.t, t);
    for (int c = 0; c < 3; ++c) {
        float *I = points.input(int(ShaderInput::I) + c);
        lanes::take(points.count, order, rays.direction[c], I);
        reachOut(points.count, t, I);
        if (wanted.E)
            std::fill_n(points.input(int(ShaderInput::E) + c), points.count, 0.0f);
    }
    // Shadow rays want the time even where the shader does not.
    lanes::take(points.count, order, rays.time, points.input(int(ShaderInput::time)));
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

int Scene::codeCount() const { return int(state_->codes.size()); }
const ShaderCode &Scene::code(int index) const { return *state_->codes[index].code; }
int Scene::codeOf(std::uint32_t primitive) const { return state_->summaries[primitive].code; }

bool Scene::normalsAreUnit(int code) const { return state_->codes[code].flat; }

int Scene::binCount() const { return int(state_->codeOfBin.size()); }
int Scene::codeOfBin(int bin) const { return state_->codeOfBin[bin]; }
int Scene::escapedBin() const { return state_->binOfPrimitive.back(); }

void Scene::bins(int count, const std::uint32_t *primitive, int *bin) const {
    lookUpBins(count, primitive, state_->binOfPrimitive.data(), bin);
}

void SceneState::numberBins() {
    std::map<std::pair<int, bool>, int> known;
    for (const PrimitiveSummary &summary : summaries) {
        auto [place, isNew] =
            known.try_emplace({summary.code, summary.light != 0}, int(codeOfBin.size()));
        if (isNew)
            codeOfBin.push_back(summary.code);
        binOfPrimitive.push_back(place->second);
    }
    binOfPrimitive.push_back(-1); // Rays that miss look at an entry, too.
}

void Scene::shadingPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                          ShadingPoints &points) const {
    points.count = count;
    if (count == 0)
        return;
    thread_local HitScratch own;
    std::uint32_t *primitive = own.primitive.get(count), *triangle = own.triangle.get(count);
    float *u = own.u.get(count), *v = own.v.get(count);
    lanes::take(count, order, hits.shape, primitive);
    lanes::take(count, order, hits.element, triangle);
    lanes::take(count, order, hits.u, u);
    lanes::take(count, order, hits.v, v);
    const SceneCode &code = state_->codes[codeOf(primitive[0])];
    state_->evaluate({count, primitive, triangle, u, v}, code, points);
    fillFromRays(rays, hits, order, code.wanted, points);
}

void Scene::bind(int code, const ShadingPoints &points, ShaderArgs &args) const {
    state_->bind(code, points, args);
}

void SceneState::bind(int code, const ShadingPoints &points, ShaderArgs &args) const {
    args.count = points.count;
    args.inputs = points.inputTable.data();
    args.parameterOffset = points.parameterOffset;
    args.objectIndex = points.objectIndex;
    args.objectMatrices = objectMatrices.data();
    args.variables = points.variableTable.data();
    codes[code].code->bind(args);
}

Vec3 Scene::offsetOrigin(Vec3 P, Vec3 Ng, Vec3 direction, float offset) {
    float length = std::sqrt(dot(Ng, Ng));
    if (!(length > 0))
        return P;
    float side = dot(Ng, direction) < 0 ? -offset : offset;
    return P + Ng * (side / length);
}

bool Scene::hasLights() const { return state_->lights.any(); }
bool Scene::hasAmbient() const { return !state_->lights.ambient.empty(); }
bool Scene::readsLightChoice() const { return !state_->lights.isOneFlatLight(); }
int Scene::lightCount() const { return int(state_->lights.lights.size()); }
bool Scene::lightIsOn(std::int32_t lightSet, std::int32_t light) const {
    return state_->lights.on(lightSet, light);
}

} // namespace candela

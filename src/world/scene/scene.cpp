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

/// P and I hold origins and directions of rays, and become where they are at t, and what leads
/// there from the origins.
CANDELA_HOT void walk(int count, const float *__restrict t, const Vec3Planes &P,
                      const Vec3Planes &I) {
    float *px = P.x, *py = P.y, *pz = P.z, *ix = I.x, *iy = I.y, *iz = I.z;
#pragma GCC ivdep // Planes are apart; there are too many to compare.
    for (int i = 0; i < count; ++i) {
        const float x = t[i] * ix[i], y = t[i] * iy[i], z = t[i] * iz[i];
        ix[i] = x, iy[i] = y, iz[i] = z;
        px[i] += x, py[i] += y, pz[i] += z;
    }
}

/// `missed` is the entry of rays that have met nothing; noHit is beyond it.
CANDELA_HOT void lookUpBins(int count, const std::uint32_t *__restrict shape,
                            const int *__restrict binOfAppearance, std::uint32_t missed,
                            int *__restrict bin) {
    for (int i = 0; i < count; ++i)
        bin[i] = int(shape[i] < missed ? shape[i] : missed);
    for (int i = 0; i < count; ++i) // Apart, as in one loop it would become a jump.
        bin[i] = binOfAppearance[bin[i]];
}

/// What the rays tell of where they have met elements: P, Ng, I and the rest.
void meetElements(const PointTables &tables, const RayBatch &rays, const HitBatch &hits,
                  const int *order, ShadingPoints &points) {
    const int count = points.count;
    points.named = false;
    thread_local AlignedScratch own;
    float *t = own.get(count);
    auto input = [&](ShaderInput which, int c = 0) { return points.input(which, c); };
    float *P[3], *I[3], *Ng[3];
    for (int c = 0; c < 3; ++c)
        P[c] = input(ShaderInput::P, c), I[c] = input(ShaderInput::I, c),
        Ng[c] = input(ShaderInput::Ng, c);
    // Shadow rays want the time even where the shader does not.
    lanes::take(count, order,
                {{hits.t, t},
                 {hits.shape, points.shape},
                 {hits.element, points.element},
                 {hits.instance, points.instance},
                 {hits.u, points.u},
                 {hits.v, points.v},
                 {hits.Ng[0], Ng[0]},
                 {hits.Ng[1], Ng[1]},
                 {hits.Ng[2], Ng[2]},
                 {rays.origin[0], P[0]},
                 {rays.origin[1], P[1]},
                 {rays.origin[2], P[2]},
                 {rays.direction[0], I[0]},
                 {rays.direction[1], I[1]},
                 {rays.direction[2], I[2]},
                 {rays.time, input(ShaderInput::time)}});
    walk(count, t, {P[0], P[1], P[2]}, {I[0], I[1], I[2]});
    if (!tables.instances.empty())
        placeElementNormals(tables, count, points.instance, input(ShaderInput::time), Ng);
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
bool Scene::isBidirectional() const { return state_->bidirectional; }
bool Scene::isSolved() const { return state_->solved; }
Lights Scene::lights() const { return Lights(*state_); }
const Box3 &Scene::bound() const { return state_->bound; }
SurfaceDomains Scene::domains() const { return SurfaceDomains(*state_); }
Scene::Statistics Scene::statistics() const {
    Statistics statistics = state_->statistics;
    statistics.secondsTracing = state_->rays->secondsTracing();
    return statistics;
}

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
bool Scene::isOneSided(std::uint32_t instance, std::uint32_t shape) const {
    const PointTables &points = state_->points;
    return points.details[points.appearanceOf(instance, shape)].attributes->sides == 1;
}
bool Scene::hidesShapes() const { return state_->rays->hidesShapes(); }
bool Scene::hasMatte() const { return state_->hasMatte; }
bool Scene::isMatte(std::uint32_t instance, std::uint32_t shape) const {
    const PointTables &points = state_->points;
    return points.details[points.appearanceOf(instance, shape)].attributes->matte;
}
int Scene::escapedBin() const { return state_->binOfAppearance.back(); }

void Scene::bins(int count, const HitBatch &hits, int *bin) const {
    const PointTables &points = state_->points;
    const std::vector<int> &binOfAppearance = state_->binOfAppearance;
    if (points.instances.empty())
        return lookUpBins(count, hits.shape, binOfAppearance.data(),
                          std::uint32_t(binOfAppearance.size() - 1), bin);
    for (int i = 0; i < count; ++i)
        bin[i] = hits.shape[i] == noHit
                     ? escapedBin()
                     : binOfAppearance[points.appearanceOf(hits.instance[i], hits.shape[i])];
}

void SceneState::numberBins() {
    for (const SurfaceCode &code : points.codes)
        readsFootprints |= code.wanted.footprint;
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

bool Scene::hasVolumes() const { return mediaCount() > 1; }
int Scene::mediaCount() const { return int(state_->media.size()); }

const SurfaceMedia &Scene::mediaOf(std::uint32_t instance, std::uint32_t shape) const {
    return state_->mediaOfAppearance[std::size_t(state_->points.appearanceOf(instance, shape))];
}

const ShaderInstance &Scene::medium(std::int32_t number) const {
    return state_->media[std::size_t(number)];
}

std::int32_t Scene::mediumOfLight(std::int32_t light) const {
    return light > 0 ? state_->mediaOfLight[std::size_t(light) - 1] : 0;
}

void SceneState::findMediaOfLights() {
    mediaOfLight.assign(lights.lights.size(), 0);
    for (std::size_t k = 0; k < points.appearances.size(); ++k)
        if (const std::int32_t light = points.appearances[k].light)
            mediaOfLight[std::size_t(light) - 1] = mediaOfAppearance[k].atmosphere;
}

/// E of points whose time is known.
static void placeEye(const Camera &camera, ShadingPoints &points) {
    for (int c = 0; c < 3; ++c)
        std::fill_n(points.input(ShaderInput::E, c), points.count, 0.0f);
    for (int i = 0; camera.moves() && i < points.count; ++i) {
        const Vec3 eye = camera.eye(points.input(ShaderInput::time, 0)[i]);
        for (int c = 0; c < 3; ++c)
            points.input(ShaderInput::E, c)[i] = eye[c];
    }
}

/// Valid until the thread's next call.
static RayFootprints footprintsOf(const RayBatch &rays, const HitBatch &hits, const int *order,
                                  int count) {
    thread_local AlignedScratch own;
    const int stride = paddedLanes(count);
    float *planes = own.get(8 * std::size_t(stride));
    const auto plane = [&](int k) { return planes + k * stride; };
    lanes::take(count, order,
                {{rays.width, plane(0)}, {rays.spread, plane(1)}, {hits.t, plane(2)}});
    widths(count, plane(0), plane(1), plane(2), plane(3));
    RayFootprints footprints{plane(3), std::nullopt};
    if (const PixelShares *shares = rays.shares) {
        lanes::take(count, order,
                    {{shares->x, plane(4)},
                     {shares->y, plane(5)},
                     {shares->wide, plane(6)},
                     {shares->high, plane(7)}});
        footprints.shares = {plane(4), plane(5), plane(6), plane(7)};
    }
    return footprints;
}

void Scene::shadingPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                          ShadingPoints &points) const {
    points.count = count;
    if (count == 0)
        return;
    const SurfaceCode &code = state_->points.codes[codeOf(hits, order[0])];
    meetElements(state_->points, rays, hits, order, points);
    std::optional<RayFootprints> footprints;
    if (code.wanted.footprint)
        footprints = footprintsOf(rays, hits, order, count);
    evaluatePoints(state_->points, state_->camera, code, footprints ? &*footprints : nullptr,
                   points);
    // What has come far is rounded by the way it came.
    addRounding(count,
                {points.input(ShaderInput::I, 0), points.input(ShaderInput::I, 1),
                 points.input(ShaderInput::I, 2)},
                4 * 0x1p-24f, points.offset);
    if (code.wanted.E)
        placeEye(state_->camera, points);
    if (code.code->reads(ShaderInput::rayOffset))
        std::copy_n(points.offset, count, points.input(ShaderInput::rayOffset, 0));
    if (code.code->reads(ShaderInput::rayDepth)) // Paths say more.
        std::fill_n(points.input(ShaderInput::rayDepth, 0), count, 0.0f);
}

bool Scene::tells(int code, int input) const {
    const WantedInputs &wanted = state_->points.codes[code].wanted;
    const auto isIn = [input](ShaderInput first, ShaderInput last) {
        return input >= int(first) && input <= int(last);
    };
    return isIn(ShaderInput::u, ShaderInput::v)          ? wanted.uv
           : isIn(ShaderInput::s, ShaderInput::t)        ? wanted.st
           : isIn(ShaderInput::Cs, ShaderInput::CsLast_) ? wanted.Cs
           : isIn(ShaderInput::Os, ShaderInput::OsLast_) ? wanted.Os
                                                         : true;
}

void Scene::describedPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                            ShadingPoints &points) const {
    static const SurfaceCode all = [] {
        SurfaceCode code;
        code.wanted.uv = code.wanted.st = code.wanted.Cs = code.wanted.Os = true;
        return code;
    }();
    points.count = count;
    if (count == 0)
        return;
    meetElements(state_->points, rays, hits, order, points);
    evaluatePoints(state_->points, state_->camera, all, nullptr, points);
}

void Scene::elementPoints(const RayBatch &rays, const HitBatch &hits, const int *order, int count,
                          const std::array<float *, 3> &point) const {
    thread_local AlignedScratch own;
    const int stride = paddedLanes(count);
    float *t = own.get(4 * std::size_t(stride));
    float *x = t + stride, *y = x + stride, *z = y + stride;
    lanes::take(count, order,
                {{hits.t, t},
                 {rays.direction[0], x},
                 {rays.direction[1], y},
                 {rays.direction[2], z},
                 {rays.origin[0], point[0]},
                 {rays.origin[1], point[1]},
                 {rays.origin[2], point[2]}});
    walk(count, t, {point[0], point[1], point[2]}, {x, y, z});
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

bool Scene::readsFootprints() const { return state_->readsFootprints; }
bool Scene::bendsRays(int code) const {
    const WantedInputs &wanted = state_->points.codes[code].wanted;
    return wanted.dNd && wanted.footprint;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/heard_lights.h"
#include "world/scene/light_builder.h"
#include "world/scene/moving_parts.h"
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"
#include "world/scene/shader_rays.h"
#include "world/scene/shape_builder.h"

#include <algorithm>
#include <chrono>

namespace candela {

namespace {

double secondsSince(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

} // namespace

struct SceneCompiler::State {
    State(ShaderLibrary &library, DiagnosticSink &sink, Render render)
        : library(library), sink(sink), render(std::move(render)) {}

    ShaderLibrary &library;
    DiagnosticSink &sink;
    Render render;
    DeclaredWorld declared;
};

SceneCompiler::SceneCompiler(ShaderLibrary &library, DiagnosticSink &sink, Render render)
    : state_(std::make_unique<State>(library, sink, std::move(render))) {}
SceneCompiler::~SceneCompiler() = default;

void SceneCompiler::worldBegin(const Options &options) {
    state_->declared = {};
    state_->declared.options = options;
    state_->declared.shutter = {options.camera.shutterOpen, options.camera.shutterClose};
    state_->declared.systems = options.coordinateSystems;
}

void SceneCompiler::imager(std::shared_ptr<const ShaderRecord> shader) {
    state_->declared.options.imager = shader ? std::optional(*shader) : std::nullopt;
}

/// Where it is when the shutter opens, and its motion if it may move before it closes.
static MotionTransform whileOpen(const MotionTransform &transform, const Shutter &shutter) {
    if (!transform.motion)
        return transform;
    return {transform.motion->at(shutter.open).rounded(),
            shutter.hasInterval() ? transform.motion : nullptr};
}

void SceneCompiler::light(std::shared_ptr<const LightRecord> record) {
    state_->declared.lights.push_back(std::move(record));
}

void SceneCompiler::primitive(std::shared_ptr<const PrimitiveRecord> record,
                              std::shared_ptr<const Attributes> attributes,
                              const MotionTransform &currentFromObject) {
    const auto [matrix, motion] = whileOpen(currentFromObject, state_->declared.shutter);
    const SolidPlace solid = state_->declared.solids.place();
    state_->declared.openFor(attributes, solid)
        .primitives.push_back({std::move(record), attributes, matrix, motion, solid});
}

void SceneCompiler::solidBegin(SolidOperation operation) {
    state_->declared.solids.begin(operation);
}

void SceneCompiler::solidEnd() { state_->declared.solids.end(); }

void SceneCompiler::objectBegin(int object) { state_->declared.beginObject(object); }

void SceneCompiler::objectEnd() { state_->declared.endObject(); }

void SceneCompiler::instance(int object, std::shared_ptr<const Attributes> attributes,
                             const MotionTransform &currentFromObject) {
    DeclaredWorld &declared = state_->declared;
    const SolidPlace solid = declared.solids.place();
    const bool turns = attributes->flipNormal != solid.turned;
    const auto [matrix, motion] = whileOpen(currentFromObject, declared.shutter);
    declared.open().instances.push_back(
        {declared.objectOfNumber.at(object), std::move(attributes), turns, matrix, motion, solid});
}

void SceneCompiler::coordinateSystem(const std::string &name, const Matrix4 &currentFromSpace) {
    state_->declared.systems[name] = currentFromSpace;
}

/// DESIGN section 6: by option, else `path` if anything is in SI units.
static bool isClassic(const DeclaredWorld &declared) {
    std::string integrator = declared.options.named.string("render:integrator", "");
    if (!integrator.empty())
        return integrator == "classic";
    if (declared.options.named.string("radiometry:units", "classic") == "si")
        return false;
    return std::ranges::none_of(declared.lights,
                                [](const auto &light) { return light->units == LightUnits::Si; });
}

/// Integrators whose paths begin on lights, too.
static bool isBidirectional(const Options &options) {
    const std::string integrator = options.named.string("render:integrator", "");
    return integrator == "bidir" || integrator == "vcm";
}

static bool isSolved(const Options &options) {
    return options.named.string("render:integrator", "") == "radiosity";
}

static std::vector<ClippingPlane> clippingPlanesOf(const Options &options) {
    std::vector<ClippingPlane> planes;
    for (const auto &[point, normal] : options.camera.clippingPlanes)
        planes.push_back({point, normal});
    return planes;
}

/// Finds where paths begin on lights. Lights that begin none are said, once a reason.
static void prepareEmitters(SceneState &state, DiagnosticSink &sink) {
    std::vector<std::string> silent;
    state.emitters = findEmitters(state, silent);
    std::ranges::sort(silent);
    const auto rest = std::ranges::unique(silent);
    silent.erase(rest.begin(), rest.end());
    for (const std::string &reason : silent)
        sink.warning({}, reason + ": no path begins at such lights; their light is found from the "
                                  "camera alone, as by \"path\"");
}

/// The coordinate systems that the camera brings.
static void addCameraSystems(const Camera &camera, const CameraRecord &record,
                             std::map<std::string, Matrix4> &systems) {
    for (auto [name, matrix] : {std::pair{"screen", &camera.screenFromCamera()},
                                std::pair{"NDC", &camera.ndcFromCamera()},
                                std::pair{"raster", &camera.rasterFromCamera()}})
        if (auto currentFromSpace = inverse(*matrix))
            systems[name] = *currentFromSpace;
    // What depth() reads: camera space with z from 0 at the near plane to 1 at the far one.
    systems["depth"] = scaling(1, 1, record.far - record.near) * translation(0, 0, record.near);
}

/// Compiles all shaders. Some may have become others then, which read other inputs.
static void makeReady(ShaderLibrary &library, PointTables &points) {
    library.makeReady();
    for (SurfaceCode &code : points.codes)
        if (code.code->isStandIn()) {
            code.wanted.add(code.code->shader().whole.inputsRead);
            code.fromElements = false;
        }
}

/// Where a shader wants to know how wide rays are, those that may send them on along one direction
/// tell how they bend them.
static void prepareMirrors(PointTables &points) {
    const auto asksOneDirection = [](const ir::LightRequest &request) {
        return request.kind == ir::LightRequest::Kind::Trace ||
               request.form == ir::ConeForm::Extended;
    };
    if (std::ranges::none_of(points.codes,
                             [](const SurfaceCode &code) { return code.wanted.footprint; }))
        return;
    for (SurfaceCode &code : points.codes)
        if (std::ranges::any_of(code.code->shader().whole.requests, asksOneDirection)) {
            code.wanted.dNd = code.wanted.dPd = code.wanted.footprint = true;
            code.fromElements = false;
        }
}

/// Paths from lights and from the camera meet at one time only: where things move, those from the
/// camera do alone. Radiosity is solved for one instant.
static void keepToOneTime(SceneState &state, const ShaderLibrary &library, DiagnosticSink &sink) {
    const bool shadersChange =
        std::ranges::any_of(library.all(), [](const auto &code) { return code->hasMotion(); });
    if (!state.points.anythingMoves() && !state.points.colorsChange && !state.camera.moves() &&
        !shadersChange)
        return;
    if (state.bidirectional)
        sink.warning({}, "things move while the shutter is open: all paths begin at the camera, as "
                         "under \"path\"");
    state.bidirectional = false;
    if (state.solved)
        sink.warning({},
                     "things move while the shutter is open: radiosity is solved for the instant "
                     "when it opens");
}

/// What the eye alone is not to see, or alone is to see, paths from lights cannot tell.
static void keepToTheEye(SceneState &state, DiagnosticSink &sink) {
    const auto &details = state.points.details;
    state.hasMatte = std::ranges::any_of(
        details, [](const AppearanceDetail &detail) { return detail.attributes->matte; });
    const bool hides = std::ranges::any_of(
        details, [](const AppearanceDetail &detail) { return !detail.visibility.isWhole(); });
    if (!state.bidirectional || !(state.hasMatte || hides))
        return;
    sink.warning({},
                 "things are matte, or hidden from some rays: all paths begin at the camera, as "
                 "under \"path\"");
    state.bidirectional = false;
}

/// What rays alone know of: paths must begin at the camera for what each path chooses for itself,
/// and nothing is solved for on surfaces that are not all there.
static void keepToRays(SceneState &state, const RayGeometry &geometry, DiagnosticSink &sink) {
    const auto &details = state.points.details;
    state.dissolves = std::ranges::any_of(
        details, [](const AppearanceDetail &detail) { return !detail.presence.isWhole(); });
    if (state.dissolves)
        state.camera.giveTimes();
    if (state.dissolves && state.bidirectional) {
        sink.warning({}, "levels of detail are dissolved into each other: all paths begin at the "
                         "camera, as under \"path\"");
        state.bidirectional = false;
    }
    const char *reason = !geometry.solids.all.empty() ? "solids"
                         : state.dissolves            ? "levels of detail in transition"
                         : !state.options.camera.clippingPlanes.empty() ? "clipping planes"
                                                                        : nullptr;
    if (!state.solved || !reason)
        return;
    sink.warning({}, std::string("there are ") + reason +
                         ", which leave surfaces without finite elements: this world is rendered "
                         "as under \"path\"");
    state.solved = false;
}

static void tellOpenBodies(const PlacedBodies &solids, const RayWorld &rays, DiagnosticSink &sink) {
    for (std::size_t solid = 0; solid < solids.all.size(); ++solid)
        for (std::int32_t node : rays.openNodes(solid))
            sink.warning(solids.where[solid][std::size_t(node)],
                         "what is drawn here as a part of a solid is not closed, so it has no "
                         "inside: it cuts nothing. SolidBegin \"primitive\" takes all that bounds "
                         "one body");
}

void SceneCompiler::worldEnd() {
    DeclaredWorld declared = std::move(state_->declared);
    state_->declared = {};
    separateMovingParts(declared);
    auto state = std::make_unique<SceneState>(declared.options);
    state->points.shutter = declared.shutter;
    state->classic = isClassic(declared);
    state->bidirectional = !state->classic && isBidirectional(declared.options);
    state->solved = !state->classic && isSolved(declared.options);

    addCameraSystems(state->camera, declared.options.camera, declared.systems);
    state_->library.bindOptions(declared.options);
    auto start = std::chrono::steady_clock::now();
    RayGeometry geometry = buildShapes(declared, *state, state_->library, state_->sink);
    // Lights without geometry have some "object" space too.
    if (std::vector<float> &matrices = state->points.shapeMatrices; matrices.empty())
        for (const Matrix4 &identity : {Matrix4{}, Matrix4{}})
            matrices.insert(matrices.end(), identity.m.begin(), identity.m.end());
    state->statistics.secondsDicing = secondsSince(start);

    start = std::chrono::steady_clock::now();
    LightBuilder lights(*state, state_->library);
    lights.declare(declared.lights);
    keepToOneTime(*state, state_->library, state_->sink);
    keepToTheEye(*state, state_->sink);
    keepToRays(*state, geometry, state_->sink);
    makeReady(state_->library, state->points);
    prepareMirrors(state->points);
    lights.attachShapes(geometry);
    lights.bindCategories(state_->library);
    state->findMediaOfLights();
    leaveOutRefusedLights(*state);
    state->rays = std::make_unique<RayWorld>(std::move(geometry.world), std::move(geometry.objects),
                                             geometry.instances, state->camera.shutter(),
                                             geometry.solids.all);
    state->rays->clipBy(clippingPlanesOf(declared.options));
    if (std::string failure = state->rays->failure(); !failure.empty()) {
        state_->sink.error({}, failure + "; the frame is not rendered");
        return;
    }
    tellOpenBodies(geometry.solids, *state->rays, state_->sink);
    geometry = {};
    for (const auto &code : state_->library.all())
        code->bindSpaces(declared.systems, state_->sink);
    lights.prepareChoices();
    if (state->bidirectional)
        prepareEmitters(*state, state_->sink);
    state->numberBins();
    state->statistics.secondsBuilding = secondsSince(start);

    Scene scene(std::move(state));
    const ShaderRays rays(scene);
    state_->library.bindRays(&rays);
    state_->render(scene);
    state_->library.bindRays(nullptr);
}

} // namespace candela

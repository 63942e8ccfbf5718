// SPDX-License-Identifier: Apache-2.0
#include "world/scene/flat_light.h"
#include "world/scene/light_builder.h"
#include "world/scene/primitive_builder.h"
#include "world/scene/scene.h"
#include "world/scene/scene_state.h"

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
    Options options;
    std::vector<std::shared_ptr<const LightRecord>> lights;
    std::vector<DeclaredPrimitive> primitives;
    std::vector<std::vector<DeclaredPrimitive>> objects;
    int openObject = -1;
    std::map<std::string, Matrix4> systems;

    bool isClassic() const;
};

SceneCompiler::SceneCompiler(ShaderLibrary &library, DiagnosticSink &sink, Render render)
    : state_(std::make_unique<State>(library, sink, std::move(render))) {}
SceneCompiler::~SceneCompiler() = default;

void SceneCompiler::worldBegin(const Options &options) {
    state_->options = options;
    state_->lights.clear();
    state_->primitives.clear();
    state_->objects.clear();
    state_->openObject = -1;
    state_->systems = options.coordinateSystems;
}

void SceneCompiler::light(std::shared_ptr<const LightRecord> record) {
    state_->lights.push_back(std::move(record));
}

void SceneCompiler::primitive(std::shared_ptr<const PrimitiveRecord> record,
                              std::shared_ptr<const Attributes> attributes,
                              const MotionTransform &currentFromObject) {
    auto &list = state_->openObject >= 0 ? state_->objects[state_->openObject] : state_->primitives;
    list.push_back({std::move(record), std::move(attributes), currentFromObject.atOpen()});
}

void SceneCompiler::objectBegin(int object) {
    state_->openObject = object;
    state_->objects.resize(std::max<std::size_t>(state_->objects.size(), object + 1));
}

void SceneCompiler::objectEnd() { state_->openObject = -1; }

void SceneCompiler::instance(int object, std::shared_ptr<const Attributes> attributes,
                             const MotionTransform &currentFromObject) {
    auto &list = state_->openObject >= 0 ? state_->objects[state_->openObject] : state_->primitives;
    for (DeclaredPrimitive part : std::vector(state_->objects[object])) {
        auto merged = std::make_shared<Attributes>(*attributes);
        merged->uBasis = part.attributes->uBasis, merged->vBasis = part.attributes->vBasis;
        merged->textureCoordinates = part.attributes->textureCoordinates;
        merged->flipNormal = attributes->flipNormal != part.attributes->flipNormal;
        list.push_back({part.record, merged, part.currentFromObject * currentFromObject.atOpen()});
    }
}

void SceneCompiler::coordinateSystem(const std::string &name, const Matrix4 &currentFromSpace) {
    state_->systems[name] = currentFromSpace;
}

/// DESIGN section 6: by option, else `path` if anything is in SI units.
bool SceneCompiler::State::isClassic() const {
    std::string integrator = options.string("render:integrator", "");
    if (!integrator.empty())
        return integrator == "classic";
    if (options.string("radiometry:units", "classic") == "si")
        return false;
    for (const auto &light : lights)
        if (light->units == LightUnits::Si)
            return false;
    return true;
}

void SceneCompiler::worldEnd() {
    auto state = std::make_unique<SceneState>(state_->options);
    state->classic = state_->isClassic();

    auto start = std::chrono::steady_clock::now();
    PrimitiveBuilder primitives(*state, state_->library, state_->sink);
    for (const DeclaredPrimitive &declared : state_->primitives)
        primitives.add(declared);
    std::vector<RayMesh> meshes = primitives.dice();
    // Lights without geometry have some "object" space too.
    const Matrix4 identity;
    if (state->objectMatrices.empty())
        for (int copy = 0; copy < 2; ++copy)
            state->objectMatrices.insert(state->objectMatrices.end(), identity.m.begin(),
                                         identity.m.end());
    state->statistics.secondsDicing = secondsSince(start);

    start = std::chrono::steady_clock::now();
    for (const RayMesh &mesh : meshes)
        state->triangleCounts.push_back(std::uint32_t(mesh.triangles.size()));
    state->rays = std::make_unique<RayWorld>(meshes);
    LightBuilder lights(*state, state_->library);
    lights.declare(state_->lights);
    lights.attachAreas(meshes);
    lights.bindCategories(state_->library);

    for (auto [name, matrix] : {std::pair{"screen", &state->camera.screenFromCamera()},
                                std::pair{"NDC", &state->camera.ndcFromCamera()},
                                std::pair{"raster", &state->camera.rasterFromCamera()}})
        if (auto currentFromSpace = inverse(*matrix))
            state_->systems[name] = *currentFromSpace;
    // What depth() reads: camera space with z from 0 at the near plane to 1 at the far one.
    const CameraRecord &camera = state->options.camera;
    state_->systems["depth"] =
        scaling(1, 1, camera.far - camera.near) * translation(0, 0, camera.near);
    for (const auto &code : state_->library.all())
        code->bindSpaces(state_->systems, state_->sink);
    lights.estimatePowers();
    for (SceneLight &light : state->lights.lights)
        light.flat = flatLight(*state, light);
    state->flatTable.build(*state);
    state->numberBins();
    state->statistics.secondsBuilding = secondsSince(start);

    Scene scene(std::move(state));
    state_->primitives.clear();
    state_->render(scene);
}

} // namespace candela

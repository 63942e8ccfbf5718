// SPDX-License-Identifier: Apache-2.0
#include "world/scene/primitive_builder.h"

#include "foundation/base/parallel.h"
#include "world/scene/dice_rate.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

const ShaderRecord &defaultSurface() {
    static const ShaderRecord record;
    return record;
}

bool isNumeric(const Declaration &declaration) { return declaration.type != ValueType::String; }

/// Variables that are shader inputs, and so override no parameter.
bool isInput(const std::string &name) {
    return name == "Cs" || name == "Os" || name == "s" || name == "t";
}

bool isOpaque(const ShaderCode &code, const ScenePrimitive &primitive) {
    const Color &opacity = primitive.attributes->opacity;
    bool full = primitive.Os < 0 &&
                std::all_of(opacity.c.begin(), opacity.c.end(), [](float o) { return o >= 1; });
    return full && code.facts().opaqueIfOsIs1;
}

/// The sign of the oriented normals against (p1 - p0) x (p2 - p0), by vote of some triangles.
int windingSign(const ScenePrimitive &primitive, const RayMesh &mesh) {
    int vote = 0;
    std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 15);
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
        auto [a, b, c] = mesh.triangles[k];
        std::uint32_t piece = std::uint32_t(k);
        float u = 1 / 3.0f, v = 1 / 3.0f, x = 0, y = 0, z = 0;
        if (!primitive.vertexUv.empty()) {
            piece = 0;
            const auto *uv = primitive.vertexUv.data();
            u = (uv[a][0] + uv[b][0] + uv[c][0]) / 3, v = (uv[a][1] + uv[b][1] + uv[c][1]) / 3;
        }
        SurfaceAnswer answer;
        answer.Ng = {&x, &y, &z};
        primitive.surface->evaluate({1, &piece, &u, &v}, answer);
        Vec3 normal = transformNormal(primitive.objectFromCurrent, {x, y, z});
        Vec3 p0 = mesh.positions[a];
        float along = dot(cross(mesh.positions[b] - p0, mesh.positions[c] - p0), normal) *
                      primitive.normalSign;
        vote += along > 0 ? 1 : along < 0 ? -1 : 0;
    }
    return vote < 0 ? -1 : 1;
}

} // namespace

PrimitiveBuilder::PrimitiveBuilder(SceneState &state, ShaderLibrary &library, DiagnosticSink &sink)
    : state_(state), library_(library), sink_(sink) {}

int PrimitiveBuilder::numberOf(std::shared_ptr<ShaderCode> code) {
    auto [place, isNew] = codeNumbers_.try_emplace(code.get(), int(state_.codes.size()));
    if (!isNew)
        return place->second;
    SceneCode entry;
    entry.code = code;
    for (const ir::ParameterSlot &slot : code->variables()) {
        auto known = std::find(entry.variableNames.begin(), entry.variableNames.end(), slot.name);
        entry.variableName.push_back(int(known - entry.variableNames.begin()));
        entry.variableComponent.push_back(slot.component);
        if (known == entry.variableNames.end())
            entry.variableNames.push_back(slot.name);
    }
    entry.wanted.add(*code);
    state_.codes.push_back(std::move(entry));
    return place->second;
}

PrimitiveBuilder::Shading PrimitiveBuilder::shadingOf(const Attributes &attributes,
                                                      const std::set<std::string> &variables) {
    const ShaderRecord &record = attributes.surface ? *attributes.surface : defaultSurface();
    auto known = shadings_.find({&record, variables});
    if (known != shadings_.end())
        return known->second;
    auto rule = state_.classic ? ir::LightRule::Classic : ir::LightRule::Path;
    auto instance = library_.instance(ShaderKind::Surface, record, state_.options, rule, variables);
    Shading shading{-1, 0};
    if (instance)
        shading = {numberOf(instance->code), instance->parameterOffset};
    shadings_[{&record, variables}] = shading;
    return shading;
}

int PrimitiveBuilder::lightSetOf(const Attributes &attributes) {
    auto [place, isNew] = lightSets_.try_emplace(attributes.lightsOn, int(state_.lightSets.size()));
    if (isNew)
        state_.lightSets.push_back(attributes.lightsOn);
    return place->second;
}

void PrimitiveBuilder::add(const DeclaredPrimitive &declared) {
    auto objectFromCurrent = inverse(declared.currentFromObject);
    if (!objectFromCurrent) {
        sink_.warning(declared.record->where,
                      "the transformation of this primitive is singular; it is left out");
        return;
    }
    for (auto &surface : makeSurfaces(declared.record, *declared.attributes, sink_))
        addSurface(surface, declared, *objectFromCurrent);
}

void PrimitiveBuilder::addSurface(std::shared_ptr<const Surface> surface,
                                  const DeclaredPrimitive &declared,
                                  const Matrix4 &objectFromCurrent) {
    std::set<std::string> names;
    ScenePrimitive primitive;
    auto variables = surface->variables();
    auto find = [&](const std::string &name) {
        for (std::size_t i = 0; i < variables.size(); ++i)
            if (variables[i].name == name && isNumeric(variables[i].declaration))
                return int(i);
        return -1;
    };
    for (const VariableInfo &variable : variables)
        if (isNumeric(variable.declaration) && !isInput(variable.name))
            names.insert(variable.name);
    primitive.s = find("s"), primitive.t = find("t");
    primitive.Cs = find("Cs"), primitive.Os = find("Os");

    const Attributes &attributes = *declared.attributes;
    Shading shading = shadingOf(attributes, names);
    if (shading.code < 0)
        return;
    for (const std::string &name : state_.codes[shading.code].variableNames)
        primitive.overriding.push_back(find(name));
    primitive.surface = std::move(surface);
    primitive.attributes = declared.attributes;
    primitive.currentFromObject = declared.currentFromObject;
    primitive.objectFromCurrent = objectFromCurrent;
    primitive.normalSign = attributes.flipNormal ? -1 : 1;

    PrimitiveSummary summary;
    summary.parameterOffset = shading.parameterOffset;
    summary.code = shading.code;
    summary.lightSet = lightSetOf(attributes);
    summary.Cs = attributes.color.c, summary.Os = attributes.opacity.c;
    for (const Matrix4 *matrix : {&primitive.currentFromObject, &primitive.objectFromCurrent})
        state_.objectMatrices.insert(state_.objectMatrices.end(), matrix->m.begin(),
                                     matrix->m.end());
    state_.primitives.push_back(std::move(primitive));
    state_.summaries.push_back(summary);
    flat_.push_back(std::holds_alternative<PolygonsRecord>(declared.record->shape));
}

float PrimitiveBuilder::coarseningForBudget() const {
    constexpr double budget = 12e6;
    double triangles = 0;
    for (std::size_t i = 0; i < state_.primitives.size(); ++i) {
        // Polygons are exact however large their triangles.
        if (flat_[i])
            continue;
        const ScenePrimitive &primitive = state_.primitives[i];
        DiceRate rate = diceRate(state_.camera, primitive.surface->bound(),
                                 primitive.currentFromObject, primitive.attributes->shadingRate);
        Box3 bound = primitive.surface->bound();
        double radius = length(bound.extent()) / 2;
        double edge = std::min(double(rate.edgeLength), std::sqrt(8 * radius * rate.chordError));
        triangles += 2 * primitive.surface->area() / (edge * edge);
    }
    return float(std::max(1.0, triangles / budget));
}

RayMesh PrimitiveBuilder::diceOne(std::size_t index, float coarsening) {
    ScenePrimitive &primitive = state_.primitives[index];
    PrimitiveSummary &summary = state_.summaries[index];
    DiceRate rate = diceRate(state_.camera, primitive.surface->bound(), primitive.currentFromObject,
                             primitive.attributes->shadingRate);
    rate.chordError *= coarsening;
    rate.edgeLength *= std::sqrt(coarsening);
    // Light is found by sampling the true surface and by hitting the dicing; both must agree, also
    // in small pictures.
    if (primitive.attributes->areaLight || state_.codes[summary.code].code->facts().emits) {
        Vec3 extent = primitive.surface->bound().extent();
        rate.chordError =
            std::min(rate.chordError, 1e-4f * std::max({extent.x, extent.y, extent.z}));
    }
    DicedMesh diced = primitive.surface->dice(rate);

    RayMesh mesh;
    mesh.positions = std::move(diced.positions);
    float most = 0;
    for (Vec3 &position : mesh.positions) {
        position = transformPoint(primitive.currentFromObject, position);
        most = std::max({most, std::abs(position.x), std::abs(position.y), std::abs(position.z)});
    }
    if (!diced.vertexUv.empty()) {
        primitive.triangles = diced.triangles;
        primitive.vertexUv = std::move(diced.vertexUv);
    }
    mesh.triangles = std::move(diced.triangles);
    mesh.opaque = isOpaque(*state_.codes[summary.code].code, primitive);
    if (primitive.attributes->sides == 1)
        mesh.frontSign = windingSign(primitive, mesh);
    summary.offset =
        diced.chordError * largestStretch(primitive.currentFromObject) + most * 8 * 0x1p-24f;
    return mesh;
}

std::vector<RayMesh> PrimitiveBuilder::dice() {
    std::vector<RayMesh> meshes(state_.primitives.size());
    float coarsening = coarseningForBudget();
    parallelFor(meshes.size(), [&](std::size_t i) { meshes[i] = diceOne(i, coarsening); });
    Box3 box;
    for (const RayMesh &mesh : meshes) {
        for (Vec3 position : mesh.positions)
            box.add(position);
        state_.statistics.triangles += mesh.triangles.size();
    }
    state_.statistics.primitives = meshes.size();
    state_.statistics.codes = state_.codes.size();
    if (!box.empty()) {
        state_.centre = box.centre();
        state_.radius = std::max(length(box.extent()) / 2, 1e-6f);
    }
    return meshes;
}

} // namespace candela

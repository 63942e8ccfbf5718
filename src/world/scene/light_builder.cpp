// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_builder.h"

#include "world/scene/light_power.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// A number or string that an instance has for a parameter: as given, else the shader's default.
const ir::ShaderParameter *parameterOf(const ShaderCode &code, const std::string &name) {
    for (const ir::ShaderParameter &parameter : code.shader().parameters)
        if (parameter.name == name)
            return &parameter;
    return nullptr;
}

float numberOf(const LightRecord &record, const ShaderCode &code, const std::string &name) {
    const ir::ShaderParameter *parameter = parameterOf(code, name);
    float standard = parameter && !parameter->defaults.empty() ? parameter->defaults[0] : 0;
    return record.shader.parameters.number(name, standard);
}

LightTags tagsOf(const LightRecord &record, const ShaderCode &code) {
    const ir::ShaderParameter *parameter = parameterOf(code, "__category");
    std::string standard =
        parameter && !parameter->stringDefaults.empty() ? parameter->stringDefaults[0] : "";
    LightTags tags;
    tags.categories = categoryWords(record.shader.parameters.string("__category", standard));
    tags.nonDiffuse = numberOf(record, code, "__nondiffuse") == 1;
    tags.nonSpecular = numberOf(record, code, "__nonspecular") == 1;
    return tags;
}

LightKind kindOf(const LightRecord &record, ir::LightClass lightClass) {
    if (lightClass == ir::LightClass::Ambient)
        return LightKind::Ambient;
    if (lightClass == ir::LightClass::Distant)
        return LightKind::Distant;
    if (!record.area)
        return LightKind::Point;
    return record.units == LightUnits::Si ? LightKind::Area : LightKind::ClassicArea;
}

bool needsGeometry(LightKind kind) {
    return kind == LightKind::Area || kind == LightKind::ClassicArea || kind == LightKind::Emitter;
}

} // namespace

LightBuilder::LightBuilder(SceneState &state, ShaderLibrary &library)
    : state_(state), library_(library) {}

void LightBuilder::declare(const std::vector<std::shared_ptr<const LightRecord>> &records) {
    for (const auto &record : records) {
        SceneLight light;
        LightTags tags;
        auto instance = library_.instance(ShaderKind::Light, record->shader, state_.options,
                                          ir::LightRule::Classic, {});
        if (instance) {
            light.shader = *instance;
            light.kind = kindOf(*record, instance->code->shader().lightClass);
            tags = tagsOf(*record, *instance->code);
        }
        light.si = record->units == LightUnits::Si;
        light.castsShadow = !state_.classic || record->shadows;
        light.currentFromShader = record->shader.currentFromShader.atOpen();
        state_.lights.lights.push_back(std::move(light));
        tags_.push_back(std::move(tags));
    }
}

void LightBuilder::addTriangles(int index, std::uint32_t primitiveIndex, const RayMesh &mesh) {
    SceneLight &light = state_.lights.lights[index];
    ScenePrimitive &primitive = state_.primitives[primitiveIndex];
    areas_.resize(state_.lights.lights.size());
    if (!primitive.vertexUv.empty()) {
        primitive.uvDensity =
            std::make_shared<UvDensity>(*primitive.surface, primitive.currentFromObject);
        light.triangles.push_back({primitiveIndex, wholeSurface});
        areas_[index].push_back(primitive.uvDensity->area());
        return;
    }
    for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
        auto [a, b, c] = mesh.triangles[k];
        Vec3 p0 = mesh.positions[a];
        Vec3 normal = cross(mesh.positions[b] - p0, mesh.positions[c] - p0);
        light.triangles.push_back({primitiveIndex, std::uint32_t(k)});
        areas_[index].push_back(double(length(normal)) / 2);
    }
}

void LightBuilder::attachAreas(const std::vector<RayMesh> &meshes) {
    int declared = int(state_.lights.lights.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        PrimitiveSummary &summary = state_.summaries[i];
        SceneCode &code = state_.codes[summary.code];
        const auto &areaLight = state_.primitives[i].attributes->areaLight;
        if (areaLight && areaLight->index >= 0 && areaLight->index < declared) {
            SceneLight &light = state_.lights.lights[areaLight->index];
            if (needsGeometry(light.kind)) {
                addTriangles(areaLight->index, std::uint32_t(i), meshes[i]);
                code.wanted.add(*light.shader.code);
            }
            if (light.kind == LightKind::Area)
                summary.light = areaLight->index + 1;
        }
        if (state_.classic || summary.light != 0 || !code.code->facts().emits)
            continue;
        SceneLight emitter;
        emitter.kind = LightKind::Emitter;
        emitter.shader = {code.code, summary.parameterOffset};
        state_.lights.lights.push_back(std::move(emitter));
        tags_.emplace_back();
        summary.light = int(state_.lights.lights.size());
        addTriangles(summary.light - 1, std::uint32_t(i), meshes[i]);
    }
    areas_.resize(state_.lights.lights.size());
    for (std::size_t light = 0; light < state_.lights.lights.size(); ++light)
        finishArea(int(light));
    fillSwitches();
}

/// Running sums of the triangles' shares, and the densities that follow from them.
void LightBuilder::finishArea(int index) {
    SceneLight &light = state_.lights.lights[index];
    if (!needsGeometry(light.kind))
        return;
    double total = 0;
    for (double area : areas_[index])
        total += area;
    if (!(total > 0)) {
        light.kind = LightKind::None;
        return;
    }
    light.area = total;
    const ShaderCode *code = light.shader.code.get();
    auto &areaCodes = state_.areaLightCodes;
    if (light.kind == LightKind::Area &&
        std::find(areaCodes.begin(), areaCodes.end(), code) == areaCodes.end())
        areaCodes.push_back(code);
    double sum = 0;
    for (std::size_t k = 0; k < light.triangles.size(); ++k) {
        double share = areas_[index][k] / total;
        sum += share;
        light.cumulative.push_back(sum);
        auto [primitiveIndex, triangle] = light.triangles[k];
        ScenePrimitive &primitive = state_.primitives[primitiveIndex];
        if (triangle == wholeSurface)
            primitive.uvDensity->scale(float(share));
        else if (light.finite())
            primitive.density.push_back(float(1 / total));
    }
    for (double &share : light.cumulative)
        share /= sum;
    auto codeOf = [&](const SceneLight::Triangle &place) {
        return state_.summaries[place.primitive].code;
    };
    int first = codeOf(light.triangles.front());
    bool same = std::ranges::all_of(light.triangles,
                                    [&](const auto &place) { return codeOf(place) == first; });
    light.surfaceCode = same ? first : -1;
}

void LightBuilder::fillSwitches() {
    std::size_t row = state_.lights.lights.size() + 1;
    state_.lights.isOn.assign(state_.lightSets.size() * row, 0);
    for (std::size_t set = 0; set < state_.lightSets.size(); ++set) {
        std::uint8_t *on = state_.lights.isOn.data() + set * row;
        on[0] = 1;
        for (int index : state_.lightSets[set])
            if (index >= 0 && index < int(row) - 1)
                on[index + 1] = 1;
        for (std::size_t light = 0; light + 1 < row; ++light)
            if (state_.lights.lights[light].kind == LightKind::Emitter)
                on[light + 1] = 1;
    }
    state_.statistics.lights = state_.lights.lights.size();
}

void LightBuilder::bindCategories(const ShaderLibrary &library) {
    for (const auto &code : library.all()) {
        if (code->categories().empty())
            continue;
        std::vector<std::uint8_t> accepts;
        for (const std::string &category : code->categories()) {
            accepts.push_back(categoryAccepts(category, {}));
            for (const LightTags &tags : tags_)
                accepts.push_back(categoryAccepts(category, tags));
        }
        code->bindCategories(std::move(accepts), int(tags_.size()));
    }
}

void LightBuilder::estimatePowers() {
    for (SceneLight &light : state_.lights.lights)
        light.power = estimatePower(state_, light);
    state_.lights.finish();
    for (std::size_t i = 0; i < state_.primitives.size(); ++i)
        if (int light = state_.summaries[i].light) {
            float probability = state_.lights.lights[light - 1].probability;
            for (float &density : state_.primitives[i].density)
                density *= probability;
            if (state_.primitives[i].uvDensity)
                state_.primitives[i].uvDensity->scale(probability);
        }
}

} // namespace candela

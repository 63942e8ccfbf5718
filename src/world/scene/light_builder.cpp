// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_builder.h"

#include "world/scene/light_power.h"
#include "world/scene/source_geometry.h"

#include <algorithm>
#include <cmath>
#include <numbers>

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

/// The inputs that elements tell: position and normals, besides who asks and when.
bool readsOnlyPlace(const ShaderCode &code) {
    for (int input = 0; input < int(ShaderInput::Count); ++input) {
        auto within = [input](ShaderInput first, int components) {
            return input >= int(first) && input < int(first) + components;
        };
        bool given = within(ShaderInput::P, 3) || within(ShaderInput::N, 3) ||
                     within(ShaderInput::Ng, 3) || within(ShaderInput::Ps, 3) ||
                     within(ShaderInput::time, 1);
        if (!given && code.reads(ShaderInput(input)))
            return false;
    }
    return code.variables().empty();
}

/// The sphere within which the eye and all other sources are; -1 = none.
std::int32_t surroundingSource(const LightTable &table) {
    using Form = LightSource::Form;
    std::int32_t dome = -1;
    float largest = 0;
    for (std::size_t k = 0; k < table.sources.size(); ++k)
        if (table.sources[k].form == Form::Sphere && table.sources[k].edgeA.x > largest)
            dome = std::int32_t(k), largest = table.sources[k].edgeA.x;
    if (dome < 0)
        return -1;
    Box3 others;
    others.add(Vec3{0, 0, 0});
    for (std::size_t k = 0; k < table.sources.size(); ++k)
        if (std::int32_t(k) != dome &&
            table.lights[table.sources[k].light].kind != LightKind::Distant)
            others.add(boundOf(table.sources[k], 0).box);
    const Vec3 centre = table.sources[dome].corner;
    Vec3 farthest;
    for (int c = 0; c < 3; ++c)
        farthest[c] = std::max(others.high[c] - centre[c], centre[c] - others.low[c]);
    return length(farthest) < largest ? dome : -1;
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
    sources_.resize(records.size()), appearances_.resize(records.size());
}

void LightBuilder::attachShapes(const RayGeometry &geometry) {
    const PointTables &points = state_.points;
    for (std::uint32_t i = 0; i < points.worldShapes; ++i)
        attach({noHit, i, std::int32_t(i), geometry.world[i]});
    for (std::uint32_t i = 0; i < points.instances.size(); ++i) {
        const Instance &instance = points.instances[i];
        const RayObject &object = geometry.objects[geometry.instances[i].object];
        for (std::uint32_t k = 0; k < object.size(); ++k)
            attach({i, instance.firstShape + k, instance.firstAppearance + std::int32_t(k),
                    object[k]});
    }
    finishLights();
    fillSwitches();
}

void LightBuilder::attach(const PlacedShape &placed) {
    PointTables &points = state_.points;
    auto &lights = state_.lights.lights;
    Appearance &appearance = points.appearances[placed.appearance];
    SurfaceCode &code = points.codes[appearance.code];
    const auto &areaLight = points.details[placed.appearance].attributes->areaLight;
    const int declared = areaLight ? areaLight->index : -1;
    if (declared >= 0 && declared < int(tags_.size()) && lights[declared].hasGeometry()) {
        addSources(declared, placed);
        code.wanted.add(*lights[declared].shader.code);
        if (!code.wanted.isPlain())
            code.fromElements = false;
        if (lights[declared].kind == LightKind::Area)
            appearance.light = declared + 1;
    }
    if (state_.classic || appearance.light != 0 || !code.code->facts().emits)
        return;
    SceneLight emitter;
    emitter.kind = LightKind::Emitter;
    emitter.shader = {code.code, appearance.parameterOffset};
    lights.push_back(std::move(emitter));
    tags_.emplace_back();
    sources_.emplace_back(), appearances_.emplace_back();
    appearance.light = int(lights.size());
    addSources(appearance.light - 1, placed);
}

bool LightBuilder::isPlain(const SceneLight &light, int surfaceCode) const {
    const SurfaceCode &code = state_.points.codes[surfaceCode];
    if (!code.fromElements)
        return false;
    return light.kind == LightKind::Emitter ||
           (readsOnlyPlace(*light.shader.code) && !code.code->facts().emits);
}

void LightBuilder::addSources(int index, const PlacedShape &placed) {
    PointTables &points = state_.points;
    Appearance &appearance = points.appearances[placed.appearance];
    Matrix4 currentFromOuter;
    if (placed.instance != noHit)
        std::copy_n(points.matricesOf(placed.instance), 16, currentFromOuter.m.begin());
    LightSource source;
    source.light = index;
    source.instance = placed.instance, source.shape = placed.shape;
    source.offset = appearance.offset;
    if (placed.instance != noHit)
        source.offset *= points.instances[placed.instance].stretch;
    appearance.firstSource = std::int32_t(sources_[index].size()); // Within the light, as yet.
    appearances_[index].push_back(placed.appearance);
    if (placed.mesh.radius > 0 && placed.instance == noHit) {
        source.form = LightSource::Form::Sphere;
        source.corner = placed.mesh.centre, source.edgeA = {placed.mesh.radius, 0, 0};
        sources_[index].push_back(source);
        return;
    }
    addElements(source, placed, currentFromOuter,
                isPlain(state_.lights.lights[index], appearance.code));
}

/// A source for each element, or for two that make a rectangle, if elements may be paired.
void LightBuilder::addElements(LightSource source, const PlacedShape &placed,
                               const Matrix4 &currentFromOuter, bool pair) {
    std::vector<LightSource> &sources = sources_[source.light];
    std::vector<std::uint32_t> numbers;
    const std::size_t first = sources.size();
    for (std::uint32_t k = 0; k < placed.mesh.triangles.size(); ++k) {
        setTriangle(source, placed.mesh, k, currentFromOuter);
        std::optional<LightSource> rectangle;
        if (pair && k > 0 && sources.size() > first &&
            sources.back().form == LightSource::Form::Triangle)
            rectangle = rectangleOf(sources.back(), source);
        if (rectangle)
            sources.back() = *rectangle;
        else
            sources.push_back(source);
        numbers.push_back(std::uint32_t(sources.size() - 1 - first));
    }
    state_.points.shapes[placed.shape].sourceOfElement = std::move(numbers);
}

/// Puts the sources into one table, light by light.
void LightBuilder::finishLights() {
    LightTable &table = state_.lights;
    for (std::size_t i = 0; i < table.lights.size(); ++i) {
        SceneLight &light = table.lights[i];
        light.firstSource = std::int32_t(table.sources.size());
        if (light.hasGeometry())
            finishGeometry(int(i));
        else if (light.isSampled())
            table.sources.push_back({std::int32_t(i),
                                     LightSource::Form::NoShape,
                                     noHit,
                                     0,
                                     0,
                                     transformPoint(light.currentFromShader, {0, 0, 0}),
                                     {},
                                     {},
                                     0,
                                     0});
        light.sources = std::int32_t(table.sources.size()) - light.firstSource;
    }
    sources_.clear(), appearances_.clear();
}

void LightBuilder::finishGeometry(int index) {
    LightTable &table = state_.lights;
    SceneLight &light = table.lights[index];
    double sum = 0;
    for (const LightSource &source : sources_[index]) {
        sum += areaOf(source);
        light.cumulative.push_back(sum);
    }
    if (!(sum > 0)) {
        light.kind = LightKind::None;
        return;
    }
    light.area = sum;
    for (double &share : light.cumulative)
        share /= sum;
    light.surfaceCode = state_.points.appearances[appearances_[index].front()].code;
    light.plain = true;
    for (std::int32_t at : appearances_[index]) {
        Appearance &appearance = state_.points.appearances[at];
        appearance.firstSource += light.firstSource;
        light.plain &= isPlain(light, appearance.code);
        if (appearance.code != light.surfaceCode)
            light.surfaceCode = -1;
    }
    table.sources.insert(table.sources.end(), sources_[index].begin(), sources_[index].end());
    const ShaderCode *code = light.shader.code.get();
    auto &areaCodes = state_.areaLightCodes;
    if (light.kind == LightKind::Area && std::ranges::find(areaCodes, code) == areaCodes.end())
        areaCodes.push_back(code);
}

void LightBuilder::fillSwitches() {
    const std::size_t row = state_.lights.lights.size() + 1;
    if (state_.lightSets.empty())
        state_.lightSets.emplace_back();
    state_.lights.isOn.assign(state_.lightSets.size(), std::vector<std::uint8_t>(row, 0));
    for (std::size_t set = 0; set < state_.lightSets.size(); ++set) {
        std::vector<std::uint8_t> &on = state_.lights.isOn[set];
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

void LightBuilder::prepareChoices() {
    LightTable &table = state_.lights;
    for (SceneLight &light : table.lights) {
        light.power = estimatePower(state_, light);
        if (light.kind == LightKind::Point)
            light.place = placeOf(state_, light);
    }
    table.number(state_.points);
    const std::int32_t dome = surroundingSource(table);
    for (std::size_t set = 0; set < state_.lightSets.size(); ++set)
        table.choices.push_back(choiceOf(int(set), dome));
    table.isSingle = table.sources.size() <= 1 && std::ranges::all_of(table.isOn, [](auto &on) {
                         return std::ranges::find(on, 0) == on.end();
                     });
}

/// The choice among the sources that are on for a light set; `dome` surrounds them.
LightChoice LightBuilder::choiceOf(int set, std::int32_t dome) const {
    const LightTable &table = state_.lights;
    std::vector<EmitterBound> bounds;
    std::vector<std::int32_t> numbers;
    std::vector<InfiniteLight> infinite;
    std::vector<std::int32_t> surrounding;
    // Estimates may miss a narrow beam: no light counts for nothing.
    double strongest = 0;
    for (const SceneLight &light : table.lights)
        strongest = std::max(strongest, light.power);
    const double least = strongest > 0 ? 1e-4 * strongest : 1;
    for (std::size_t i = 0; i < table.lights.size(); ++i) {
        const SceneLight &light = table.lights[i];
        if (!table.on(set, std::int32_t(i) + 1))
            continue;
        const double power = std::max(light.power, least);
        for (std::int32_t k = light.firstSource; k < light.firstSource + light.sources; ++k) {
            const LightSource &source = table.sources[k];
            const double share = light.area > 0 ? areaOf(source) / light.area : 1;
            const bool anywhere = light.kind == LightKind::Distant ||
                                  (light.kind == LightKind::Point && light.place.empty());
            if (anywhere) {
                const double disc = std::numbers::pi * state_.radius * state_.radius;
                infinite.push_back({k, float(power / disc), true, {}, 1});
            } else if (k == dome) {
                surrounding.push_back(k);
            } else if (share > 0) {
                bounds.push_back(boundOf(source, power * share));
                if (light.kind == LightKind::Point)
                    bounds.back().box = light.place;
                numbers.push_back(k);
            }
        }
    }
    return LightChoice(bounds, numbers, infinite, int(table.sources.size()), surrounding);
}

} // namespace candela

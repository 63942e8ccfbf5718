// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_builder.h"
#include "language/ir/transform/light_rule.h"

#include "world/scene/absent_lamps.h"
#include "world/scene/light_power.h"
#include "world/scene/skies.h"
#include "world/scene/source_geometry.h"
#include "world/scene/source_pieces.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <set>

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

/// Consecutive inputs.
struct Inputs {
    ShaderInput first;
    int components;
};

/// True if code reads no inputs but these.
template <class Code> bool readsOnly(const Code &code, std::initializer_list<Inputs> given) {
    for (int input = 0; input < int(ShaderInput::Count); ++input) {
        const bool known = std::ranges::any_of(given, [input](const Inputs &inputs) {
            return input >= int(inputs.first) && input < int(inputs.first) + inputs.components;
        });
        if (!known && code.reads(ShaderInput(input)))
            return false;
    }
    return true;
}

/// The inputs that elements tell: position and normals, besides who asks and when.
bool readsOnlyPlace(const ShaderCode &code) {
    return code.variables().empty() && readsOnly(code, {{ShaderInput::P, 3},
                                                        {ShaderInput::N, 3},
                                                        {ShaderInput::Ng, 3},
                                                        {ShaderInput::Ps, 3},
                                                        {ShaderInput::Ns, 3},
                                                        {ShaderInput::Is, 3},
                                                        {ShaderInput::time, 1}});
}

/// A surface sends the same from everywhere to everywhere: what was seen of it is all there is.
bool emitsAlike(const ShaderCode &code) {
    return code.variables().empty() && readsOnly(code.question(ir::Question::Emit),
                                                 {{ShaderInput::Cs, 3}, {ShaderInput::Os, 3}});
}

/// Where a light's shadows come from: nothing is said of them; its shader looks them up, and those
/// and no others are wanted; or it would if the map were there, and rays have to find them.
enum class Shadows { Unsaid, Own, ByRays };

Shadows shadowsOf(const ShaderInstance &light, const ShaderLibrary &library) {
    const auto traces = [](const ir::ServiceUse &use) {
        return use.info->service == Service::transmission ||
               use.info->service == Service::occlusion;
    };
    if (std::ranges::any_of(light.code->shader().whole.services, traces))
        return Shadows::Own;
    Shadows result = Shadows::Unsaid;
    for (const std::string &map : light.code->namesAsked(Service::shadow, light.parameterOffset)) {
        if (map.empty())
            continue;
        if (library.hasShadowMap(map))
            return Shadows::Own;
        result = Shadows::ByRays;
    }
    return result;
}

/// "shader" space, and where it goes.
void placeShader(const MotionTransform &currentFromShader, const Shutter &shutter,
                 SceneLight &light) {
    light.currentFromShader = currentFromShader.atOpen();
    if (!currentFromShader.motion)
        return;
    std::vector<double> times;
    currentFromShader.motion->addTimes(times);
    light.steps = motionSteps([&](double time) { return currentFromShader.motion->at(time); },
                              times, shutter);
    light.currentFromShader = light.steps.front();
    if (light.steps.size() == 1)
        light.steps.clear();
}

} // namespace

LightBuilder::LightBuilder(SceneState &state, ShaderLibrary &library)
    : state_(state), library_(library) {}

void LightBuilder::declare(const std::vector<std::shared_ptr<const LightRecord>> &records) {
    std::vector<std::vector<ToldParameter>> told;
    for (const auto &declared : records) {
        const LightRecord record = library_.lightWithShader(*declared, state_.options);
        const ShaderRecord &shader = record.shader;
        told.push_back(library_.parametersTold(ShaderKind::Light, shader, state_.options,
                                               ir::LightRule::Classic));
        SceneLight light;
        light.title = "light \"" + record.handle + "\" (\"" + declared->shader.name + "\")";
        light.where = shader.parameters.where;
        light.isTurnedOff = *record.isTurnedOff;
        LightTags tags;
        auto instance = library_.instance(ShaderKind::Light, shader, state_.options,
                                          ir::LightRule::Classic, {});
        if (instance) {
            light.shader = *instance;
            light.kind = kindOf(record, instance->code->shader().lightClass);
            tags = tagsOf(*declared, *instance->code);
        }
        light.si = record.units == LightUnits::Si;
        const Shadows shadows = instance ? shadowsOf(*instance, library_) : Shadows::Unsaid;
        light.looksUpShadows = shadows == Shadows::Own;
        light.castsShadow = shadows == Shadows::ByRays ||
                            (shadows == Shadows::Unsaid && (!state_.classic || record.shadows));
        placeShader(shader.currentFromShader, state_.points.shutter, light);
        light.parametersChange = shader.motion && state_.points.shutter.hasInterval();
        state_.lights.lights.push_back(std::move(light));
        tags_.push_back(std::move(tags));
    }
    library_.bindLights(std::move(told));
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
        addElements(declared, placed);
        code.wanted.add(lights[declared].shader.code->shader().whole.inputsRead);
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
    emitter.title = "a surface with shader \"" + code.code->name() + "\"";
    if (const auto &surface = points.details[placed.appearance].attributes->surface)
        emitter.where = surface->parameters.where;
    lights.push_back(std::move(emitter));
    tags_.emplace_back();
    sources_.emplace_back(), appearances_.emplace_back();
    appearance.light = int(lights.size());
    addElements(appearance.light - 1, placed);
}

bool LightBuilder::isPlain(const SceneLight &light, int surfaceCode) const {
    const SurfaceCode &code = state_.points.codes[surfaceCode];
    if (!code.fromElements)
        return false;
    return light.kind == LightKind::Emitter ||
           (readsOnlyPlace(*light.shader.code) && !code.code->facts().emits);
}

void LightBuilder::addElements(int index, const PlacedShape &placed) {
    PointTables &points = state_.points;
    std::vector<LightElement> &elements = state_.lights.elements;
    Appearance &appearance = points.appearances[placed.appearance];
    Matrix4 currentFromOuter;
    LightElement element;
    element.instance = placed.instance, element.shape = placed.shape;
    element.offset = appearance.offset;
    if (placed.instance != noHit) {
        std::copy_n(points.matricesOf(placed.instance), 16, currentFromOuter.m.begin());
        element.offset *= points.instances[placed.instance].stretch;
    }
    const auto first = std::int32_t(elements.size());
    if (std::optional<LightElement> sphere = sphereOf(element, placed.mesh, currentFromOuter))
        elements.push_back(*sphere);
    for (std::uint32_t k = 0; k < placed.mesh.triangles.size(); ++k) {
        setTriangle(element, placed.mesh, k, currentFromOuter);
        elements.push_back(element);
    }
    if (first == std::int32_t(elements.size()))
        return;
    appearance.firstElement = first;
    state_.lights.lights[index].opaque &= placed.mesh.opaque;
    appearances_[index].push_back(placed.appearance);
    lightOfElement_.resize(elements.size(), index);
    addSources(index, placed, first);
}

void LightBuilder::addSources(int index, const PlacedShape &placed, std::int32_t first) {
    const std::vector<LightElement> &elements = state_.lights.elements;
    const std::span own(elements.begin() + first, elements.end());
    // What turns is no rectangle between the steps of its motion.
    const bool moves =
        placed.instance != noHit && state_.points.instances[placed.instance].steps > 0;
    const bool pair = !moves && isPlain(state_.lights.lights[index],
                                        state_.points.appearances[placed.appearance].code);
    if (own.size() == 1 || state_.points.shapes[placed.shape].surface->isFlat())
        if (addSingly(index, first, pair))
            return;
    const Pieces pieces = cutToPieces(own);
    std::vector<std::int32_t> members;
    std::uint32_t begin = 0;
    for (std::uint32_t end : pieces.ends) {
        members.clear();
        for (; begin < end; ++begin)
            members.push_back(first + std::int32_t(pieces.order[begin]));
        addSource(index, members);
    }
}

/// A few elements are sources of their own; two that make a rectangle are one, if elements may be
/// paired. False, and nothing done, if that were many.
bool LightBuilder::addSingly(int index, std::int32_t first, bool pair) {
    std::vector<LightElement> &elements = state_.lights.elements;
    const auto last = std::int32_t(elements.size());
    std::vector<std::pair<std::int32_t, std::optional<LightElement>>> found;
    for (std::int32_t k = first; k < last; ++k) {
        if (found.size() == mostPieces)
            return false;
        found.push_back({k, {}});
        if (pair && k + 1 < last &&
            (found.back().second = rectangleOf(elements[k], elements[k + 1])))
            ++k;
    }
    for (const auto &[at, rectangle] : found) {
        if (rectangle)
            elements[at] = *rectangle;
        addSource(index, {&at, 1});
        if (rectangle) // A ray may meet either half.
            elements[at + 1] = elements[at];
    }
    return true;
}

void LightBuilder::addSource(int index, std::span<const std::int32_t> members) {
    LightTable &table = state_.lights;
    LightSource source;
    source.light = index;
    source.firstMember = std::int32_t(table.members.size());
    source.members = std::int32_t(members.size());
    if (const std::uint32_t on = table.elements[members.front()].instance; on != noHit)
        source.handedness = state_.points.instances[on].handedness;
    for (std::int32_t member : members) {
        source.area += areaOf(table.elements[member]);
        table.members.push_back(member);
        table.memberShares.push_back(source.area);
    }
    for (double &share : std::span(table.memberShares).last(members.size()))
        share = source.area > 0 ? share / source.area : 0;
    for (std::int32_t member : members) {
        LightElement &element = table.elements[member];
        element.source = std::int32_t(sources_[index].size()); // Within the light, as yet.
        element.area = float(source.area);
    }
    sources_[index].push_back(source);
}

/// A light without geometry has one source, of an element without a form.
void LightBuilder::addPoint(int light) {
    LightTable &table = state_.lights;
    LightSource source;
    source.light = light;
    source.firstMember = std::int32_t(table.members.size()), source.members = 1;
    LightElement element;
    element.source = std::int32_t(table.sources.size());
    table.members.push_back(std::int32_t(table.elements.size()));
    table.memberShares.push_back(1);
    table.elements.push_back(element);
    table.sources.push_back(source);
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
            addPoint(int(i));
        light.sources = std::int32_t(table.sources.size()) - light.firstSource;
    }
    for (std::size_t k = 0; k < lightOfElement_.size(); ++k)
        table.elements[k].source += table.lights[lightOfElement_[k]].firstSource;
}

void LightBuilder::finishGeometry(int index) {
    LightTable &table = state_.lights;
    SceneLight &light = table.lights[index];
    double sum = 0;
    for (const LightSource &source : sources_[index]) {
        sum += source.area, light.elements += source.members;
        light.cumulative.push_back(sum);
    }
    if (!(sum > 0)) {
        light.kind = LightKind::None;
        for (std::int32_t at : appearances_[index]) // Who meets its elements asks for no density.
            state_.points.appearances[at].firstElement = -1;
        return;
    }
    light.area = light.areaLeft = sum;
    for (double &share : light.cumulative)
        share /= sum;
    light.surfaceCode = state_.points.appearances[appearances_[index].front()].code;
    light.plain = true;
    for (std::int32_t at : appearances_[index]) {
        const Appearance &appearance = state_.points.appearances[at];
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

void LightBuilder::addSetOfAll() {
    std::vector<std::vector<int>> &sets = state_.lightSets;
    std::set<int> on;
    for (const std::vector<int> &set : sets)
        on.insert(set.begin(), set.end());
    const bool areOnlyLamps =
        std::ranges::all_of(state_.points.details, [](const AppearanceDetail &detail) {
            return detail.attributes->areaLight != nullptr;
        });
    for (int light = 0; areOnlyLamps && light < int(state_.lights.lights.size()); ++light)
        on.insert(light);
    const std::vector<int> all(on.begin(), on.end());
    const auto same = std::ranges::find(sets, all);
    state_.lights.setOfAll = std::int32_t(same - sets.begin());
    if (same == sets.end())
        sets.push_back(all);
}

void LightBuilder::fillSwitches() {
    const std::size_t row = state_.lights.lights.size() + 1;
    addSetOfAll();
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
        const std::vector<std::string> &categories = code->shader().whole.categories;
        if (categories.empty())
            continue;
        std::vector<std::uint8_t> accepts;
        for (const std::string &category : categories) {
            accepts.push_back(categoryAccepts(category, {}));
            for (const LightTags &tags : tags_)
                accepts.push_back(categoryAccepts(category, tags));
        }
        code->bindCategories(std::move(accepts), int(tags_.size()));
    }
    // Directions would meet what shadow rays pass: they would find less light than these.
    state_.lights.leftToSamples =
        std::ranges::any_of(state_.points.details, [](const AppearanceDetail &detail) {
            return shadowCasting(*detail.attributes) == ShadowCasting::None ||
                   !detail.visibility.shadow || !detail.visibility.diffuse;
        });
    if (state_.lights.leftToSamples)
        for (const auto &code : library.all())
            code->leaveLightsToSamples(int(tags_.size()));
}

namespace {

/// Steradians of the sky above the eye that an element fills. Of a ball around the eye, which may
/// be a lamp like others, those above the scene's centre.
double skyFilledBy(LightElement element, const Vec3 &centre) {
    const bool isAroundEye =
        element.form == LightElement::Form::Sphere && length(element.corner) <= element.edgeA.x;
    if (isAroundEye)
        element.corner = element.corner - centre;
    return solidAngleOf(element);
}

/// 1 for sources that shine from far and wide: those without a place, and those of lights that fill
/// much of the sky.
std::vector<std::uint8_t> wideSources(const SceneState &state,
                                      std::span<const EmitterBound> bounds) {
    constexpr double leastSolidAngle = 1;
    const LightTable &table = state.lights;
    std::vector<double> solidAngle(table.lights.size());
    for (const LightSource &source : table.sources)
        for (std::int32_t k = 0; k < source.members; ++k)
            solidAngle[source.light] +=
                skyFilledBy(table.elements[table.members[source.firstMember + k]], state.centre);
    std::vector<std::uint8_t> wide;
    for (std::size_t k = 0; k < bounds.size(); ++k)
        wide.push_back(bounds[k].box.empty() ||
                       solidAngle[table.sources[k].light] >= leastSolidAngle);
    return wide;
}

/// The largest sphere, if all other sources that have a place are within it and scattered rays can
/// meet it as a light; none has source -1. What it surrounds besides, each point asks for itself.
SurroundingLight surroundingLight(const LightTable &table, const PointTables &points,
                                  std::span<const EmitterBound> bounds) {
    const auto moves = [&](const LightElement &element) {
        return element.instance != noHit && points.instances[element.instance].steps > 0;
    };
    const auto radiusOf = [&](std::size_t k) {
        const LightSource &source = table.sources[k];
        const bool isSingle = source.members == 1 && table.lights[source.light].finite();
        const LightElement *element = isSingle ? &table.firstElementOf(source) : nullptr;
        return element && element->form == LightElement::Form::Sphere && !moves(*element)
                   ? element->edgeA.x
                   : 0.0f;
    };
    std::int32_t dome = -1;
    float largest = 0;
    for (std::size_t k = 0; k < bounds.size(); ++k)
        if (const float radius = radiusOf(k); radius > largest)
            dome = std::int32_t(k), largest = radius;
    if (dome < 0)
        return {};
    Box3 others;
    for (std::size_t k = 0; k < bounds.size(); ++k)
        if (std::int32_t(k) != dome)
            others.add(bounds[k].box);
    const Vec3 centre = table.firstElementOf(table.sources[dome]).corner;
    Vec3 farthest;
    for (int c = 0; c < 3; ++c)
        farthest[c] = std::max(others.high[c] - centre[c], centre[c] - others.low[c]);
    if (!others.empty() && !(length(farthest) < largest))
        return {};
    return {dome, bounds[dome], centre, largest};
}

} // namespace

void LightBuilder::prepareChoices() {
    LightTable &table = state_.lights;
    measureCutLamps(state_);
    estimateLights(state_);
    findSkies(state_);
    table.number(state_.points);
    const std::vector<EmitterBound> bounds = boundsOfSources();
    const SurroundingLight dome = surroundingLight(table, state_.points, bounds);
    const std::vector<std::uint8_t> wide = wideSources(state_, bounds);
    for (std::size_t set = 0; set < state_.lightSets.size(); ++set)
        table.choices.push_back({choiceOf(int(set), lampGroup, bounds, wide, dome),
                                 choiceOf(int(set), wideGroup, bounds, wide, dome)});
    const bool some[lightGroups] = {std::ranges::count(wide, 0) > 0,
                                    std::ranges::count(wide, 1) > 0};
    for (LightGroup group : {lampGroup, wideGroup})
        if (some[group])
            table.groups.push_back(group);
    table.isSingle = table.sources.size() <= 1 && std::ranges::all_of(table.isOn, [](auto &on) {
                         return std::ranges::find(on, 0) == on.end();
                     });
}

/// Sources without a place have an empty box, those without any power 0.
std::vector<EmitterBound> LightBuilder::boundsOfSources() const {
    const LightTable &table = state_.lights;
    const PointTables &points = state_.points;
    // Estimates may miss a narrow beam: no light counts for nothing, and those that seem dark share
    // some samples.
    constexpr double shareOfDark = 0.02;
    double strongest = 0, dark = 1;
    for (const SceneLight &light : table.lights) {
        strongest = std::max(strongest, light.power);
        dark += light.isSampled() && light.power == 0;
    }
    const double least = strongest > 0 ? shareOfDark / dark * strongest : 1;
    std::vector<EmitterBound> bounds;
    for (const LightSource &source : table.sources) {
        const SceneLight &light = table.lights[source.light];
        EmitterBound bound;
        double share = 1;
        if (light.hasGeometry()) {
            const LightElement &element = table.firstElementOf(source);
            const Appearance &appearance =
                points.appearances[points.appearanceOf(element.instance, element.shape)];
            bound = boundOf(table, source, light.sides, appearance.elementSign);
            if (element.instance != noHit) {
                Matrix4 objectFromOpen;
                std::copy_n(points.matricesOf(element.instance) + 16, 16, objectFromOpen.m.begin());
                spreadByMotion(points.stepsOf(element.instance), objectFromOpen, bound);
            }
            share = source.area / light.area;
        } else if (light.kind == LightKind::Point) {
            bound.box = light.parametersChange ? Box3{} : light.place;
            bound.axis = light.axis;
            bound.emissionSpread = light.spread, bound.isLoose = true;
            if (!light.steps.empty()) {
                spreadByMotion(light.steps, inverse(light.currentFromShader).value_or(Matrix4{}),
                               bound);
                bound.axis = {}, bound.emissionSpread = std::numbers::pi_v<float>;
            }
        }
        // Black `constant` surfaces, most of all.
        const bool black =
            light.power == 0 && light.kind == LightKind::Emitter && emitsAlike(*light.shader.code);
        bound.power = black ? 0 : float(std::max(light.power, least) * share);
        bounds.push_back(bound);
    }
    return bounds;
}

/// The choice among the sources of a group that are on for a light set; `dome` surrounds them.
LightChoice LightBuilder::choiceOf(int set, LightGroup group, std::span<const EmitterBound> bounds,
                                   std::span<const std::uint8_t> wide,
                                   const SurroundingLight &dome) const {
    const LightTable &table = state_.lights;
    std::vector<EmitterBound> finite;
    std::vector<std::int32_t> numbers;
    std::vector<InfiniteLight> infinite;
    SurroundingLight surrounding;
    const double disc = std::numbers::pi * state_.radius * state_.radius;
    for (std::int32_t k = 0; k < std::int32_t(bounds.size()); ++k) {
        if (!table.on(set, table.sources[k].light + 1) || wide[k] != (group == wideGroup))
            continue;
        if (bounds[k].box.empty())
            infinite.push_back({k, float(bounds[k].power / disc), true, {}, 1});
        else if (k == dome.source)
            surrounding = dome;
        else if (bounds[k].power > 0)
            finite.push_back(bounds[k]), numbers.push_back(k);
    }
    return LightChoice(finite, numbers, infinite, int(table.sources.size()), surrounding);
}

} // namespace candela

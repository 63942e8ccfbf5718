// SPDX-License-Identifier: Apache-2.0
#include "world/scene/appearance_builder.h"
#include "language/ir/transform/light_rule.h"
#include "world/shading/instance_values.h"

#include <algorithm>

namespace candela {

namespace {

/// Asks for the shipped library's default surface.
const ShaderRecord &defaultSurface() {
    static const ShaderRecord record;
    return record;
}

OtherShaders shadersOf(const Attributes &attributes) {
    return {attributes.surface ? attributes.surface.get() : &defaultSurface(),
            attributes.displacement.get(), attributes.atmosphere.get(), attributes.interior.get(),
            attributes.exterior.get()};
}

/// Over the shutter's interval; none if it stays the same.
std::vector<Color> colorSteps(const SharedInTime<Color> &motion, const Shutter &shutter) {
    if (!motion || !shutter.hasInterval())
        return {};
    std::vector<Color> colors;
    const int steps = stepsThrough(motion->times, shutter.open, shutter.close);
    for (int step = 0; step <= steps; ++step) {
        const double time = shutter.open + double(step) / steps * (shutter.close - shutter.open);
        const KnotPlace place = placeAmong(motion->times, time);
        Color &color = colors.emplace_back();
        for (int c = 0; c < colorSamples; ++c) {
            const float from = motion->values[place.knot].c[c];
            color.c[c] = float(from + place.share * (motion->values[place.next].c[c] - from));
        }
    }
    return colors;
}

} // namespace

AppearanceBuilder::AppearanceBuilder(SceneState &state, ShaderLibrary &library)
    : state_(state), library_(library) {
    state_.media.emplace_back();
}

int AppearanceBuilder::numberOf(std::shared_ptr<ShaderCode> code) {
    auto &codes = state_.points.codes;
    auto [place, isNew] = codeNumbers_.try_emplace(code.get(), int(codes.size()));
    if (isNew)
        codes.push_back(surfaceCode(std::move(code)));
    return place->second;
}

AppearanceBuilder::Shading AppearanceBuilder::shadingOf(const Attributes &attributes,
                                                        const std::set<std::string> &variables) {
    const OtherShaders all = shadersOf(attributes);
    for (const Attributes *asked : {static_cast<const Attributes *>(nullptr), &attributes}) {
        const auto known = shadings_.find({all, variables, asked});
        if (known != shadings_.end())
            return known->second;
    }
    auto rule = state_.classic ? ir::LightRule::Classic : ir::LightRule::Path;
    auto instance = library_.instance(ShaderKind::Surface, *all.surface, state_.options, rule,
                                      variables, all, &attributes);
    Shading shading{-1, 0};
    const Attributes *asked = nullptr;
    if (instance) {
        shading = {numberOf(instance->code), instance->parameterOffset};
        asked = asksForAttributes(instance->code->shader()) ? &attributes : nullptr;
    }
    shadings_[{all, variables, asked}] = shading;
    return shading;
}

std::optional<ShaderInstance>
AppearanceBuilder::movingShader(const Attributes &attributes,
                                const std::set<std::string> &variables) {
    const Shading shading = shadingOf(attributes, variables);
    if (shading.code < 0 || !state_.points.codes[shading.code].movesPoints)
        return std::nullopt;
    return ShaderInstance{state_.points.codes[shading.code].code, shading.parameterOffset};
}

int AppearanceBuilder::lightSetOf(const Attributes &attributes) {
    auto [place, isNew] = lightSets_.try_emplace(attributes.lightsOn, int(state_.lightSets.size()));
    if (isNew)
        state_.lightSets.push_back(attributes.lightsOn);
    return place->second;
}

std::int32_t AppearanceBuilder::mediumOf(const ShaderRecord *record, const OtherShaders &others) {
    if (!record)
        return 0;
    auto [place, isNew] = media_.try_emplace({record, others}, 0);
    if (!isNew)
        return place->second;
    const auto rule = state_.classic ? ir::LightRule::Classic : ir::LightRule::Path;
    const auto instance =
        library_.instance(ShaderKind::Volume, *record, state_.options, rule, {}, others);
    if (!instance || int(state_.media.size()) > mostMedia)
        return 0;
    if (instance->code->stepsOf(instance->parameterOffset) > 1) { // Like no other.
        state_.media.push_back(*instance);
        return place->second = std::int32_t(state_.media.size()) - 1;
    }
    const std::span<const float> block = instance->code->block(instance->parameterOffset);
    auto [same, isOther] = sameMedia_.try_emplace(
        {instance->code.get(), {block.begin(), block.end()}}, int(state_.media.size()));
    if (isOther)
        state_.media.push_back(*instance);
    return place->second = same->second;
}

SurfaceMedia AppearanceBuilder::mediaOf(const Attributes &attributes) {
    SurfaceMedia media;
    const OtherShaders all = shadersOf(attributes);
    media.atmosphere = mediumOf(all.atmosphere, all);
    media.exterior = mediumOf(all.exterior, all);
    media.interior = attributes.sides == 1 ? 0 : mediumOf(all.interior, all);
    media.lightSet = lightSetOf(attributes);
    return media;
}

bool AppearanceBuilder::add(std::uint32_t shape,
                            const std::shared_ptr<const Attributes> &attributes, bool turned,
                            const Presence &presence) {
    PointTables &points = state_.points;
    const Surface &surface = *points.shapes[shape].surface;
    const Shading shading = shadingOf(*attributes, overridingNames(surface));
    if (shading.code < 0)
        return false;
    Appearance appearance;
    appearance.parameterOffset = shading.parameterOffset;
    appearance.code = shading.code;
    appearance.lightSet = lightSetOf(*attributes);
    appearance.normalSign = turned ? -1 : 1;
    appearance.Cs = attributes->color.c, appearance.Os = attributes->opacity.c;
    AppearanceDetail detail{attributes,
                            {},
                            visibilityOf(*attributes),
                            presence,
                            colorSteps(attributes->colorMotion, points.shutter),
                            colorSteps(attributes->opacityMotion, points.shutter)};
    points.colorsChange |= !detail.colors.empty() || !detail.opacities.empty();
    for (const std::string &name : points.codes[shading.code].variableNames)
        detail.overriding.push_back(numericVariable(surface, name));
    points.appearances.push_back(appearance);
    state_.mediaOfAppearance.push_back(mediaOf(*attributes));
    points.details.push_back(std::move(detail));
    shapes_.push_back(shape);
    return true;
}

bool AppearanceBuilder::shines(std::int32_t index) const {
    const PointTables &points = state_.points;
    return points.details[index].attributes->areaLight ||
           (!state_.classic && points.codes[points.appearances[index].code].code->facts().emits);
}

bool AppearanceBuilder::isOpaque(std::int32_t index) const {
    const PointTables &points = state_.points;
    const Color &opacity = points.details[index].attributes->opacity;
    // What changes its opacity is not opaque for long.
    bool full = points.details[index].opacities.empty() && points.shapes[shapes_[index]].Os < 0 &&
                std::ranges::all_of(opacity.c, [](float o) { return o >= 1; });
    return full && points.codes[points.appearances[index].code].code->facts().opaqueIfOsIs1;
}

void AppearanceBuilder::finish() {
    PointTables &points = state_.points;
    for (SurfaceCode &code : points.codes) // Any volume may end at any surface.
        for (std::size_t k = 1; k < state_.media.size(); ++k)
            addNeeds(*state_.media[k].code, code);
    for (SurfaceCode &code : points.codes)
        code.fromElements = code.wanted.isPlain() && code.variableNames.empty();
    for (std::size_t i = 0; i < points.appearances.size(); ++i) {
        Appearance &appearance = points.appearances[i];
        const Shape &shape = points.shapes[shapes_[i]];
        appearance.offset = shape.offset, appearance.offsetShare = shape.offsetShare;
        appearance.elementSign = shape.elementSign * appearance.normalSign;
        const bool tells = shape.flat || (shape.naming == Naming::Round && !shape.curved &&
                                          !shape.surface->hasOwnNormals());
        if (!tells || shape.Cs >= 0 || shape.Os >= 0)
            points.codes[appearance.code].fromElements = false;
    }
    state_.statistics.codes = points.codes.size();
}

} // namespace candela

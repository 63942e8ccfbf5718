// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/resources.h"

namespace candela {

bool Resources::end() {
    if (blocks_.size() == 1)
        return false;
    blocks_.pop_back();
    return true;
}

void Resources::save(const std::string &name, Resource resource) {
    blocks_.back()[name] = std::move(resource);
}

const Resource *Resources::find(const std::string &name) const {
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
        if (auto found = block->find(name); found != block->end())
            return &found->second;
    return nullptr;
}

/// How surfaces look.
static void restoreShading(Attributes &to, const Attributes &from) {
    to.color = from.color, to.opacity = from.opacity;
    to.surface = from.surface;
    to.atmosphere = from.atmosphere, to.interior = from.interior, to.exterior = from.exterior;
    to.shadingRate = from.shadingRate, to.smoothInterpolation = from.smoothInterpolation;
    to.matte = from.matte;
    to.ownSet |= own::Color | own::Opacity | own::Surface | own::Atmosphere | own::Interior |
                 own::Exterior | own::ShadingRate | own::Interpolation | own::Matte;
}

/// What moves their points.
static void restoreModification(Attributes &to, const Attributes &from) {
    to.displacement = from.displacement, to.deformation = from.deformation;
    to.ownSet |= own::Displacement | own::Deformation;
}

/// What their shapes are.
static void restoreDefinition(Attributes &to, const Attributes &from) {
    to.textureCoordinates = from.textureCoordinates;
    to.uBasis = from.uBasis, to.vBasis = from.vBasis;
    to.flipNormal = from.flipNormal;
}

static void restoreHiding(Attributes &to, const Attributes &from) {
    to.sides = from.sides;
    to.ownSet |= own::Sides;
}

bool restoreSubset(Attributes &to, const Attributes &from, const std::string &subset) {
    const bool all = subset == "all", geometry = all || subset == "geometry";
    const bool shading = all || subset == "shading", hiding = all || subset == "hiding";
    const bool modification = geometry || subset == "geometrymodification";
    const bool definition = geometry || subset == "geometrydefinition";
    if (all)
        to.name = from.name, to.named = from.named;
    if (shading)
        restoreShading(to, from);
    if (modification)
        restoreModification(to, from);
    if (definition)
        restoreDefinition(to, from);
    if (hiding)
        restoreHiding(to, from);
    return shading || modification || definition || hiding;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Light records and shining shapes become the scene's lights, and these fall into sources.
#pragma once

#include "world/scene/light_categories.h"
#include "world/scene/scene_state.h"
#include "world/scene/shape_builder.h"

namespace candela {

/// Its steps in the order of their calls.
class LightBuilder {
public:
    LightBuilder(SceneState &, ShaderLibrary &);

    void declare(const std::vector<std::shared_ptr<const LightRecord>> &);
    /// Gives area lights their geometry and shining shapes their lights.
    void attachShapes(const RayGeometry &);
    /// Tells every code which lights its loops hear.
    void bindCategories(const ShaderLibrary &);
    /// Asks every light how much it sends, and prepares the choice among them for each light set.
    void prepareChoices();

private:
    struct PlacedShape {
        std::uint32_t instance, shape;
        std::int32_t appearance;
        const RayShape &mesh;
    };
    void attach(const PlacedShape &);
    void addElements(int light, const PlacedShape &);
    /// Makes sources of the elements from `first` on.
    void addSources(int light, const PlacedShape &, std::int32_t first);
    bool addSingly(int light, std::int32_t first, bool pair);
    void addPoint(int light);
    void addSource(int light, std::span<const std::int32_t> members);
    void finishLights();
    void finishGeometry(int light);
    std::vector<EmitterBound> boundsOfSources() const;
    LightChoice choiceOf(int lightSet, LightGroup, std::span<const EmitterBound>,
                         std::span<const std::uint8_t> wide, const SurroundingLight &dome) const;
    /// For Lights::setOfAll(); a set that is there already serves.
    void addSetOfAll();
    void fillSwitches();
    bool isPlain(const SceneLight &, int surfaceCode) const;

    SceneState &state_;
    ShaderLibrary &library_;
    std::vector<LightTags> tags_;
    std::vector<std::vector<LightSource>> sources_;      ///< By light.
    std::vector<std::vector<std::int32_t>> appearances_; ///< By light: those of its shapes.
    std::vector<std::int32_t> lightOfElement_;
};

} // namespace candela

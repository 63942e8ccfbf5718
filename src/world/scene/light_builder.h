// SPDX-License-Identifier: Apache-2.0
// Light records and emitting primitives become the scene's lights.
#pragma once

#include "world/scene/light_categories.h"
#include "world/scene/scene_state.h"

namespace candela {

/// Its steps in the order of their calls.
class LightBuilder {
public:
    LightBuilder(SceneState &, ShaderLibrary &);

    void declare(const std::vector<std::shared_ptr<const LightRecord>> &);
    /// Gives area lights their geometry and emitting primitives their lights.
    void attachAreas(const std::vector<RayMesh> &);
    /// Tells every code which lights its loops hear.
    void bindCategories(const ShaderLibrary &);
    /// Asks every light, 256 times, how much it sends; sets the probabilities of choice.
    void estimatePowers();

private:
    void addTriangles(int light, std::uint32_t primitive, const RayMesh &);
    void finishArea(int light);
    void fillSwitches();

    SceneState &state_;
    ShaderLibrary &library_;
    std::vector<LightTags> tags_;
    std::vector<std::vector<double>> areas_; ///< By light: areas of its triangles.
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What rays are to meet, from diced shapes, their instances and how these look.
#pragma once

#include "world/scene/appearance_builder.h"
#include "world/scene/solid_bodies.h"

#include <span>
#include <vector>

namespace candela {

/// RayWorld's arguments.
struct RayGeometry {
    RayObject world;
    std::vector<RayObject> objects;
    std::vector<RayInstance> instances;
    PlacedBodies solids;
};

/// `meshes` and `shapeCounts`, how many shapes an instance has, go by PointTables::shapes and
/// instances; the appearances are complete.
RayGeometry arrange(std::vector<RayShape> meshes, std::span<const std::uint32_t> shapeCounts,
                    const PointTables &, const AppearanceBuilder &);

/// The scene's extent and its statistics.
void measure(const std::vector<RayShape> &meshes, std::span<const std::uint32_t> shapeCounts,
             SceneState &);

} // namespace candela

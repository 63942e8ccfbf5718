// SPDX-License-Identifier: Apache-2.0
#include "world/scene/ray_geometry.h"

#include "world/shapes/dice_rate.h"

#include <algorithm>
#include <bit>
#include <map>

namespace candela {

namespace {

/// How rays meet what looks so.
void dress(RayShape &shape, std::int32_t index, const PointTables &points,
           const AppearanceBuilder &looks) {
    const ShadowCasting casting = shadowCasting(*points.details[index].attributes);
    const Visibility &visible = points.details[index].visibility;
    shape.stopsLight = casting != ShadowCasting::None && visible.shadow;
    shape.hiddenFrom = std::uint8_t((visible.camera ? 0 : ray_kind::camera) |
                                    (visible.diffuse ? 0 : ray_kind::diffuse) |
                                    (visible.specular ? 0 : ray_kind::specular));
    shape.presentFrom = points.details[index].presence.from;
    shape.presentUntil = points.details[index].presence.until;
    shape.opaque = casting == ShadowCasting::Opaque || looks.isOpaque(index);
    const Shape &met = points.shapes[looks.shapes()[index]];
    shape.isStroke = met.surface->isStroke();
    if (shape.isStroke) // Opaque ones end rays where they come in.
        shape.frontSign = shape.opaque ? 0 : met.elementSign < 0 ? -1 : 1;
    else if (points.details[index].attributes->sides == 1)
        shape.frontSign = points.appearances[index].elementSign < 0 ? -1 : 1;
}

} // namespace

RayGeometry arrange(std::vector<RayShape> meshes, std::span<const std::uint32_t> shapeCounts,
                    const PointTables &points, const AppearanceBuilder &looks) {
    RayGeometry geometry;
    for (std::uint32_t i = 0; i < points.worldShapes; ++i) {
        dress(meshes[i], std::int32_t(i), points, looks);
        geometry.world.push_back(std::move(meshes[i]));
    }
    // Objects that rays meet differently (opacity, one-sidedness) are objects of their own.
    std::map<std::vector<std::int32_t>, std::uint32_t> variants;
    const auto bits = [](float share) { return std::bit_cast<std::int32_t>(share); };
    for (std::size_t i = 0; i < points.instances.size(); ++i) {
        const Instance &instance = points.instances[i];
        RayObject object;
        std::vector<std::int32_t> key{std::int32_t(instance.firstShape)};
        for (std::uint32_t k = 0; k < shapeCounts[i]; ++k) {
            RayShape met;
            dress(met, instance.firstAppearance + std::int32_t(k), points, looks);
            key.push_back(met.hiddenFrom * 16 + met.stopsLight * 8 + met.opaque * 4 +
                          met.frontSign);
            key.push_back(bits(met.presentFrom)), key.push_back(bits(met.presentUntil));
            object.push_back(std::move(met));
        }
        auto [place, isNew] =
            variants.try_emplace(std::move(key), std::uint32_t(geometry.objects.size()));
        if (isNew) {
            for (std::uint32_t k = 0; k < shapeCounts[i]; ++k) {
                RayShape mesh = meshes[instance.firstShape + k];
                mesh.opaque = object[k].opaque, mesh.stopsLight = object[k].stopsLight;
                mesh.frontSign = object[k].frontSign, mesh.isStroke = object[k].isStroke;
                mesh.hiddenFrom = object[k].hiddenFrom;
                mesh.presentFrom = object[k].presentFrom;
                mesh.presentUntil = object[k].presentUntil;
                object[k] = std::move(mesh);
            }
            geometry.objects.push_back(std::move(object));
        }
        RayInstance placed{place->second, instance.firstShape, {}, {}};
        std::copy_n(points.matricesOf(std::uint32_t(i)), 16, placed.currentFromObject.m.begin());
        placed.steps = points.stepsOf(std::uint32_t(i));
        geometry.instances.push_back(placed);
    }
    return geometry;
}

void measure(const std::vector<RayShape> &meshes, std::span<const std::uint32_t> shapeCounts,
             SceneState &state) {
    const PointTables &points = state.points;
    Box3 box;
    std::vector<Box3> own(meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const RayShape &mesh = meshes[i];
        for (Vec3 position : mesh.positions)
            own[i].add(position);
        mesh.round.forSteps([&](const auto &knots) {
            for (const auto &[x, y, z, r] : knots)
                own[i].add(Vec3{x - r, y - r, z - r}), own[i].add(Vec3{x + r, y + r, z + r});
        });
        for (const std::vector<Vec3> &positions : mesh.later)
            for (Vec3 position : positions)
                own[i].add(position);
        state.statistics.triangles += mesh.triangles.size();
        if (i < points.worldShapes && !own[i].empty())
            box.add(own[i]);
    }
    for (std::size_t i = 0; i < points.instances.size(); ++i) {
        Matrix4 still;
        std::copy_n(points.matricesOf(std::uint32_t(i)), 16, still.m.begin());
        const std::span<const Matrix4> steps = points.stepsOf(std::uint32_t(i));
        for (const Matrix4 &currentFromObject : steps.empty() ? std::span(&still, 1) : steps)
            for (std::uint32_t k = 0; k < shapeCounts[i]; ++k)
                if (const Box3 &part = own[points.instances[i].firstShape + k]; !part.empty())
                    box.add(transformBox(currentFromObject, part));
    }
    state.statistics.primitives = meshes.size();
    state.statistics.instances = points.instances.size();
    state.bound = box;
    if (!box.empty()) {
        state.centre = box.centre();
        state.radius = std::max(length(box.extent()) / 2, 1e-6f);
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/placement_details.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

Box3 boundOf(const DeclaredGroup &object, const Shutter &shutter) {
    DiagnosticList silent; // It is reported when shapes are made in earnest.
    Box3 bound;
    for (const DeclaredPrimitive &primitive : object.primitives)
        for (auto &surface : makeSurfaces(primitive.record, *primitive.attributes, shutter, silent))
            bound.add(transformBox(primitive.outerFromPrimitive, surface->bound()));
    return bound;
}

} // namespace

std::vector<PlacementDetail> detailsOf(std::span<const Placement> placements,
                                       const std::vector<int> &timesPlaced,
                                       const DeclaredWorld &declared, const DicingPlan &plan) {
    std::vector<Box3> bounds(timesPlaced.size());
    for (std::size_t object = 0; object < bounds.size(); ++object)
        if (timesPlaced[object] > 1)
            bounds[object] = boundOf(declared.objects[object], declared.shutter);
    std::vector<PlacementDetail> details(placements.size());
    std::vector<float> finest(bounds.size(), INFINITY);
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const Placement &placement = placements[i];
        if (timesPlaced[placement.object] <= 1)
            continue;
        details[i].pixel = plan.nearestPixel(bounds[placement.object], placement.currentFromObject);
        for (const Matrix4 &step : placement.steps)
            details[i].pixel =
                std::min(details[i].pixel, plan.nearestPixel(bounds[placement.object], step));
        finest[placement.object] = std::min(finest[placement.object], details[i].pixel);
    }
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const float least = finest[placements[i].object], ratio = details[i].pixel / least;
        details[i].level = ratio < 8 ? 0 : ratio < 64 ? 1 : 2;
        details[i].pixel = least * std::ldexp(1.0f, 3 * details[i].level);
    }
    return details;
}

} // namespace candela

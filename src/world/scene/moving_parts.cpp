// SPDX-License-Identifier: Apache-2.0
#include "world/scene/moving_parts.h"

#include "foundation/base/motion_steps.h"

#include <algorithm>

namespace candela {

namespace {

/// Calls body(primitives) for each of the sets of the group's primitives that move together and are
/// of one solid.
template <class Body>
void forTogether(const DeclaredWorld &declared, const DeclaredGroup &group, Body body) {
    std::vector<std::vector<const DeclaredPrimitive *>> sets;
    for (const DeclaredPrimitive &primitive : group.primitives) {
        if (!primitive.motion)
            continue;
        // What moves together mostly stands together.
        const bool same = !sets.empty() &&
                          sets.back().front()->motion->movesLike(*primitive.motion) &&
                          declared.solids.outermost(sets.back().front()->solid.node) ==
                              declared.solids.outermost(primitive.solid.node);
        if (!same)
            sets.emplace_back();
        sets.back().push_back(&primitive);
    }
    for (const auto &set : sets)
        body(set);
}

} // namespace

std::vector<MovingGroup> movingGroupsOf(const DeclaredWorld &declared) {
    std::vector<MovingGroup> groups;
    forTogether(
        declared, declared.world, [&](const std::vector<const DeclaredPrimitive *> &primitives) {
            const TransformMotion &motion = *primitives.front()->motion;
            const std::optional<Matrix4d> fromOpen = inverse(motion.at(declared.shutter.open));
            if (!fromOpen) // Reported.
                return;
            std::vector<double> times;
            motion.addTimes(times);
            const auto moved = [&](double time) { return *fromOpen * motion.at(time); };
            groups.push_back({primitives, motionSteps(moved, times, declared.shutter)});
        });
    return groups;
}

std::vector<Matrix4> stepsFromOpen(std::span<const Matrix4> steps) {
    const Matrix4d objectFromOpen = inverse(inDouble(steps.front())).value_or(Matrix4d{});
    std::vector<Matrix4> relative;
    for (const Matrix4 &step : steps)
        relative.push_back((objectFromOpen * inDouble(step)).rounded());
    return relative;
}

void separateMovingParts(DeclaredWorld &declared) {
    const std::size_t objects = declared.objects.size();
    const auto asTheObject = std::make_shared<const Attributes>();
    for (std::size_t number = 0; number < objects; ++number) {
        std::vector<DeclaredGroup> parts;
        std::vector<DeclaredInstance> places;
        forTogether(declared, declared.objects[number], [&](const auto &primitives) {
            const TransformMotion &motion = *primitives.front()->motion;
            const auto still = inverse(motion.inner());
            if (!still) // Reported.
                return;
            DeclaredGroup part;
            for (const DeclaredPrimitive *primitive : primitives)
                part.primitives.push_back({primitive->record, primitive->attributes,
                                           primitive->motion->inner().rounded(), nullptr,
                                           primitive->solid});
            const auto frame = motion.after(*still);
            places.push_back({int(objects + parts.size()),
                              asTheObject,
                              false,
                              frame->at(declared.shutter.open).rounded(),
                              frame,
                              {}});
            parts.push_back(std::move(part));
        });
        DeclaredGroup &object = declared.objects[number];
        std::erase_if(object.primitives,
                      [](const DeclaredPrimitive &primitive) { return primitive.motion; });
        for (DeclaredInstance &place : places)
            place.object += int(declared.objects.size() - objects);
        object.instances.insert(object.instances.end(), places.begin(), places.end());
        for (DeclaredGroup &part : parts)
            declared.objects.push_back(std::move(part));
    }
}

} // namespace candela

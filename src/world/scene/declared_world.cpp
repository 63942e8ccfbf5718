// SPDX-License-Identifier: Apache-2.0
#include "world/scene/declared_world.h"

#include "foundation/base/motion_steps.h"

#include <algorithm>
#include <utility>

namespace candela {

void DeclaredWorld::beginObject(int number) {
    openObject_ = int(objects.size());
    objects.emplace_back();
    objectOfNumber[number] = openObject_;
}

void DeclaredWorld::endObject() {
    openObject_ = -1;
    openParts_.clear();
}

DeclaredGroup &DeclaredWorld::openFor(const std::shared_ptr<const Attributes> &attributes) {
    if (openObject_ < 0 || attributes->ownSet == 0)
        return open();
    const auto [part, isNew] = openParts_.try_emplace(attributes.get(), int(objects.size()));
    if (isNew) {
        objects.emplace_back();
        objects[openObject_].instances.push_back(
            {part->second, attributes, false, Matrix4{}, nullptr});
    }
    return objects[part->second];
}

namespace {

/// Instances within each other, the outermost first.
using Chain = std::vector<const DeclaredInstance *>;

/// Over the shutter's interval; empty if all stand still.
std::vector<Matrix4> stepsOf(const Chain &chain, const Shutter &shutter) {
    std::vector<double> times;
    for (const DeclaredInstance *instance : chain)
        if (instance->motion)
            instance->motion->addTimes(times);
    if (times.empty())
        return {};
    const auto currentFromObject = [&](double time) {
        Matrix4d whole;
        for (const DeclaredInstance *instance : chain)
            whole = (instance->motion ? instance->motion->at(time)
                                      : inDouble(instance->outerFromObject)) *
                    whole;
        return whole;
    };
    std::vector<Matrix4> steps = motionSteps(currentFromObject, times, shutter);
    return steps.size() > 1 ? steps : std::vector<Matrix4>{};
}

bool allInvertible(const Placement &placement) {
    return inverse(placement.currentFromObject).has_value() &&
           std::ranges::all_of(placement.steps,
                               [](const Matrix4 &step) { return inverse(step).has_value(); });
}

class Placing {
public:
    Placing(const DeclaredWorld &declared, std::vector<Placement> &placements)
        : declared_(declared), placements_(placements) {}

    /// Places what the group instances, the group itself standing as `around` says.
    void place(const DeclaredGroup &group, const Placement &around) {
        for (const DeclaredInstance &instance : group.instances) {
            Placement placement = around;
            placement.object = instance.object;
            placement.attributes = attributesOf(instance, around.attributes);
            placement.turned = around.turned != instance.turns;
            placement.currentFromObject = instance.outerFromObject * around.currentFromObject;
            chain_.push_back(&instance);
            const DeclaredGroup &object = declared_.objects[instance.object];
            if (!object.primitives.empty()) {
                placement.steps = stepsOf(chain_, declared_.shutter);
                if (allInvertible(placement))
                    placements_.push_back(placement);
                placement.steps.clear();
            }
            place(object, placement);
            chain_.pop_back();
        }
    }

private:
    using Shared = std::shared_ptr<const Attributes>;

    /// The instance around it decides, but for what the object has set itself.
    Shared attributesOf(const DeclaredInstance &instance, const Shared &around) {
        if (!around)
            return instance.attributes;
        if (instance.attributes->ownSet == 0)
            return around;
        Shared &merged = merged_[{around.get(), instance.attributes.get()}];
        if (!merged)
            merged =
                std::make_shared<const Attributes>(attributesOfPart(*around, *instance.attributes));
        return merged;
    }

    const DeclaredWorld &declared_;
    std::vector<Placement> &placements_;
    Chain chain_; ///< Of what is being placed.
    std::map<std::pair<const Attributes *, const Attributes *>, Shared> merged_;
};

} // namespace

std::vector<Placement> placementsOf(const DeclaredWorld &declared) {
    std::vector<Placement> placements;
    Placing(declared, placements).place(declared.world, {-1, nullptr, false, Matrix4{}, {}});
    return placements;
}

} // namespace candela

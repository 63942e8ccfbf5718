// SPDX-License-Identifier: Apache-2.0
#include "world/scene/declared_world.h"

#include "foundation/base/motion_steps.h"

#include <algorithm>
#include <utility>

namespace candela {

void DeclaredWorld::beginObject(int number) {
    openObject_ = int(objects.size());
    solids.beginGroup(openObject_);
    objects.emplace_back();
    objectOfNumber[number] = openObject_;
}

void DeclaredWorld::endObject() {
    openObject_ = -1;
    solids.endGroup();
    openParts_.clear();
}

DeclaredGroup &DeclaredWorld::openFor(const std::shared_ptr<const Attributes> &attributes,
                                      const SolidPlace &place) {
    if (openObject_ < 0 || (attributes->ownSet == 0 && place.node < 0))
        return open();
    const auto [part, isNew] = openParts_.try_emplace(
        {attributes->ownSet == 0 ? nullptr : attributes.get(), solids.outermost(place.node)},
        int(objects.size()));
    if (isNew) {
        objects.emplace_back();
        objects[openObject_].instances.push_back(
            {part->second, attributes, false, Matrix4{}, nullptr, {}});
    }
    return objects[part->second];
}

template <class Do> void DeclaredWorld::forGroups(Do work) {
    work(world);
    for (DeclaredGroup &object : objects)
        work(object);
}

void DeclaredWorld::letGoOfInstances() {
    forGroups([](DeclaredGroup &group) { group.instances = {}; });
}

void DeclaredWorld::letGoOfRecords() {
    forGroups([](DeclaredGroup &group) {
        for (DeclaredPrimitive &primitive : group.primitives)
            primitive.record.reset();
    });
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
    Placing(const DeclaredWorld &declared, Placements &placements)
        : declared_(declared), placements_(placements),
          solids_(declared.solids, placements.solids) {}

    void placeWorld() {
        const SolidsOfGroup::Visit visit = solids_.visit(DeclaredSolids::world, -1);
        if (!declared_.solids.empty())
            addNodes(declared_.world);
        place(declared_.world, {-1, nullptr, false, Matrix4{}, {}, -1}, -1);
    }

private:
    using Shared = std::shared_ptr<const Attributes>;

    void addNodes(const DeclaredGroup &group) {
        for (const DeclaredPrimitive &primitive : group.primitives)
            placements_.nodes.push_back(solids_.nodeOf(primitive.solid.node));
    }

    /// Places what the group instances, the group itself standing as `around` says and being of the
    /// body `node`.
    void place(const DeclaredGroup &group, const Placement &around, std::int32_t node) {
        for (const DeclaredInstance &instance : group.instances) {
            Placement placement = around;
            placement.object = instance.object;
            placement.attributes = attributesOf(instance, around.attributes);
            placement.turned = around.turned != instance.turns;
            placement.currentFromObject = instance.outerFromObject * around.currentFromObject;
            chain_.push_back(&instance);
            const std::int32_t own =
                instance.solid.node < 0 ? node : solids_.nodeOf(instance.solid.node);
            const SolidsOfGroup::Visit visit = solids_.visit(instance.object, own);
            const DeclaredGroup &object = declared_.objects[instance.object];
            if (!object.primitives.empty()) {
                placement.steps = stepsOf(chain_, declared_.shutter);
                if (allInvertible(placement))
                    add(placement, object);
                placement.steps.clear();
            }
            place(object, placement, own);
            chain_.pop_back();
        }
    }

    void add(Placement &placement, const DeclaredGroup &object) {
        placement.firstNode = -1;
        if (!declared_.solids.empty()) {
            const std::size_t first = placements_.nodes.size();
            addNodes(object);
            if (std::all_of(placements_.nodes.begin() + std::ptrdiff_t(first),
                            placements_.nodes.end(), [](std::int32_t node) { return node < 0; }))
                placements_.nodes.resize(first);
            else
                placement.firstNode = std::int64_t(first);
        }
        placements_.all.push_back(placement);
    }

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
    Placements &placements_;
    SolidsOfGroup solids_;
    Chain chain_; ///< Of what is being placed.
    std::map<std::pair<const Attributes *, const Attributes *>, Shared> merged_;
};

} // namespace

Placements placementsOf(const DeclaredWorld &declared) {
    Placements placements;
    Placing(declared, placements).placeWorld();
    const std::vector<bool> ofSeveral = placements.solids.ofSeveral();
    for (std::int32_t &node : placements.nodes)
        if (node >= 0 && !ofSeveral[std::size_t(node)]) // A body that nothing cuts is no solid.
            node = -1;
    return placements;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/declared_world.h"

namespace candela {

/// Places what the group instances, the group itself standing as `around` says.
static void place(const DeclaredWorld &declared, const DeclaredGroup &group,
                  const Placement &around, std::vector<Placement> &placements) {
    for (const DeclaredInstance &instance : group.instances) {
        Placement placement = around;
        placement.object = instance.object;
        if (!around.attributes)
            placement.attributes = instance.attributes;
        placement.turned = around.turned != instance.attributes->flipNormal;
        placement.currentFromObject = instance.outerFromObject * around.currentFromObject;
        const DeclaredGroup &object = declared.objects[instance.object];
        if (!object.primitives.empty() && inverse(placement.currentFromObject))
            placements.push_back(placement);
        place(declared, object, placement, placements);
    }
}

std::vector<Placement> placementsOf(const DeclaredWorld &declared) {
    std::vector<Placement> placements;
    place(declared, declared.world, {-1, nullptr, false, Matrix4{}}, placements);
    return placements;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/declared_world.h"

#include <cstddef>

namespace candela {

namespace {

/// Objects that instance objects multiply: this is more than memory holds.
constexpr std::size_t mostPlacements = 16'000'000;

class Placer {
public:
    Placer(const DeclaredWorld &declared, DiagnosticSink &sink)
        : declared_(declared), sink_(sink) {}

    /// Places what the group instances, the group itself standing as `around` says.
    void place(const DeclaredGroup &group, const Placement &around) {
        for (const DeclaredInstance &instance : group.instances) {
            if (placements.size() >= mostPlacements)
                return reportTooMany();
            Placement placement = around;
            placement.object = instance.object;
            if (!around.attributes)
                placement.attributes = instance.attributes;
            placement.turned = around.turned != instance.attributes->flipNormal;
            placement.currentFromObject = instance.outerFromObject * around.currentFromObject;
            const DeclaredGroup &object = declared_.objects[instance.object];
            if (!object.primitives.empty() && inverse(placement.currentFromObject))
                placements.push_back(placement);
            place(object, placement);
        }
    }

    std::vector<Placement> placements;

private:
    void reportTooMany() {
        if (!reported_)
            sink_.error({}, "objects within objects come to more than " +
                                std::to_string(mostPlacements) +
                                " instances; the rest is left out");
        reported_ = true;
    }

    const DeclaredWorld &declared_;
    DiagnosticSink &sink_;
    bool reported_ = false;
};

} // namespace

std::vector<Placement> placementsOf(const DeclaredWorld &declared, DiagnosticSink &sink) {
    Placer placer(declared, sink);
    placer.place(declared.world, {-1, nullptr, false, Matrix4{}});
    return std::move(placer.placements);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/heard_lights.h"

#include <map>
#include <utility>

namespace candela {

namespace {

using Switches = std::vector<std::uint8_t>;

/// Ambient lights are not drawn, and no category concerns them.
Switches heardOf(const LightTable &table, Switches on, const ShaderCode &code) {
    for (std::size_t light = 0; light < table.lights.size(); ++light)
        if (on[light + 1] && table.lights[light].isSampled() &&
            !code.categories().hears(std::int32_t(light) + 1))
            on[light + 1] = 0;
    return on;
}

} // namespace

void leaveOutRefusedLights(SceneState &state) {
    LightTable &table = state.lights;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known; // Of set and code.
    std::map<Switches, std::int32_t> sets;
    for (std::size_t set = 0; set < table.isOn.size(); ++set)
        sets.try_emplace(table.isOn[set], std::int32_t(set));
    for (Appearance &appearance : state.points.appearances) {
        auto [place, isNew] = known.try_emplace({appearance.lightSet, appearance.code}, 0);
        if (isNew) {
            const Switches heard = heardOf(table, table.isOn[appearance.lightSet],
                                           *state.points.codes[appearance.code].code);
            auto [set, isNewSet] = sets.try_emplace(heard, std::int32_t(table.isOn.size()));
            place->second = set->second;
            if (isNewSet) {
                table.isOn.push_back(heard);
                state.lightSets.push_back(state.lightSets[appearance.lightSet]);
            }
        }
        appearance.lightSet = place->second;
    }
}

} // namespace candela

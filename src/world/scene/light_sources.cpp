// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_sources.h"

#include <algorithm>
#include <map>

namespace candela {

int chooseByCumulative(std::span<const double> cumulative, double &sample) {
    if (cumulative.size() == 1)
        return 0;
    auto place = std::upper_bound(cumulative.begin(), cumulative.end(), sample);
    if (place == cumulative.end())
        --place;
    double below = place == cumulative.begin() ? 0 : place[-1];
    // Entries without a share can only be reached by rounding at the end of the table.
    while (*place <= below && place != cumulative.begin()) {
        --place;
        below = place == cumulative.begin() ? 0 : place[-1];
    }
    sample = std::clamp((sample - below) / (*place - below), 0.0, 0x1.fffffffffffffp-1);
    return int(place - cumulative.begin());
}

std::int32_t LightTable::drawElement(const LightSource &source, float &sample) const {
    if (source.members == 1)
        return members[source.firstMember];
    double rest = sample;
    const int member = chooseByCumulative(
        {memberShares.data() + source.firstMember, std::size_t(source.members)}, rest);
    sample = std::min(float(rest), 0x1.fffffep-1f);
    return members[source.firstMember + member];
}

void LightTable::number() {
    std::map<std::pair<LightKind, const ShaderCode *>, int> batchOf;
    ambient.clear();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        SceneLight &light = lights[i];
        if (light.kind == LightKind::Ambient)
            ambient.push_back(int(i));
        if (light.isSampled()) // Numbered in the order of first use, never by address.
            light.batch =
                batchOf.try_emplace({light.kind, light.shader.code.get()}, int(batchOf.size()))
                    .first->second;
    }
    batches = int(batchOf.size());
}

} // namespace candela

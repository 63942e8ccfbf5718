// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_table.h"

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

void LightTable::finish() {
    auto sampled = [](const SceneLight &light) {
        return light.kind != LightKind::None && light.kind != LightKind::Ambient;
    };
    double total = 0;
    int count = 0;
    for (const SceneLight &light : lights)
        if (sampled(light))
            total += light.power, ++count;

    // The estimate of a narrow beam may be zero: a twentieth of the samples goes to all alike.
    const double evenShare = total > 0 ? 0.05 : 1;
    std::map<std::pair<LightKind, const ShaderCode *>, int> batchOf;
    double sum = 0;
    ambient.clear(), cumulative.clear();
    for (std::size_t i = 0; i < lights.size(); ++i) {
        SceneLight &light = lights[i];
        if (light.kind == LightKind::Ambient)
            ambient.push_back(int(i));
        light.probability = 0;
        if (sampled(light)) {
            double byPower = total > 0 ? light.power / total : 0;
            sum += evenShare / count + (1 - evenShare) * byPower;
            light.probability = float(evenShare / count + (1 - evenShare) * byPower);
            // Numbered in the order of first use, never by address.
            light.batch =
                batchOf.try_emplace({light.kind, light.shader.code.get()}, int(batchOf.size()))
                    .first->second;
        }
        cumulative.push_back(sum);
    }
    batches = int(batchOf.size());
    only = -1;
    for (std::size_t i = 0; i < lights.size() && count == 1; ++i)
        if (sampled(lights[i]))
            only = int(i);
    if (sum > 0)
        for (double &share : cumulative)
            share /= sum;
}

} // namespace candela

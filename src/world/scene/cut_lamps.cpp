// SPDX-License-Identifier: Apache-2.0
#include "world/scene/cut_lamps.h"

#include "world/scene/light_question.h"

#include <algorithm>

namespace candela {

bool findCutAway(const SceneState &state, const ElementRows &rows, const SourcePoints &drawn,
                 const float *time, std::uint8_t *isThere) {
    if (!state.rays->hasSolids())
        return false;
    bool any = false;
    for (int i = 0; i < rows.count; ++i) {
        isThere[i] = 1;
        if (LightElement::Form(rows.form[i]) == LightElement::Form::NoShape ||
            !state.rays->isCut(rows.instance[i], rows.shape[i]))
            continue;
        const Vec3 P{drawn.point[0][i], drawn.point[1][i], drawn.point[2][i]};
        const Vec3 normal{drawn.normal[0][i], drawn.normal[1][i], drawn.normal[2][i]};
        isThere[i] = state.rays->isLeftOver(rows.instance[i], rows.shape[i], P, normal,
                                            rows.offset[i], time[i]);
        any |= isThere[i] == 0;
    }
    return any;
}

void measureCutLamps(SceneState &state) {
    if (!state.rays->hasSolids())
        return;
    constexpr int samples = 64 * lightBatchSize;
    for (SceneLight &light : state.lights.lights) {
        if (light.kind != LightKind::ClassicArea)
            continue;
        ElementRows rows(lightBatchSize);
        SourcePoints drawn(lightBatchSize);
        std::vector<std::int32_t> source(lightBatchSize);
        std::vector<float> u(lightBatchSize), v(lightBatchSize);
        const std::vector<float> time(lightBatchSize, state.camera.shutterOpen());
        std::vector<std::uint8_t> isThere(lightBatchSize);
        int left = 0;
        for (int first = 0; first < samples; first += lightBatchSize) {
            for (int i = 0; i < lightBatchSize; ++i) {
                // Points of a rank-1 lattice (Roberts).
                const auto along = [&](double step) {
                    const double sum = (first + i + 0.5) * step;
                    return sum - std::floor(sum);
                };
                double choice = (first + i + 0.5) / samples;
                source[i] = light.firstSource + chooseByCumulative(light.cumulative, choice);
                u[i] = float(along(0.7548776662)), v[i] = float(along(0.5698402910));
            }
            rows.draw(state.lights, lightBatchSize, source.data(), u.data());
            placeOnElements(rows, rows.u, v.data(), drawn);
            if (!findCutAway(state, rows, drawn, time.data(), isThere.data()))
                left += lightBatchSize;
            else
                left += int(std::ranges::count(isThere, 1));
        }
        light.areaLeft = light.area * left / samples;
    }
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "world/scene/absent_lamps.h"

#include "world/scene/light_question.h"

#include <cmath>

namespace candela {

static bool isCutAway(const SceneState &state, const ElementRows &rows, const SourcePoints &drawn,
                      int i, float time) {
    const Vec3 P{drawn.point[0][i], drawn.point[1][i], drawn.point[2][i]};
    const Vec3 normal{drawn.normal[0][i], drawn.normal[1][i], drawn.normal[2][i]};
    const RayWorld &rays = *state.rays;
    for (const ClippingPlane &plane : rays.clippingPlanes())
        if (plane.hides(P))
            return true;
    return rays.isCut(rows.instance[i], rows.shape[i]) &&
           !rays.isLeftOver(rows.instance[i], rows.shape[i], P, normal, rows.offset[i], time);
}

static bool isDissolved(const SceneState &state, const ElementRows &rows, int i, float time) {
    const PointTables &points = state.points;
    const auto &[from, until] =
        points.details[std::size_t(points.appearanceOf(rows.instance[i], rows.shape[i]))].presence;
    const float choice = choiceOf(state.camera.shutter().share(time), state.rays->moves());
    return choice < from || choice >= until;
}

bool findAbsent(const SceneState &state, const ElementRows &rows, const SourcePoints &drawn,
                const float *time, std::uint8_t *isThere) {
    const bool cuts = state.rays->hasSolids() || !state.rays->clippingPlanes().empty();
    if (!cuts && !state.dissolves)
        return false;
    bool any = false;
    for (int i = 0; i < rows.count; ++i) {
        const bool hasShape = LightElement::Form(rows.form[i]) != LightElement::Form::NoShape;
        isThere[i] = !hasShape || !((state.dissolves && isDissolved(state, rows, i, time[i])) ||
                                    (cuts && isCutAway(state, rows, drawn, i, time[i])));
        any |= isThere[i] == 0;
    }
    return any;
}

void measureCutLamps(SceneState &state) {
    if (!state.rays->hasSolids() && state.rays->clippingPlanes().empty())
        return;
    constexpr int samples = 64 * lightBatchSize;
    for (SceneLight &light : state.lights.lights) {
        if (light.kind != LightKind::ClassicArea)
            continue;
        ElementRows rows(lightBatchSize);
        SourcePoints drawn(lightBatchSize);
        std::vector<std::int32_t> source(lightBatchSize);
        std::vector<float> u(lightBatchSize), v(lightBatchSize);
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
            for (int i = 0; i < lightBatchSize; ++i)
                left += !isCutAway(state, rows, drawn, i, state.camera.shutterOpen());
        }
        light.areaLeft = light.area * left / samples;
    }
}

} // namespace candela

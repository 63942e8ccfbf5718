// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_shading.h"

#include <algorithm>

namespace candela {

void meetDrawn(const SceneState &state, const SurfaceCode &code, const SourcePoints &drawn,
               int count, const std::int32_t *lanes, ShadingPoints &points) {
    points.count = count;
    for (int k = 0; k < count; ++k) {
        const int i = lanes ? lanes[k] : k;
        const LightElement &element = state.lights.elements[drawn.element[i]];
        points.instance[k] = element.instance, points.shape[k] = element.shape;
        points.element[k] = element.element;
        points.u[k] = drawn.u[i], points.v[k] = drawn.v[i];
        for (int c = 0; c < 3; ++c) {
            points.input(ShaderInput::P, c)[k] = drawn.point[c][i];
            points.input(ShaderInput::Ng, c)[k] = drawn.normal[c][i];
            points.input(ShaderInput::E, c)[k] = 0;
        }
    }
    evaluatePoints(state.points, state.camera, code, nullptr, points);
}

} // namespace candela

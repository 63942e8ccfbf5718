// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/texture_defaults.h"

namespace candela {

int addDefault(const char *name, std::vector<VariableInfo> &infos) {
    if (std::ranges::find(infos, name, &VariableInfo::name) != infos.end())
        return -1;
    infos.push_back({name, {StorageClass::Varying, ValueType::Float, 1}});
    return int(infos.size() - 1);
}

void evaluateDefault(const std::array<float, 8> &textureCoordinates, int component, int count,
                     const float *u, const float *v, float *const *value, float *const *valueDu,
                     float *const *valueDv) {
    const float *corner = textureCoordinates.data() + component;
    const float lowStep = corner[2] - corner[0], highStep = corner[6] - corner[4];
    for (int k = 0; k < count; ++k) {
        const float low = corner[0] + u[k] * lowStep, high = corner[4] + u[k] * highStep;
        if (value)
            value[0][k] = low + v[k] * (high - low);
        if (valueDu)
            valueDu[0][k] = lowStep + v[k] * (highStep - lowStep);
        if (valueDv)
            valueDv[0][k] = high - low;
    }
}

} // namespace candela

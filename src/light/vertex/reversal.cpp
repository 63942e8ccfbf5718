// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/reversal.h"

#include <algorithm>
#include <cmath>

namespace candela {

/// What two floats of rounding turn a direction by, and a bit more.
constexpr float mostTurn = 1e-3f;

void reversals(int count, const PreparedSurface &view, const ConstVec3Planes &back, float *passes,
               std::int32_t *request) {
    std::fill_n(passes, count, 0.0f);
    for (const ConePlanes &cone : view.cones)
        for (int i = 0; cone.first && i < count; ++i) {
            if (passes[i] > 0 || cone.kindAngle[i] > 0 || !(cone.importance[i] > 0))
                continue;
            const Vec3 along = normalize(Vec3{cone.axis[0][i], cone.axis[1][i], cone.axis[2][i]});
            const Vec3 apart = along - Vec3{back[0][i], back[1][i], back[2][i]};
            if (!(dot(apart, apart) < mostTurn * mostTurn))
                continue;
            passes[i] = 1;
            if (request)
                request[i] = cone.request;
        }
}

} // namespace candela

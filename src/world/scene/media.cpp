// SPDX-License-Identifier: Apache-2.0
#include "world/scene/media.h"

namespace candela {

/// Which of the bodies is the innermost of that medium; -1 = none.
int MediaAround::depthOf(std::int32_t medium) const {
    for (int k = 0; k < bodies; ++k)
        if (body(k) == medium)
            return k;
    return -1;
}

void MediaAround::enter(std::int32_t medium) {
    for (int k = bodies - 1; k > 0; --k)
        set(k, body(k - 1));
    set(0, medium);
}

/// A body may have one Interior at one face and another at the next: then it is the innermost.
void MediaAround::leave(std::int32_t medium) {
    const int depth = depthOf(medium);
    for (int k = depth < 0 ? 0 : depth; k < bodies; ++k)
        set(k, k + 1 < bodies ? body(k + 1) : 0);
}

MediaAround MediaAround::beyond(const SurfaceMedia &surface, bool fromInside, bool toInside) const {
    MediaAround result = *this;
    if (toInside) {
        // Who was inside before, where the camera stands in a body, has not entered it.
        const bool isIn = fromInside && depthOf(surface.interior) >= 0;
        if (surface.interior != 0 && !isIn)
            result.enter(surface.interior);
        return result;
    }
    if (fromInside && surface.interior != 0)
        result.leave(surface.interior);
    const bool isSheet = surface.interior == 0 && surface.exterior == 0;
    if (!(fromInside && isSheet))
        result.set(bodies, surface.exterior);
    return result;
}

} // namespace candela

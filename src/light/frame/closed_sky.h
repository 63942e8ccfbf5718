// SPDX-License-Identifier: Apache-2.0
// Skies that shine around everything, and shut out what comes from farther away.
#pragma once

#include "world/scene/scene.h"

namespace candela {

/// The light (by its index) that stops all of a distant light on its way into the world: what
/// shines there is the outermost thing in that direction, wherever one looks from. -1 if there is
/// none.
int closedSkyBefore(const Scene &, int distantLight);

} // namespace candela

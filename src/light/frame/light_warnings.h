// SPDX-License-Identifier: Apache-2.0
// Lights that do nothing, or not what their users may expect.
#pragma once

#include "world/scene/scene.h"

namespace candela {

/// Warns of lights that are on for no shape but their own, and of area lights around none.
void warnOfLights(const Scene &, DiagnosticSink &);

/// There are lights, and none of them casts shadows (`classic`, unless it is told to).
bool lightsCastNoShadows(const Scene &);

} // namespace candela

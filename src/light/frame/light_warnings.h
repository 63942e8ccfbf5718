// SPDX-License-Identifier: Apache-2.0
// Lights that do nothing, or not what their users may expect.
#pragma once

#include "world/scene/scene.h"

namespace candela {

/// Warns of lights that are on for no shape but their own, of area lights around none, of those
/// whose surfaces add light of their own, and of distant ones that a sky shuts out.
void warnOfLights(const Scene &, DiagnosticSink &);

/// No light casts shadows (`classic`, unless it is told to), and some do not even look them up.
bool lightsCastNoShadows(const Scene &);

} // namespace candela

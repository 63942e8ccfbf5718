// SPDX-License-Identifier: Apache-2.0
// Light for volume shaders, at the points that they name.
#pragma once

#include "light/path/wave.h"

namespace candela {

/// Asks a group of segments whose shader has light loops: it runs to say where it wants light, all
/// the points are lit together, and it runs again; and so on while it asks for more, as often as
/// Crossing::rounds.
void askLit(PathWave &, Crossing &, const Segments::Group &);

} // namespace candela

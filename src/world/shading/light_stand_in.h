// SPDX-License-Identifier: Apache-2.0
// Lights whose shaders are not to be had: a scene in the dark shows nobody what else is wrong.
#pragma once

#include "interface/ri/scene_builder.h"

namespace candela {

/// The record of a light of the library that is like one whose shader is missing, as far as its
/// name and its parameters tell: a spot, parallel or ambient light, one that falls off, or else one
/// that shines to all sides, equally bright at any distance. It has the parameters that both know.
/// An area light sends the radiance intensity x 2^exposure, with shadows, as those of later
/// renderers do.
LightRecord lightStandIn(const LightRecord &);

} // namespace candela

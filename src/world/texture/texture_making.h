// SPDX-License-Identifier: Apache-2.0
// Textures from pictures: what MakeTexture and its like, and `candela tex`, do.
#pragma once

#include "interface/ri/texture_order.h"
#include "world/texture/picture_library.h"

namespace candela {

/// Makes the file `order.texture` of the files `order.pictures`, whole or not at all: linear light
/// with all smaller levels; environments as latitude-longitude pictures; of shadow maps the depths
/// and their camera. The order's parameter "string colorspace" ("srgb", "linear") says what the
/// pictures' numbers are where they do not say it themselves. False, and `problem` says why, if
/// that cannot be done or the texture is one of the pictures.
bool makeTexture(const TextureOrder &order, std::string &problem);

} // namespace candela

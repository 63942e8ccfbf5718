// SPDX-License-Identifier: Apache-2.0
// Looking things up in pictures, row by row.
#pragma once

#include "world/texture/picture_library.h"

#include <OpenImageIO/texture.h>

namespace candela {

struct PictureLibrary::Opened {
    OIIO::TextureSystem::TextureHandle *handle = nullptr;
    int channels = 0;
    bool saysWrap = false; ///< Else it is repeated.
};

/// False if one of them fails, which has zeros then.
bool lookUp(OIIO::TextureSystem &, const PictureLibrary::Opened &, const LookupRow &);

} // namespace candela

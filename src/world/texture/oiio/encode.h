// SPDX-License-Identifier: Apache-2.0
// Pictures as files of other formats, in memory.
#pragma once

#include "world/texture/picture_library.h"

namespace candela {

/// PictureLibrary::encode.
bool encodePicture(const PictureToEncode &, std::string &bytes, std::string &problem);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Whole pictures from files and to files.
#pragma once

#include "world/texture/picture_library.h"

namespace candela {

/// As PictureLibrary has them.
bool readPicture(const std::string &path, PictureCurve, PictureData &, std::string &problem);
bool writePicture(const PictureData &, const TextureRecipe &, const std::string &path,
                  std::string &problem);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What files of pictures begin with, whoever made them.
#pragma once

#include <cstddef>
#include <string_view>

namespace candela {

/// So many bytes of a file are enough for looksLikePicture().
inline constexpr std::size_t pictureMarkLength = 16;

/// True if a file that begins so is a picture, a texture or a shadow map: OpenEXR, PNG, TIFF,
/// Radiance HDR, JPEG, GIF, BMP, PNM, PFM, DPX, Cineon, SGI, IFF, PSD, JPEG 2000, depths of other
/// renderers.
bool looksLikePicture(std::string_view beginning);

} // namespace candela

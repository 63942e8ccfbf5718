// SPDX-License-Identifier: Apache-2.0
// Pictures that verbs write: OpenEXR as they are, PNG as they look.
#pragma once

#include "image/picture.h"

#include <array>
#include <optional>
#include <string>

namespace candela {

/// "wall.PNG": the file is to be a PNG file.
bool isPngName(const std::string &path);
/// R, G or B.
bool isColorChannel(const std::string &name);

/// Exposes R, G and B by gain and gamma, and writes all channels as OpenEXR, or R, G, B and A as a
/// PNG of 8 bits, whose curve is that of sRGB if there is no exposure: it is applied unless the
/// picture has display values already. The file is there whole or
/// not at all; then `problem` says why.
bool writePicture(Picture &, const std::string &path,
                  const std::optional<std::array<float, 2>> &exposure, std::string &problem);

} // namespace candela

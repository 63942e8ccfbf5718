// SPDX-License-Identifier: Apache-2.0
// OpenEXR, in memory: what reaches the disk, and how, is whole_file.h's business.
#pragma once

#include "image/picture.h"

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// A scan-line file of 32-bit floats, ZIP compressed: the window is the data window, the frame the
/// display window, metadata become string attributes, matrices "worldToCamera" and "worldToNDC".
/// The bytes depend on the picture alone. Nothing, and `problem`, if the library refuses.
std::optional<std::string> encodeExr(const Picture &, std::string &problem);

/// Any flat single-part EXR without subsampled channels. Truncated or damaged data is a problem,
/// never a crash; so is a file that claims to be larger than its bytes can make it.
std::optional<Picture> decodeExr(std::string_view bytes, std::string &problem);

bool looksLikeExr(std::string_view bytes);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Pictures from files, whatever format they are in.
#pragma once

#include "image/picture.h"

#include <optional>
#include <string>

namespace candela {

/// Reads an OpenEXR or PNG file, told apart by content. Missing, foreign, truncated or damaged
/// files give nothing, and `problem` says which file and why.
std::optional<Picture> readPicture(const std::string &path, std::string &problem);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// PNG, in memory.
#pragma once

#include "image/picture.h"

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// Whole numbers (0..255 at 8 bits, 0..65535 at 16; others are clamped) as grey, grey and alpha,
/// RGB or RGBA, by the number of channels in their order. PNG knows no windows: the window alone
/// is the picture. `gamma` is RiExposure's: the file says that values are light^(1/gamma); without
/// one, that they follow the curve of sRGB. Colors are not multiplied by alpha.
/// Metadata become text. Nothing, and `problem`, with no channel or more than four.
std::optional<std::string> encodePng(const Picture &, int bits, std::optional<float> gamma,
                                     std::string &problem);

/// Values as fractions of the largest one, in channels Y, A or R, G, B, A: light of whole pixels
/// if the file says so (gamma 1), else display values of what covers them. Truncated or damaged
/// data is a problem, never a crash.
std::optional<Picture> decodePng(std::string_view bytes, std::string &problem);

bool looksLikePng(std::string_view bytes);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Colours as their samples, and as red, green and blue.
#pragma once

#include "language/ir/lower/components.h"

namespace candela::ir {

/// Linear Rec.709 of a colour's samples, and back; nothing is done where the samples are RGB.
Triple rgbOf(Builder &, const Components &samples);
Components colorOf(Builder &, const Triple &rgb);

/// Of a float or a color.
ValueId luminanceOf(Builder &, const Components &);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Why a picture is black, found by looking.
#pragma once

#include "world/scene/scene.h"

#include <string>

namespace candela {

/// What is wrong with a scene of which the camera sees nothing but black, and what may help; one
/// sentence. `isClear`: the picture's opacity is 0 everywhere. Looks at a few thousand points of
/// the crop window, with the seed of nothing: the same scene gets the same answer.
std::string whyBlack(const Scene &, const std::array<int, 4> &crop, bool isClear);

} // namespace candela

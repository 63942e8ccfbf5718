// SPDX-License-Identifier: Apache-2.0
// The module that knows formats of pictures, loaded when it is first asked for: OpenImageIO and the
// libraries that it brings take a third of a second to start.
#pragma once

#include "world/texture/picture_library.h"

namespace candela {

/// Null, and `problem` says why, if it cannot be loaded; the module lies in lib/candela/ of the
/// installation (foundation/base/installation.h).
PictureLibrary *pictureLibrary(std::string &problem);

} // namespace candela

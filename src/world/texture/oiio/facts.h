// SPDX-License-Identifier: Apache-2.0
// What files say of themselves beside their pixels.
#pragma once

#include "world/texture/picture_library.h"

#include <OpenImageIO/imageio.h>

namespace candela {

PictureFacts factsOf(const OIIO::ImageSpec &);
/// The same, said in a file that is to be written.
void tellFacts(const PictureFacts &, OIIO::ImageSpec &);

} // namespace candela

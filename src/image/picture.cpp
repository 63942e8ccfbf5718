// SPDX-License-Identifier: Apache-2.0
#include "image/picture.h"

#include <algorithm>

namespace candela {

const PictureChannel *Picture::find(std::string_view name) const {
    auto found = std::ranges::find(channels, name, &PictureChannel::name);
    return found == channels.end() ? nullptr : &*found;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What of a picture is looked at together: its colour, a layer of three channels, or one channel.
#pragma once

#include "image/picture.h"

#include <string>
#include <vector>

namespace candela {

struct ViewLayer {
    std::string name;          ///< "albedo", "Z"; "color" for R, G and B.
    std::vector<int> channels; ///< Three or one, by their places in Picture::channels.
    int alpha = -1;            ///< Likewise; -1 = there is none.
    bool isLight = false;      ///< R, G and B, in the picture's units.
};

/// At least one, if the picture has channels, in their order.
std::vector<ViewLayer> layersOf(const Picture &);

} // namespace candela

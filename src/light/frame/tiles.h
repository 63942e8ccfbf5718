// SPDX-License-Identifier: Apache-2.0
// The squares that a frame is rendered by. They are aligned to absolute pixels and traced whole
// even where the crop window cuts them, so that ray packets, and with them the picture, do not
// depend on the crop.
#pragma once

#include <array>
#include <vector>

namespace candela {

struct Tile {
    int x, y, size;
};

/// The greatest multiple of `step` that is not above `value`.
int roundDown(int value, int step);

/// All tiles of that size that hold pixels of the crop window (x0, x1, y0, y1).
std::vector<Tile> tilesOver(const std::array<int, 4> &crop, int size);

/// The tile's pixels in Morton order: neighbours in the wave are neighbours in the picture.
void pixelsOf(const Tile &, std::vector<int> &x, std::vector<int> &y);

} // namespace candela

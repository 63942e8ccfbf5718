// SPDX-License-Identifier: Apache-2.0
#include "light/frame/tiles.h"

namespace candela {

int roundDown(int value, int step) { return value - ((value % step) + step) % step; }

std::vector<Tile> tilesOver(const std::array<int, 4> &crop, int size) {
    std::vector<Tile> tiles;
    for (int y = roundDown(crop[2], size); y < crop[3]; y += size)
        for (int x = roundDown(crop[0], size); x < crop[1]; x += size)
            tiles.push_back({x, y, size});
    return tiles;
}

void pixelsOf(const Tile &tile, std::vector<int> &x, std::vector<int> &y) {
    x.clear();
    y.clear();
    for (int code = 0; code < tile.size * tile.size; ++code) {
        int dx = 0, dy = 0;
        for (int bit = 0; bit < 8; ++bit) {
            dx |= ((code >> (2 * bit)) & 1) << bit;
            dy |= ((code >> (2 * bit + 1)) & 1) << bit;
        }
        x.push_back(tile.x + dx);
        y.push_back(tile.y + dy);
    }
}

} // namespace candela

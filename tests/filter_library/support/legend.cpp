// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/legend.h"

#include <algorithm>
#include <map>

namespace candela::filters {

namespace {

/// Rows of dots as a person would read them.
const std::map<std::string, char> glyphs{
    {".###.#...##...##...##...##...#.###.", '0'}, {"..#...##....#....#....#....#...###.", '1'},
    {".###.#...#....#...#...#...#...#####", '2'}, {".###.#...#....#..##.....##...#.###.", '3'},
    {"...#...##..#.#.#..#.#####...#....#.", '4'}, {"######....####.....#....##...#.###.", '5'},
    {"..##..#...#....####.#...##...#.###.", '6'}, {"#####....#...#....#...#....#....#..", '7'},
    {".###.#...##...#.###.#...##...#.###.", '8'}, {".###.#...##...#.####....#...#..##..", '9'},
    {"..........................##...##..", '.'}, {"...........###.#...##....#...#.###.", 'c'},
    {"....#....#.#####...##...##...#.####", 'd'}, {"....#....#...#...#...#...#....#....", '/'},
    {"..........##.#.#.#.##.#.##.#.##.#.#", 'm'}, {".###.#...#...#...#..#####..........", '^'},
    {".##....#....#....#....#....#...###.", 'l'}, {"..........#...#.#.#...#...#.#.#...#", 'x'},
    {"...........###.#...#######.....###.", 'e'}, {"...............#####...............", '-'}};

bool lit(const Picture &picture, int x, int y) {
    return x < picture.width && y >= 0 && y < picture.height && picture.at(x, y)[0] > .5 &&
           picture.at(x, y)[0] == picture.at(x, y)[1] && picture.at(x, y)[0] == picture.at(x, y)[2];
}

std::string textAt(const Picture &picture, int left, int top, int dots) {
    std::string text;
    for (;; left += 6 * dots) {
        std::string rows;
        for (int row = 0; row < 7; ++row)
            for (int dot = 0; dot < 5; ++dot)
                rows += lit(picture, left + dot * dots, top + row * dots) ? '#' : '.';
        if (rows.find('#') == std::string::npos)
            return text;
        const auto found = glyphs.find(rows);
        text += found == glyphs.end() ? '?' : found->second;
    }
}

} // namespace

Legend readLegend(const Picture &picture, int columns) {
    const int dots = std::max(std::min(columns / 320, picture.height / 240), 1);
    const int left = picture.width - 56 * dots, right = left + 14 * dots;
    const int top = 18 * dots, bottom = picture.height - 8 * dots;
    Legend legend;
    legend.unit = textAt(picture, left + 4 * dots, 5 * dots, dots);
    for (int y = picture.height - 1; y >= top - dots; --y) {
        if (!lit(picture, right, y) || lit(picture, right, y - 1))
            continue;
        const double middle = y + .5 * dots;
        legend.labels.push_back({(bottom - middle) / (bottom - top),
                                 textAt(picture, right + 4 * dots, y - 3 * dots, dots)});
    }
    return legend;
}

} // namespace candela::filters

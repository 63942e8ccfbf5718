// SPDX-License-Identifier: Apache-2.0
// The loops of the filters by hand: included once for each level.
#pragma once

#include "by_hand/filters.h"
#include "foundation/base/parallel.h"
#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace candela::bench {
namespace {

constexpr int rowsTogether = 8;

template <typename Body> void forRows(int height, Body body) {
    parallelFor(std::size_t((height + rowsTogether - 1) / rowsTogether), [&](std::size_t k) {
        const int end = std::min(height, (int(k) + 1) * rowsTogether);
        for (int y = int(k) * rowsTogether; y < end; ++y)
            body(y);
    });
}

double luminanceOfRow(const float *__restrict r, const float *__restrict g,
                      const float *__restrict b, int width) {
    float parts[16] = {};
    int x = 0;
    for (; x + 16 <= width; x += 16)
        for (int k = 0; k < 16; ++k)
            parts[k] += luminanceWeights[0] * r[x + k] + luminanceWeights[1] * g[x + k] +
                        luminanceWeights[2] * b[x + k];
    double sum = 0;
    for (float part : parts)
        sum += double(part);
    for (; x < width; ++x)
        sum += double(luminanceWeights[0] * r[x] + luminanceWeights[1] * g[x] +
                      luminanceWeights[2] * b[x]);
    return sum * double(luminousEfficacy);
}

void scaleRow(const float *__restrict from, float *__restrict to, float factor, int width) {
    for (int x = 0; x < width; ++x)
        to[x] = from[x] * factor;
}

void ward94(const ImageMap &from, const ImageMap &to) {
    std::vector<double> sums(std::size_t(from.height));
    forRows(from.height, [&](int y) {
        sums[std::size_t(y)] =
            luminanceOfRow(from.row(0, y), from.row(1, y), from.row(2, y), from.width);
    });
    double sum = 0;
    for (double row : sums)
        sum += row;
    const float adaptation = float(sum / (double(from.width) * from.height));
    const float greatest = 100;
    const float scale =
        std::pow((1.219f + std::pow(greatest / 2, .4f)) / (1.219f + std::pow(adaptation, .4f)),
                 2.5f) /
        greatest * float(luminousEfficacy);
    forRows(from.height, [&](int y) {
        for (int c = 0; c < 3; ++c)
            scaleRow(from.row(c, y), to.row(c, y), scale, from.width);
    });
}

/// Rows have room on either side, which is filled with what the border holds.
void box21(const ImageMap &from, const ImageMap &to) {
    constexpr int radius = 10, block = 32;
    forRows(from.height, [&](int y) {
        for (int c = 0; c < 3; ++c) {
            float *row = from.row(c, y);
            std::fill(row - radius, row, row[0]);
            std::fill(row + from.width, row + from.width + imageHalo, row[from.width - 1]);
        }
    });
    forRows(from.height, [&](int y) {
        for (int x = 0; x < from.width; x += block) {
            float sums[3][block] = {};
            for (int j = -radius; j <= radius; ++j) {
                const int line = std::clamp(y + j, 0, from.height - 1);
                const float *r = from.row(0, line) + x, *g = from.row(1, line) + x,
                            *b = from.row(2, line) + x;
                for (int i = -radius; i <= radius; ++i)
                    for (int k = 0; k < block; ++k) {
                        sums[0][k] += r[i + k];
                        sums[1][k] += g[i + k];
                        sums[2][k] += b[i + k];
                    }
            }
            const int count = std::min(block, from.width - x);
            for (int c = 0; c < 3; ++c)
                for (int k = 0; k < count; ++k)
                    to.row(c, y)[x + k] = sums[c][k] / 441;
        }
    });
}

constexpr HandFilters filters{ward94, box21};

} // namespace
} // namespace candela::bench

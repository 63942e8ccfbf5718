// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/image_access.h"

#include "language/runtime/shader_abi.h"

#include <algorithm>
#include <cmath>

namespace candela::runtime {

namespace {

/// A coordinate within the picture, so that whole numbers are safe.
float clampedTo(float x, int size) {
    return x > 0 ? std::min(x, float(size - 1)) : 0; // NaN: 0.
}

/// A coordinate, no farther from the picture than the filter reaches: from there on all pixels hold
/// what the border holds.
float placeNear(float x, float reach, int size) {
    const float least = -reach - 1, most = float(size) + reach;
    return x == x ? std::min(std::max(x, least), most) : 0;
}

/// Pixels along an axis and their weights, which sum to 1.
struct Footprint {
    int first = 0, count = 1;
    float width = 0, center = 0, scale = 1;
    ImageFilter filter = ImageFilter::Nearest;

    float weight(int k) const { return scale * rawWeight(float(first + k) - center); }
    float rawWeight(float distance) const;
};

float catmullRom(float x) {
    x = std::abs(x);
    if (x < 1)
        return 1 + x * x * (1.5f * x - 2.5f);
    return x < 2 ? 2 + x * (-4 + x * (2.5f - .5f * x)) : 0;
}

float Footprint::rawWeight(float distance) const {
    const float x = std::abs(distance);
    switch (filter) {
    case ImageFilter::Nearest: return 1;
    case ImageFilter::Bilinear: return std::max(0.0f, 1 - x);
    // The part of the pixel that the box covers.
    case ImageFilter::Box: return std::clamp(width / 2 + .5f - x, 0.0f, std::min(1.0f, width));
    case ImageFilter::Triangle: return std::max(0.0f, 1 - 2 * x / width);
    // RI's: e^-2 at the middle of either side, cut there.
    case ImageFilter::Gaussian: {
        const float part = 2 * x / width;
        return part > 1 ? 0 : std::exp(-2 * part * part);
    }
    case ImageFilter::CatmullRom: return catmullRom(4 * x / width);
    }
    return 0;
}

/// How far from the place pixels still weigh.
float reachOf(ImageFilter filter, float width) {
    switch (filter) {
    case ImageFilter::Nearest: return 0;
    case ImageFilter::Bilinear: return 1;
    case ImageFilter::Box: return width / 2 + .5f;
    default: return width / 2;
    }
}

/// Filters that are narrower than the grid would miss it.
float usableWidth(ImageFilter filter, float width) {
    const float least = filter == ImageFilter::Box          ? 1e-3f
                        : filter == ImageFilter::CatmullRom ? 4
                                                            : 2;
    constexpr float most = 4096;
    return width > least ? std::min(width, most) : least;
}

Footprint footprint(ImageFilter filter, float x, float width, int size) {
    Footprint result;
    result.filter = filter;
    result.width = usableWidth(filter, width);
    if (filter == ImageFilter::Nearest) {
        result.first = int(std::floor(clampedTo(x, size) + .5f));
        return result;
    }
    const float reach = reachOf(filter, result.width);
    result.center = placeNear(x, reach, size);
    result.first = int(std::ceil(result.center - reach));
    result.count = std::max(1, int(std::floor(result.center + reach)) - result.first + 1);
    float sum = 0;
    for (int k = 0; k < result.count; ++k)
        sum += result.weight(k);
    result.scale = sum != 0 ? 1 / sum : 1;
    return result;
}

/// Which plane a color's component comes from; -1: none.
int planeOf(const ImageMap &map, int first, int component) {
    if (map.channels == 1 && first == 0)
        return 0;
    const int channel = first + component;
    return channel < map.channels ? channel : -1;
}

int channelOf(float channel) { return channel > 0 ? int(std::min(channel + .5f, 1e6f)) : 0; }

float filtered(const ImageMap &map, int plane, const Footprint &x, const Footprint &y) {
    float sum = 0;
    for (int j = 0; j < y.count; ++j) {
        const float *row = map.row(plane, std::clamp(y.first + j, 0, map.height - 1));
        float ofRow = 0;
        for (int k = 0; k < x.count; ++k)
            ofRow += x.weight(k) * row[std::clamp(x.first + k, 0, map.width - 1)];
        sum += y.weight(j) * ofRow;
    }
    return sum;
}

/// Between the centres of four pixels. At a centre it is the pixel, whatever its neighbours hold.
float bilinear(const ImageMap &map, int plane, float x, float y) {
    const int x0 = int(x), y0 = int(y);
    const float fx = x - float(x0), fy = y - float(y0);
    const float *above = map.row(plane, y0), *below = map.row(plane, y0 + (fy > 0));
    const int x1 = x0 + (fx > 0);
    const auto along = [&](const float *row) {
        return fx > 0 ? row[x0] * (1 - fx) + row[x1] * fx : row[x0];
    };
    return fy > 0 ? along(above) * (1 - fy) + along(below) * fy : along(above);
}

/// The place and the filter of one lane's lookup.
struct Lookup {
    float x, y;
    Footprint alongX, alongY;
};

float valueAt(const ImageMap &map, ImageFilter filter, int plane, const Lookup &at) {
    return filter == ImageFilter::Bilinear ? bilinear(map, plane, at.x, at.y)
                                           : filtered(map, plane, at.alongX, at.alongY);
}

} // namespace

void lookUpImage(const ImageMap &map, ImageFilter filter, int results, int laneCount,
                 std::uint32_t mask, const float *operands, float *values) {
    const auto operand = [&](LookupOperand which, int lane) {
        return operands[int(which) * laneCount + lane];
    };
    for (int lane = 0; lane < laneCount; ++lane) {
        if (!(mask >> lane & 1))
            continue;
        Lookup at{};
        const bool isEmpty = map.width == 0 || map.height == 0;
        if (!isEmpty) {
            at.x = clampedTo(operand(LookupOperand::X, lane), map.width);
            at.y = clampedTo(operand(LookupOperand::Y, lane), map.height);
            if (filter != ImageFilter::Bilinear) {
                at.alongX = footprint(filter, operand(LookupOperand::X, lane),
                                      operand(LookupOperand::XWidth, lane), map.width);
                at.alongY = footprint(filter, operand(LookupOperand::Y, lane),
                                      operand(LookupOperand::YWidth, lane), map.height);
            }
        }
        const int first = channelOf(operand(LookupOperand::Channel, lane));
        for (int c = 0; c < results; ++c) {
            const int plane = isEmpty ? -1 : planeOf(map, first, c);
            values[c * laneCount + lane] = plane < 0 ? 0 : valueAt(map, filter, plane, at);
        }
    }
}

void setImage(const ImageMap &map, int values, int laneCount, std::uint32_t mask,
              const float *operands) {
    for (int lane = 0; lane < laneCount; ++lane) {
        const float x = std::floor(operands[lane] + .5f);
        const float y = std::floor(operands[laneCount + lane] + .5f);
        const bool inside = x >= 0 && y >= 0 && x < float(map.width) && y < float(map.height);
        if (!inside || !(mask >> lane & 1))
            continue;
        for (int c = 0; c < map.channels; ++c)
            if (c < values || values == 1)
                map.row(c, int(y))[int(x)] =
                    operands[(2 + (values == 1 ? 0 : c)) * laneCount + lane];
    }
}

void lookUpFromCode(const ShaderArgs *args, std::int32_t map, std::int32_t filter,
                    std::int32_t results, std::int32_t laneCount, std::uint32_t mask,
                    const float *operands, float *values) {
    lookUpImage(args->maps[map], ImageFilter(filter), results, laneCount, mask, operands, values);
}

void setFromCode(const ShaderArgs *args, std::int32_t map, std::int32_t values,
                 std::int32_t laneCount, std::uint32_t mask, const float *operands) {
    setImage(args->maps[map], values, laneCount, mask, operands);
}

void runPixelLoop(const ShaderArgs *args, std::int32_t loop, std::int32_t resultCount,
                  const float *given, const float *const *arrays, float *results) {
    std::fill_n(results, resultCount, 0.0f);
    if (const PixelLoopRunner *runner = args->pixelLoops)
        runner->run(runner->context, loop, given, arrays, results);
}

bool filterGoesOn(const ShaderArgs *args) {
    const ShaderCallbacks *callbacks = args->callbacks;
    return !callbacks || !callbacks->goOn || callbacks->goOn(callbacks->context);
}

} // namespace candela::runtime

// SPDX-License-Identifier: Apache-2.0
// A finished picture in memory: named float channels over a window, and what is said about it.
#pragma once

#include "foundation/base/matrix4.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

/// Pixels [x0, x1) x [y0, y1) of a frame of width x height. Row 0 is the top.
struct FrameWindow {
    int width = 0, height = 0;
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0;

    int columns() const { return x1 - x0; }
    int rows() const { return y1 - y0; }
    std::size_t pixels() const { return std::size_t(columns()) * rows(); }
    friend bool operator==(const FrameWindow &, const FrameWindow &) = default;
};

struct PictureChannel {
    std::string name;          ///< As in an EXR file: "R", "A", "Z", "albedo.G", "half0.R".
    std::vector<float> values; ///< Row by row over the window.
};

/// Pixels times channels that a file may have to be read: 2 GB in memory.
inline constexpr double largestValueCount = 1 << 29;

struct Picture {
    FrameWindow window;
    float pixelAspectRatio = 1;
    std::vector<PictureChannel> channels;
    std::map<std::string, std::string> metadata;
    std::optional<Matrix4> worldToCamera, worldToNdc; ///< Row vectors, as in RI.
    /// R, G, B (or Y) are display values by the curve of sRGB, as in a PNG file, and not light.
    bool hasDisplayValues = false;

    /// The channel of that name, or null.
    const PictureChannel *find(std::string_view name) const;
};

} // namespace candela

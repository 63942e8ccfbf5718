// SPDX-License-Identifier: Apache-2.0
// A look at pictures as a value: what has been shown to it, and what keys and mouse have made of
// the way it is looked at. It knows no window.
#pragma once

#include "image/view/view_event.h"
#include "image/view/view_layers.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

class View {
public:
    /// A display's picture comes, or a newer one in its place.
    void show(const std::string &display, Picture, bool isFinished);
    /// True if there is something new to see.
    bool handle(const ViewEvent &);
    bool isClosed() const { return closed_; }

    /// Display, layer, exposure and what lies under the pointer.
    std::string title() const;
    /// The window as 0xRRGGBB, row by row, in the size that it was last resized to.
    std::vector<std::uint32_t> paint() const;
    int width() const { return width_; }
    int height() const { return height_; }
    /// The size of a window that shows all of the first picture, no larger than the limit.
    static std::array<int, 2> sizeFor(const Picture &, std::array<int, 2> limit);

private:
    struct Shown {
        std::string display;
        Picture picture;
        std::vector<ViewLayer> layers;
        bool isFinished;
        float gain, gamma; ///< Of Exposure, which the colours have been through.
    };
    /// Which of a layer's channels are looked at.
    enum class Channel { All, Red, Green, Blue, Alpha, Luminance };
    struct Place {
        double x, y;
    };
    struct Looked {
        const Shown &shown;
        const ViewLayer &layer;
    };

    bool press(const std::string &key);
    bool choose(Channel);
    void turnPage(int step);
    void zoomBy(double factor, Place at);
    void fit();
    /// What is looked at; nothing before the first picture.
    std::optional<Looked> looked() const;
    Place placeInPicture(Place inWindow) const;
    /// The pixel's number there, if there is one.
    std::optional<std::size_t> pixelAt(const Picture &, Place inPicture) const;
    float scaleOf(const Looked &) const;
    /// Back through the gamma of what is on a curve already.
    static float linear(const Looked &, float value);
    std::uint32_t colorOf(const Looked &, std::size_t pixel, float scale) const;
    std::string valuesAt(const Looked &, std::size_t pixel) const;

    std::vector<Shown> pictures_;
    std::size_t picture_ = 0, layer_ = 0;
    Channel channel_ = Channel::All;
    int exposure_ = 0; ///< In halves of a stop.
    int width_ = 1, height_ = 1;
    double zoom_ = 1;    ///< Window pixels a pixel of the picture.
    Place centre_{0, 0}; ///< Of the window, in the picture.
    bool fits_ = true;   ///< The picture fills the window, whatever its size.
    std::optional<Place> pointer_;
    bool closed_ = false;
};

} // namespace candela

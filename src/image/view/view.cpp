// SPDX-License-Identifier: Apache-2.0
#include "image/view/view.h"

#include "foundation/units/color.h"
#include "image/imaging.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace candela {

namespace {

constexpr double largestZoom = 64, smallestZoom = 1. / 64;
/// Where there is no picture.
constexpr std::uint32_t surround = 0x202020;
/// As files name them.
constexpr const char *radianceUnits = "W m^-2 sr^-1";
/// What depth has where nothing is.
constexpr float nothingThere = 1e30f;

/// Of light on the curve of sRGB, by table: a window is a million times that.
std::uint32_t curvedByteOf(float light) {
    constexpr int last = 1 << 14;
    static const std::vector<std::uint8_t> bytes = [] {
        std::vector<std::uint8_t> all(last + 1);
        for (int i = 0; i <= last; ++i)
            all[std::size_t(i)] = std::uint8_t(std::lround(255 * srgbCurve(float(i) / last)));
        return all;
    }();
    const float inside = std::clamp(std::isnan(light) ? 0 : light, 0.f, 1.f);
    return bytes[std::size_t(std::lround(inside * last))];
}

std::uint32_t byteOf(float value) {
    return std::uint32_t(std::lround(255 * std::clamp(std::isnan(value) ? 0 : value, 0.f, 1.f)));
}

std::string number(const char *format, double value) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

/// Gain and gamma, as files tell them.
std::pair<float, float> exposureOf(const Picture &picture) {
    const auto text = picture.metadata.find("exposure");
    float gain = 1, gamma = 1;
    if (text == picture.metadata.end() ||
        std::sscanf(text->second.c_str(), "%f %f", &gain, &gamma) != 2 || !(gain > 0) ||
        !(gamma > 0))
        return {1, 1};
    return {gain, gamma};
}

} // namespace

void View::show(const std::string &display, Picture picture, bool isFinished) {
    auto layers = layersOf(picture);
    if (layers.empty())
        return;
    const auto known = std::ranges::find(pictures_, display, &Shown::display);
    const std::size_t place = std::size_t(known - pictures_.begin());
    const auto [gain, gamma] = exposureOf(picture);
    Shown shown{display, std::move(picture), std::move(layers), isFinished, gain, gamma};
    if (known != pictures_.end())
        *known = std::move(shown);
    else
        pictures_.push_back(std::move(shown));
    if (place != picture_)
        return;
    layer_ = std::min(layer_, pictures_[place].layers.size() - 1);
    if (fits_)
        fit();
}

std::optional<View::Looked> View::looked() const {
    if (pictures_.empty())
        return std::nullopt;
    const Shown &shown = pictures_[picture_];
    return Looked{shown, shown.layers[layer_]};
}

bool View::handle(const ViewEvent &event) {
    switch (event.kind) {
    case ViewEvent::Kind::Key: return press(event.key);
    case ViewEvent::Kind::Close: return closed_ = true;
    case ViewEvent::Kind::Expose: return true;
    case ViewEvent::Kind::Pointer: pointer_ = {double(event.x), double(event.y)}; return true;
    case ViewEvent::Kind::Drag:
        centre_.x -= event.x / zoom_, centre_.y -= event.y / zoom_;
        fits_ = false;
        return true;
    case ViewEvent::Kind::Wheel:
        zoomBy(std::exp2(event.y / 2.), pointer_.value_or(Place{width_ / 2., height_ / 2.}));
        return true;
    case ViewEvent::Kind::Resize:
        width_ = std::max(event.x, 1), height_ = std::max(event.y, 1);
        if (fits_)
            fit();
        return true;
    }
    return false;
}

bool View::press(const std::string &key) {
    const Place middle{width_ / 2., height_ / 2.};
    if (key == "q" || key == "escape")
        return closed_ = true;
    if (key == "+" || key == "=")
        return exposure_ = std::min(exposure_ + 1, 60), true;
    if (key == "-")
        return exposure_ = std::max(exposure_ - 1, -60), true;
    if (key == "0")
        return exposure_ = 0, true;
    constexpr std::pair<const char *, Channel> channels[] = {{"r", Channel::Red},
                                                             {"g", Channel::Green},
                                                             {"b", Channel::Blue},
                                                             {"a", Channel::Alpha},
                                                             {"l", Channel::Luminance}};
    for (const auto &[name, channel] : channels)
        if (key == name)
            return choose(channel);
    if (key == "page down" || key == "page up")
        return turnPage(key == "page down" ? 1 : -1), true;
    if (key == "z" || key == "x")
        return zoomBy(key == "z" ? 2 : .5, middle), true;
    if (key == "1")
        return zoomBy(1 / zoom_, middle), true;
    if (key == "f")
        return fit(), true;
    return false;
}

/// Pressed again, the key of a channel leads back to all of them.
bool View::choose(Channel channel) {
    channel_ = channel_ == channel ? Channel::All : channel;
    return true;
}

/// Through all layers of all displays, round and round.
void View::turnPage(int step) {
    if (pictures_.empty())
        return;
    const auto count = [&] { return pictures_[picture_].layers.size(); };
    if (step > 0 && ++layer_ == count())
        picture_ = (picture_ + 1) % pictures_.size(), layer_ = 0;
    else if (step < 0 && layer_-- == 0)
        picture_ = (picture_ + pictures_.size() - 1) % pictures_.size(), layer_ = count() - 1;
    if (fits_)
        fit();
}

View::Place View::placeInPicture(Place at) const {
    return {centre_.x + (at.x - width_ / 2.) / zoom_, centre_.y + (at.y - height_ / 2.) / zoom_};
}

/// What lies there stays there.
void View::zoomBy(double factor, Place at) {
    const Place fixed = placeInPicture(at);
    zoom_ = std::clamp(zoom_ * factor, smallestZoom, largestZoom);
    centre_ = {fixed.x - (at.x - width_ / 2.) / zoom_, fixed.y - (at.y - height_ / 2.) / zoom_};
    fits_ = false;
}

void View::fit() {
    fits_ = true;
    const auto here = looked();
    if (!here)
        return;
    const FrameWindow &window = here->shown.picture.window;
    const double columns = std::max(window.columns(), 1), rows = std::max(window.rows(), 1);
    zoom_ = std::min(width_ / columns, height_ / rows);
    centre_ = {columns / 2, rows / 2};
}

std::array<int, 2> View::sizeFor(const Picture &picture, std::array<int, 2> limit) {
    const double columns = std::max(picture.window.columns(), 1),
                 rows = std::max(picture.window.rows(), 1);
    const double zoom = std::min({1., limit[0] / columns, limit[1] / rows});
    return {std::max(int(columns * zoom), 64), std::max(int(rows * zoom), 64)};
}

std::optional<std::size_t> View::pixelAt(const Picture &picture, Place at) const {
    const int columns = picture.window.columns(), rows = picture.window.rows();
    if (!(at.x >= 0 && at.x < columns && at.y >= 0 && at.y < rows))
        return std::nullopt;
    return std::size_t(at.y) * std::size_t(columns) + std::size_t(at.x);
}

/// Exposure, by which what is no light (depths, numbers of objects) has its largest value white.
float View::scaleOf(const Looked &here) const {
    float scale = std::exp2(float(exposure_) / 2);
    if (here.layer.channels.size() > 1 || channel_ == Channel::Alpha)
        return scale;
    float largest = 0;
    for (const float value :
         here.shown.picture.channels[std::size_t(here.layer.channels[0])].values)
        if (std::fabs(value) < nothingThere)
            largest = std::max(largest, std::fabs(value));
    return largest > 0 ? scale / largest : scale;
}

float View::linear(const Looked &here, float value) {
    if (!here.layer.isLight)
        return value;
    if (here.shown.picture.hasDisplayValues)
        return linearOfSrgb(value);
    const float gamma = here.shown.gamma;
    return gamma == 1 ? value : std::copysign(std::pow(std::fabs(value), gamma), value);
}

std::uint32_t View::colorOf(const Looked &here, std::size_t pixel, float scale) const {
    const Picture &picture = here.shown.picture;
    const auto value = [&](int channel) {
        return channel < 0 ? 1.f : picture.channels[std::size_t(channel)].values[pixel];
    };
    const auto shown = [&](float light) { return curvedByteOf(light * scale); };
    const auto light = [&](int channel) { return linear(here, value(channel)); };
    const std::vector<int> &channels = here.layer.channels;
    const auto grey = [](std::uint32_t byte) { return byte * 0x010101; };
    if (channel_ == Channel::Alpha)
        return grey(byteOf(value(here.layer.alpha) * scale));
    if (channels.size() == 1)
        return grey(shown(std::fabs(light(channels[0]))));
    const candela::Color color(light(channels[0]), light(channels[1]), light(channels[2]));
    switch (channel_) {
    case Channel::Red: return grey(shown(color[0]));
    case Channel::Green: return grey(shown(color[1]));
    case Channel::Blue: return grey(shown(color[2]));
    case Channel::Luminance: return grey(shown(luminance(color)));
    default: return shown(color[0]) << 16 | shown(color[1]) << 8 | shown(color[2]);
    }
}

std::vector<std::uint32_t> View::paint() const {
    std::vector<std::uint32_t> pixels(std::size_t(width_) * std::size_t(height_), surround);
    const auto here = looked();
    if (!here)
        return pixels;
    const float scale = scaleOf(*here);
    for (int y = 0; y < height_; ++y)
        for (int x = 0; x < width_; ++x)
            if (const auto pixel = pixelAt(here->shown.picture, placeInPicture({x + .5, y + .5})))
                pixels[std::size_t(y) * std::size_t(width_) + std::size_t(x)] =
                    colorOf(*here, *pixel, scale);
    return pixels;
}

std::string View::valuesAt(const Looked &here, std::size_t pixel) const {
    const Picture &picture = here.shown.picture;
    std::string text;
    std::vector<int> channels = here.layer.channels;
    if (here.layer.alpha >= 0)
        channels.push_back(here.layer.alpha);
    for (const int channel : channels) {
        const PictureChannel &plane = picture.channels[std::size_t(channel)];
        text += (text.empty() ? "" : " ") + plane.name.substr(plane.name.rfind('.') + 1) + " " +
                number("%.4g", plane.values[pixel]);
    }
    const auto units = picture.metadata.find("units");
    const bool isRadiance = units != picture.metadata.end() && units->second == radianceUnits &&
                            !picture.metadata.contains("filters");
    if (!here.layer.isLight || picture.hasDisplayValues || !isRadiance)
        return text;
    const auto radiance = [&](std::size_t k) {
        const int channel = here.layer.channels[k];
        return linear(here, picture.channels[std::size_t(channel)].values[pixel]) / here.shown.gain;
    };
    const float y = luminance(candela::Color(radiance(0), radiance(1), radiance(2)));
    if (here.shown.gain == 1 && here.shown.gamma == 1)
        text += std::string(" ") + radianceUnits;
    return text + ", " + number("%.4g", double(luminousEfficacy) * y) + " cd/m^2";
}

std::string View::title() const {
    const auto here = looked();
    if (!here)
        return "candela";
    constexpr const char *names[] = {"", " red", " green", " blue", " alpha", " luminance"};
    std::string text = here->shown.display + (here->shown.isFinished ? "" : " (in the making)") +
                       ": " + here->layer.name + names[int(channel_)];
    if (exposure_ != 0)
        text += number(", %+g stops", exposure_ / 2.);
    const auto place = pointer_ ? std::optional(placeInPicture(*pointer_)) : std::nullopt;
    const auto pixel = place ? pixelAt(here->shown.picture, *place) : std::nullopt;
    if (!pixel)
        return text;
    const FrameWindow &window = here->shown.picture.window;
    return text + ", (" + std::to_string(window.x0 + int(place->x)) + ", " +
           std::to_string(window.y0 + int(place->y)) + ") " + valuesAt(*here, *pixel);
}

} // namespace candela

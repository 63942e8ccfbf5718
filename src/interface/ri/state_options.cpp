// SPDX-License-Identifier: Apache-2.0
// Options (RI 3.2, section 4.1).
#include "interface/ri/search_path.h"
#include "interface/ri/state_handlers.h"

#include <cmath>

namespace candela {

void StateHandlers::format(const SourceLocation &where, int x, int y, float aspect) {
    const Options standard;
    if (x == 0 || y == 0 || x > 1 << 20 || y > 1 << 20 || !std::isfinite(aspect) || aspect == 0)
        return error(where, "Format",
                     "expected a resolution from 1 to 1048576 and a pixel "
                     "aspect ratio above 0; the request is left out");
    // RI: a negative value asks for the display's own.
    options_.xResolution = x > 0 ? x : standard.xResolution;
    options_.yResolution = y > 0 ? y : standard.yResolution;
    options_.pixelAspectRatio = aspect > 0 ? aspect : standard.pixelAspectRatio;
    options_.places.format = where;
}

void StateHandlers::frameAspectRatio(const SourceLocation &where, float ratio) {
    if (!std::isfinite(ratio) || ratio <= 0)
        return error(where, "FrameAspectRatio", "expected a ratio above 0");
    options_.frameAspectRatio = ratio;
}

void StateHandlers::screenWindow(const SourceLocation &where, float left, float right, float bottom,
                                 float top) {
    if (!finite(where, "ScreenWindow", {left, right, bottom, top}))
        return;
    if (left == right || bottom == top)
        return error(where, "ScreenWindow", "the window is empty; the request is left out");
    options_.screenWindow = {left, right, bottom, top};
}

void StateHandlers::cropWindow(const SourceLocation &where, float x0, float x1, float y0,
                               float y1) {
    auto ordered = [](float low, float high) { return 0 <= low && low < high && high <= 1; };
    if (!ordered(x0, x1) || !ordered(y0, y1))
        return error(where, "CropWindow",
                     "expected 0 <= xmin < xmax <= 1 and the same for y; "
                     "the request is left out");
    options_.cropWindow = {x0, x1, y0, y1};
    options_.places.cropWindow = where;
}

void StateHandlers::projection(const SourceLocation &where, const std::string &name,
                               const TokenList &tokens) {
    const bool none = name == "null" || name.empty();
    if (name != "perspective" && name != "orthographic" && !none)
        return error(where, "Projection",
                     "'" + name +
                         "' is unknown: expected \"perspective\", \"orthographic\" or \"null\"");
    float fieldOfView = parameters(where, tokens, "Projection").number("fov", 90);
    if (!(fieldOfView > 0 && fieldOfView < 180)) {
        error(where, "Projection", "expected \"fov\" between 0 and 180 degrees; using 90");
        fieldOfView = 90;
    }
    options_.camera.perspective = name == "perspective";
    options_.camera.fieldOfView = fieldOfView;
    // RI 3.2, 4.1.1: without a projection, what stands before it leads from the world to the
    // camera; with one, it moves the projected picture, and camera space starts here.
    options_.camera.screenFromProjected = {};
    if (none)
        return;
    setScreen(where);
    ctm_ = {};
}

/// The current transformation becomes the one from projected to screen space.
void StateHandlers::setScreen(const SourceLocation &where) {
    Matrix4d screen = ctm_.matrix;
    if (screen.at(2, 0) != 0 || screen.at(2, 1) != 0)
        diagnostics_.warning(where, "Projection: the transformation before it moves the picture "
                                    "with depth; that part of it is left out");
    screen.at(2, 0) = screen.at(2, 1) = 0;
    if (inverse(screen.rounded()))
        options_.camera.screenFromProjected = screen.rounded();
    else
        error(where, "Projection",
              "the transformation before it leaves nothing of the picture; it is left out");
}

void StateHandlers::clipping(const SourceLocation &where, float near, float far) {
    if (!(near > 0 && near < far))
        return error(where, "Clipping", "expected 0 < near < far; the request is left out");
    options_.camera.near = near;
    options_.camera.far = far;
}

void StateHandlers::depthOfField(const SourceLocation &where, const LooseFloats &given) {
    CameraRecord &camera = options_.camera;
    if (given.values.empty()) {
        camera.fStop = camera.focalLength = camera.focalDistance = 0;
        return;
    }
    if (given.values.size() != 3)
        return error(where, "DepthOfField",
                     "expected fstop, focal length and focal distance, or "
                     "nothing for a pinhole");
    auto [fStop, length, distance] = std::tuple(given.values[0], given.values[1], given.values[2]);
    if (!(fStop > 0 && length > 0 && distance > 0))
        return error(where, "DepthOfField", "expected three numbers above 0");
    bool pinhole = !std::isfinite(fStop) || fStop >= 1e30f; // RI_INFINITY
    camera.fStop = pinhole ? 0 : fStop;
    camera.focalLength = length;
    camera.focalDistance = distance;
}

void StateHandlers::shutter(const SourceLocation &where, float open, float close) {
    if (!finite(where, "Shutter", {open, close}))
        return;
    if (open > close)
        return error(where, "Shutter", "expected an opening time before the closing time");
    options_.camera.shutterOpen = open;
    options_.camera.shutterClose = close;
}

void StateHandlers::pixelVariance(const SourceLocation &where, float variation) {
    if (!(variation >= 0))
        return error(where, "PixelVariance", "expected a number from 0 up");
    options_.pixelVariance = variation;
    warnOnce(where, "PixelVariance",
             "PixelVariance: this version takes as many samples as PixelSamples says everywhere");
}

void StateHandlers::pixelSamples(const SourceLocation &where, float x, float y) {
    if (!(x >= 1 && y >= 1 && double(x) * y <= maximumSamplesPerPixel))
        return error(where, "PixelSamples",
                     "expected two numbers from 1 up, with a product of at most " +
                         std::to_string(maximumSamplesPerPixel));
    options_.xSamples = x;
    options_.ySamples = y;
}

void StateHandlers::pixelFilter(const SourceLocation &where, const std::string &name, float x,
                                float y) {
    if (!(x > 0 && y > 0 && x <= 1000 && y <= 1000))
        return error(where, "PixelFilter", "expected widths above 0, at most 1000 pixels");
    options_.filter = {name, x, y};
    options_.places.pixelFilter = where;
}

void StateHandlers::exposure(const SourceLocation &where, float gain, float gamma) {
    if (!(gain >= 0 && gamma > 0) || !finite(where, "Exposure", {gain, gamma}))
        return error(where, "Exposure", "expected a gain from 0 up and a gamma above 0");
    options_.exposureGain = gain;
    options_.exposureGamma = gamma;
}

void StateHandlers::quantize(const SourceLocation &where, const std::string &type, int one,
                             int minimum, int maximum, float dither) {
    if (!std::isfinite(dither) || one < 0 || minimum > maximum)
        return error(where, "Quantize", "expected one >= 0 and minimum <= maximum");
    QuantizeRecord record{float(one), float(minimum), float(maximum), dither};
    if (type == "rgba" || type == "rgb")
        options_.colorQuantize = record;
    else if (type == "z")
        options_.depthQuantize = record;
    else
        error(where, "Quantize", "'" + type + "' is unknown: expected \"rgba\" or \"z\"");
}

std::optional<QuantizeRecord> StateHandlers::displayQuantize(ParameterList &list) {
    const Parameter *levels = list.find("quantize"); // zero, one, minimum, maximum
    if (!levels || levels->floats.size() != 4)
        return std::nullopt;
    const Floats &v = levels->floats;
    return QuantizeRecord{v[1], v[2], v[3], list.number("dither", v[1] > 0 ? 0.5f : 0.0f)};
}

void StateHandlers::display(const SourceLocation &where, const std::string &name,
                            const std::string &type, const std::string &mode,
                            const TokenList &tokens) {
    bool adds = name.starts_with("+");
    DisplayRecord record{adds ? name.substr(1) : name, type, mode, std::nullopt,
                         parameters(where, tokens, "Display")};
    record.quantize = displayQuantize(record.parameters);
    if (!adds)
        options_.displays.clear();
    options_.displays.push_back(std::move(record));
}

void StateHandlers::hider(const SourceLocation &where, const std::string &type,
                          const TokenList &tokens) {
    options_.hider = type;
    for (Parameter &parameter : categorised(tokens, "Hider", "hider"))
        options_.named["hider:" + parameter.name] = parameter;
    if (type != "hidden" && type != "null")
        warnOnce(where, "Hider:" + type,
                 "Hider: this version hides surfaces under \"" + type + "\" as under \"hidden\"");
}

void StateHandlers::relativeDetail(const SourceLocation &where, float detail) {
    if (!(detail >= 0))
        return error(where, "RelativeDetail", "expected a number from 0 up");
    options_.relativeDetail = detail;
    if (detail != 1)
        warnOnce(where, "RelativeDetail",
                 "RelativeDetail: this version draws every level of detail");
}

void StateHandlers::setSearchPath(Parameter &path) {
    std::string text;
    for (const std::string &each : path.strings)
        text += (text.empty() ? "" : ":") + each;
    const auto &standards = settings_.searchPaths;
    std::string standard = path.name == "shader"    ? standards.shader
                           : path.name == "texture" ? standards.texture
                           : path.name == "archive" ? standards.archive
                                                    : "";
    std::string previous = options_.string("searchpath:" + path.name, "");
    path.strings = {expandSearchPath(text, previous, standard)};
}

void StateHandlers::checkIntegrator(const SourceLocation &where, const std::string &name) {
    if (name == "bidir" || name == "radiosity")
        warnOnce(where, "integrator:" + name,
                 "Option \"render\" \"integrator\": this version has no \"" + name +
                     "\" and takes \"path\"");
    else if (name != "path" && name != "classic")
        error(where, "Option",
              "there is no integrator \"" + name +
                  "\": the known ones are \"path\" and \"classic\"; taking \"path\"");
}

void StateHandlers::option(const SourceLocation &where, const std::string &category,
                           const TokenList &tokens) {
    for (Parameter &parameter : categorised(tokens, "Option", category)) {
        if (category == "render" && parameter.name == "integrator" && !parameter.strings.empty())
            checkIntegrator(where, parameter.strings.front());
        if (category == "searchpath" && !parameter.strings.empty())
            setSearchPath(parameter);
        std::string name = category + ":" + parameter.name;
        options_.named[std::move(name)] = std::move(parameter);
    }
}

} // namespace candela

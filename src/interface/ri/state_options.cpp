// SPDX-License-Identifier: Apache-2.0
// Options (RI 3.2, section 4.1).
#include "interface/ri/search_path.h"
#include "interface/ri/state_handlers.h"
#include "interface/ri/state_parameters.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

void StateHandlers::format(const SourceLocation &where, int x, int y, float aspect) {
    const FrameFormat standard;
    if (x == 0 || y == 0 || x > 1 << 20 || y > 1 << 20 || !std::isfinite(aspect) || aspect == 0)
        return diagnostics_.error(where, "Format",
                                  "expected a resolution from 1 to 1048576 and a pixel "
                                  "aspect ratio above 0; the request is left out");
    // RI: a negative value asks for the display's own.
    FrameFormat &format = state_.options.format;
    format.xResolution = x > 0 ? x : standard.xResolution;
    format.yResolution = y > 0 ? y : standard.yResolution;
    format.pixelAspectRatio = aspect > 0 ? aspect : standard.pixelAspectRatio;
    state_.options.places.format = where;
}

void StateHandlers::frameAspectRatio(const SourceLocation &where, float ratio) {
    if (!std::isfinite(ratio) || ratio <= 0)
        return diagnostics_.error(where, "FrameAspectRatio", "expected a ratio above 0");
    state_.options.format.frameAspectRatio = ratio;
}

void StateHandlers::screenWindow(const SourceLocation &where, float left, float right, float bottom,
                                 float top) {
    if (!diagnostics_.finite(where, "ScreenWindow", {left, right, bottom, top}))
        return;
    if (left == right || bottom == top)
        return diagnostics_.error(where, "ScreenWindow",
                                  "the window is empty; the request is left out");
    state_.options.format.screenWindow = {left, right, bottom, top};
}

void StateHandlers::cropWindow(const SourceLocation &where, float x0, float x1, float y0,
                               float y1) {
    std::array<float, 4> window{x0, x1, y0, y1};
    for (float &edge : window)
        edge = std::clamp(edge, 0.0f, 1.0f);
    for (const int low : {0, 2})
        if (window[low] > window[low + 1])
            std::swap(window[low], window[low + 1]);
    if (!(window[0] < window[1] && window[2] < window[3])) // NaN, too.
        return diagnostics_.error(where, "CropWindow",
                                  "expected 0 <= xmin < xmax <= 1 and the same for y; "
                                  "the request is left out");
    if (window != std::array<float, 4>{x0, x1, y0, y1})
        diagnostics_.warning(
            where, "CropWindow",
            "expected 0 <= xmin < xmax <= 1 and the same for y; its edges are taken "
            "in order, and within the frame");
    state_.options.format.cropWindow = window;
    state_.options.places.cropWindow = where;
}

/// The transformation before Projection as the one from projected to screen space.
static Matrix4 screenFromProjected(RequestDiagnostics &diagnostics, const SourceLocation &where,
                                   Matrix4d screen) {
    if (screen.at(2, 0) != 0 || screen.at(2, 1) != 0)
        diagnostics.warning(where, "Projection",
                            "the transformation before it moves the picture with depth; that part "
                            "of it is left out");
    screen.at(2, 0) = screen.at(2, 1) = 0;
    if (inverse(screen.rounded()))
        return screen.rounded();
    diagnostics.error(where, "Projection",
                      "the transformation before it leaves nothing of the picture; it is left out");
    return {};
}

void StateHandlers::projection(const SourceLocation &where, const std::string &name,
                               const TokenList &tokens) {
    const bool none = name == "null" || name.empty();
    const bool orthographic = name == "orthographic" || name == "PxrOrthographic";
    if (name != "perspective" && !orthographic && !none && name != "PxrPerspective" &&
        name != "PxrCamera")
        diagnostics_.warning(where, "Projection",
                             "'" + name +
                                 "' is not known here: it is drawn as \"perspective\" (known are "
                                 "\"perspective\", \"orthographic\" and \"null\")");
    float fieldOfView = parameters_.ofRequest(where, tokens, "Projection").number("fov", 90);
    if (!(fieldOfView > 0 && fieldOfView < 180)) {
        diagnostics_.error(where, "Projection",
                           "expected \"fov\" between 0 and 180 degrees; using 90");
        fieldOfView = 90;
    }
    CameraRecord &camera = state_.options.camera;
    camera.perspective = !orthographic && !none;
    camera.fieldOfView = fieldOfView;
    // RI 3.2, 4.1.1: without a projection, what stands before it leads from the world to the
    // camera; with one, it moves the projected picture, and camera space starts here.
    camera.screenFromProjected = {};
    if (none)
        return;
    camera.screenFromProjected =
        screenFromProjected(diagnostics_, where, state_.transform.current.matrix);
    state_.transform.current = {};
}

void StateHandlers::clipping(const SourceLocation &where, float near, float far) {
    if (!(near > 0 && near < far))
        return diagnostics_.error(where, "Clipping",
                                  "expected 0 < near < far; the request is left out");
    state_.options.camera.near = near;
    state_.options.camera.far = far;
}

void StateHandlers::clippingPlane(const SourceLocation &where, float x, float y, float z, float nx,
                                  float ny, float nz) {
    const Matrix4 cameraFromHere = state_.transform.current.matrix.rounded();
    const std::optional<Matrix4> inverted = inverse(cameraFromHere);
    if (!diagnostics_.finite(where, "ClippingPlane", {x, y, z, nx, ny, nz}))
        return;
    const Vec3 normal =
        inverted ? normalize(transformNormal(*inverted, normalize(Vec3{nx, ny, nz}))) : Vec3{};
    if (!(length(normal) > 0))
        return diagnostics_.error(where, "ClippingPlane",
                                  "expected a normal that is not zero; the plane is left out");
    state_.options.camera.clippingPlanes.push_back(
        {transformPoint(cameraFromHere, {x, y, z}), normal});
}

void StateHandlers::depthOfField(const SourceLocation &where, const LooseFloats &given) {
    CameraRecord &camera = state_.options.camera;
    if (given.values.empty()) {
        camera.fStop = camera.focalLength = camera.focalDistance = 0;
        return;
    }
    if (given.values.size() != 3)
        return diagnostics_.error(where, "DepthOfField",
                                  "expected fstop, focal length and focal distance, or "
                                  "nothing for a pinhole");
    auto [fStop, length, distance] = std::tuple(given.values[0], given.values[1], given.values[2]);
    if (!(fStop > 0 && length > 0 && distance > 0))
        return diagnostics_.error(where, "DepthOfField", "expected three numbers above 0");
    bool pinhole = !std::isfinite(fStop) || fStop >= 1e30f; // RI_INFINITY
    camera.fStop = pinhole ? 0 : fStop;
    camera.focalLength = length;
    camera.focalDistance = distance;
}

void StateHandlers::shutter(const SourceLocation &where, float open, float close) {
    if (!diagnostics_.finite(where, "Shutter", {open, close}))
        return;
    if (open > close)
        return diagnostics_.error(where, "Shutter",
                                  "expected an opening time before the closing time");
    state_.options.camera.shutterOpen = open;
    state_.options.camera.shutterClose = close;
}

void StateHandlers::pixelVariance(const SourceLocation &where, float variation) {
    if (!(variation >= 0))
        return diagnostics_.error(where, "PixelVariance", "expected a number from 0 up");
    state_.options.pixelVariance = variation;
}

void StateHandlers::pixelSamples(const SourceLocation &where, float x, float y) {
    if (!(x >= 1 && y >= 1 && double(x) * y <= maximumSamplesPerPixel))
        return diagnostics_.error(where, "PixelSamples",
                                  "expected two numbers from 1 up, with a product of at most " +
                                      std::to_string(maximumSamplesPerPixel));
    state_.options.xSamples = x;
    state_.options.ySamples = y;
}

void StateHandlers::pixelFilter(const SourceLocation &where, const std::string &name, float x,
                                float y) {
    if (!(x > 0 && y > 0 && x <= 1000 && y <= 1000))
        return diagnostics_.error(where, "PixelFilter",
                                  "expected widths above 0, at most 1000 pixels");
    state_.options.filter = {name, x, y};
    state_.options.places.pixelFilter = where;
}

void StateHandlers::exposure(const SourceLocation &where, float gain, float gamma) {
    if (!(gain >= 0 && gamma > 0) || !diagnostics_.finite(where, "Exposure", {gain, gamma}))
        return diagnostics_.error(where, "Exposure",
                                  "expected a gain from 0 up and a gamma above 0");
    state_.options.exposure = {gain, gamma};
}

void StateHandlers::quantize(const SourceLocation &where, const std::string &type, int one,
                             int minimum, int maximum, float dither) {
    if (!std::isfinite(dither) || one < 0 || minimum > maximum)
        return diagnostics_.error(where, "Quantize", "expected one >= 0 and minimum <= maximum");
    QuantizeRecord record{float(one), float(minimum), float(maximum), dither};
    if (type == "rgba" || type == "rgb")
        state_.options.colorQuantize = record;
    else if (type == "z")
        state_.options.depthQuantize = record;
    else
        state_.options.channelQuantize[type] = record;
}

static std::optional<QuantizeRecord> displayQuantize(const ParameterList &list) {
    const Parameter *levels = list.find("quantize"); // zero, one, minimum, maximum
    if (!levels || levels->floats.size() != 4)
        return std::nullopt;
    const Floats &v = levels->floats;
    return QuantizeRecord{v[1], v[2], v[3], list.number("dither", v[1] > 0 ? 0.5f : 0.0f), v[0]};
}

/// PRMan's: a channel's declaration, and where it comes from if it is not what its name says.
void StateHandlers::displayChannel(const SourceLocation &where, const std::string &token,
                                   const TokenList &tokens) {
    const auto parsed = parseToken(token);
    if (!parsed || parsed->name.empty())
        return diagnostics_.error(where, "DisplayChannel",
                                  "'" + token +
                                      "' is no channel: expected its type and name, as in "
                                      "\"varying color diffuse\"");
    const ParameterList parameters = parameters_.ofRequest(where, tokens, "DisplayChannel");
    const std::string source = parameters.string("source", parsed->name);
    const auto sourceToken = parseToken(source);
    state_.options.channels[parsed->name] = sourceToken ? sourceToken->name : source;
}

/// The names of a display's mode, those of channels replaced by what these show.
static std::string modeOfChannels(const std::string &mode,
                                  const std::map<std::string, std::string> &channels) {
    std::string result;
    for (std::size_t begin = 0; begin <= mode.size();) {
        const std::size_t end = std::min(mode.find(',', begin), mode.size());
        const std::string name = mode.substr(begin, end - begin);
        const auto found = channels.find(name);
        result += (begin ? "," : "") + (found == channels.end() ? name : found->second);
        begin = end + 1;
    }
    return result;
}

void StateHandlers::display(const SourceLocation &where, const std::string &name,
                            const std::string &type, const std::string &mode,
                            const TokenList &tokens) {
    bool adds = name.starts_with("+");
    DisplayRecord record{adds ? name.substr(1) : name, type,
                         modeOfChannels(mode, state_.options.channels), std::nullopt,
                         parameters_.ofRequest(where, tokens, "Display")};
    if (type == "deepshad") {
        record.type = "shadow", record.mode = "z";
        diagnostics_.warnOnce(where, "Display:deepshad",
                              "Display \"" + name +
                                  "\": there are no deep shadow maps: it will be a shadow map of "
                                  "depths, in which all that is met is opaque");
    }
    record.quantize = displayQuantize(record.parameters);
    record.isAdded = adds;
    std::vector<DisplayRecord> &displays = state_.options.displays;
    if (adds)
        return displays.push_back(std::move(record));
    // What was added to nothing yet waits for this one; else it replaces all that there are.
    if (!std::ranges::all_of(displays, &DisplayRecord::isAdded))
        displays.clear();
    displays.insert(displays.begin(), std::move(record));
}

void StateHandlers::hider(const SourceLocation &where, const std::string &type,
                          const TokenList &tokens) {
    state_.options.hider = type;
    for (Parameter &parameter : parameters_.ofCategory(tokens, "Hider", "hider"))
        state_.options.named["hider:" + parameter.name] = parameter;
    if (type != "hidden" && type != "null")
        diagnostics_.warnOnce(where, "Hider:" + type,
                              "Hider: this version hides surfaces under \"" + type +
                                  "\" as under \"hidden\"");
}

void StateHandlers::relativeDetail(const SourceLocation &where, float detail) {
    if (!(detail >= 0))
        return diagnostics_.error(where, "RelativeDetail", "expected a number from 0 up");
    state_.options.relativeDetail = detail;
}

/// What the path's text stands for becomes its value. False if it has more folders than may be.
static bool expandSearchPath(Parameter &path, const GraphicsStateSettings::SearchPaths &standards,
                             const Options &options, const SourceLocation &where) {
    std::string text;
    for (const std::string &each : path.strings)
        text += (text.empty() ? "" : ":") + each;
    std::string standard = path.name == "shader"    ? standards.shader
                           : path.name == "texture" ? standards.texture
                           : path.name == "archive" ? standards.archive
                                                    : "";
    std::string previous = options.named.string("searchpath:" + path.name, "");
    path.strings = {withFoldersBeside(expandSearchPath(text, previous, standard),
                                      where.file ? *where.file : std::string())};
    return splitSearchPath(text).size() <= mostSearchFolders;
}

void StateHandlers::option(const SourceLocation &where, const std::string &category,
                           const TokenList &tokens) {
    for (Parameter &parameter : parameters_.ofCategory(tokens, "Option", category)) {
        if (!checkStateParameter(diagnostics_, where, "Option", category, parameter))
            continue;
        if (category == "searchpath" && !parameter.strings.empty() &&
            !expandSearchPath(parameter, settings_.searchPaths, state_.options, where))
            diagnostics_.warning(where, "Option",
                                 "a search path has at most " + std::to_string(mostSearchFolders) +
                                     " folders; those behind them are left out");
        std::string name = category + ":" + parameter.name;
        state_.options.named[std::move(name)] = std::move(parameter);
    }
}

} // namespace candela

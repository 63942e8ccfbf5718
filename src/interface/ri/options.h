// SPDX-License-Identifier: Apache-2.0
// The options of a frame: all that WorldBegin freezes. Names and defaults: RI 3.2 section 4.1.
#pragma once

#include "foundation/base/matrix4d.h"
#include "interface/ri/attributes.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// A pixel filter's name as RI spells it ("gaussian", "box", ...) and its full widths in pixels.
struct PixelFilterRecord {
    std::string name = "gaussian";
    float xWidth = 2, yWidth = 2;
};

/// RiQuantize: round(one * value + dither * random), clamped; one == 0 leaves floats. A display's
/// own may say what 0 becomes, too.
struct QuantizeRecord {
    float one = 0, minimum = 0, maximum = 0, ditherAmplitude = 0, zero = 0;
};

/// More samples of a pixel would do no good and are not counted.
inline constexpr int maximumSamplesPerPixel = 1 << 24;

/// RiExposure: (light * gain)^(1 / gamma).
struct ExposureRecord {
    float gain = 1, gamma = 1;
};

struct DisplayRecord {
    std::string name;                       ///< File name, without the leading '+'.
    std::string type;                       ///< "file", "openexr", "png", ...
    std::string mode;                       ///< "rgb", "rgba", "z", ... or the name of a channel.
    std::optional<QuantizeRecord> quantize; ///< Given with this display; else Options'.
    ParameterList parameters;
    bool isAdded = false; ///< Its name had the '+'.
};

/// RiClippingPlane, in camera space: what lies where the normal leads to is cut away.
struct ClippingPlaneRecord {
    Vec3 point, normal; ///< Of unit length.
};

struct CameraRecord {
    bool perspective = false;
    float fieldOfView = 90; ///< Degrees across the narrower axis of the default screen window.
    float near = 1e-10f, far = 1e30f;
    std::vector<ClippingPlaneRecord> clippingPlanes;
    Matrix4 cameraFromWorld; ///< The CTM at WorldBegin, when the shutter opens.
    Matrix4d
        exactCameraFromWorld; ///< The same before it was rounded: for points of far-off worlds.
    TransformMotion::Shared motion; ///< cameraFromWorld in time; null: the camera stands still.
    /// What stood before Projection (RI 3.2, 4.1.1): moves the projected picture, where the screen
    /// window is, and its depth. Affine, invertible, and x and y do not depend on z.
    Matrix4 screenFromProjected;
    float shutterOpen = 0, shutterClose = 0;
    float fStop = 0, focalLength = 0, focalDistance = 0; ///< fStop 0 = pinhole.
};

/// Which part of the screen the picture shows, and in how many pixels (RI 3.2, 4.1.1).
struct FrameFormat {
    int xResolution = 640, yResolution = 480;
    float pixelAspectRatio = 1;
    std::optional<float> frameAspectRatio;
    std::optional<std::array<float, 4>> screenWindow; ///< left, right, bottom, top.
    std::array<float, 4> cropWindow{0, 1, 0, 1};      ///< x0, x1, y0, y1 in NDC.

    /// Screen window and resolution after aspect ratios have been applied: where the frame aspect
    /// ratio disagrees with the resolution, the picture is made smaller to fit.
    std::array<float, 4> effectiveScreenWindow() const;
    std::array<int, 2> effectiveResolution() const;
    /// First and one-past-last pixel of the crop window: x0, x1, y0, y1.
    std::array<int, 4> cropPixels() const;
};

struct Options {
    FrameFormat format;
    CameraRecord camera;

    float xSamples = 2, ySamples = 2;
    std::optional<float> pixelVariance;
    PixelFilterRecord filter;
    std::vector<ShaderRecord> filters; ///< PushFilter, in the order in which they run.
    /// Unset: light as it is; PNG pictures that nobody quantises either show it by the curve of
    /// sRGB.
    std::optional<ExposureRecord> exposure;
    std::optional<ShaderRecord> imager;          ///< Unset = none.
    std::optional<QuantizeRecord> colorQuantize; ///< RiQuantize "rgba"; unset = display's default.
    std::optional<QuantizeRecord> depthQuantize; ///< RiQuantize "z".
    std::map<std::string, QuantizeRecord> channelQuantize; ///< And of any other channel, by name.
    std::vector<DisplayRecord> displays;                   ///< Empty = the default display.
    std::map<std::string, std::string> channels; ///< DisplayChannel: name to what it shows.
    std::string hider = "hidden";
    float relativeDetail = 1;
    int frame = 0;

    /// Where some of the requests stand, for messages; empty if they do not.
    struct Places {
        SourceLocation format, cropWindow, pixelFilter;
    } places;

    NamedParameters named; ///< RiOption.
    /// Named coordinate systems, each as currentFromSpace; "world", "camera" among them.
    std::map<std::string, Matrix4> coordinateSystems;
};

} // namespace candela

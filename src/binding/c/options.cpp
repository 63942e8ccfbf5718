// SPDX-License-Identifier: Apache-2.0
// Options (RI 3.2, 4.1).
#include "binding/c/calls.h"

using namespace candela;
using namespace candela::c;

// clang-format off
RI_PLAIN(Format, (RtInt xResolution, RtInt yResolution, RtFloat pixelAspectRatio), format(ri.at(), xResolution, yResolution, pixelAspectRatio))
RI_PLAIN(FrameAspectRatio, (RtFloat ratio), frameAspectRatio(ri.at(), ratio))
RI_PLAIN(ScreenWindow, (RtFloat left, RtFloat right, RtFloat bottom, RtFloat top), screenWindow(ri.at(), left, right, bottom, top))
RI_PLAIN(CropWindow, (RtFloat xMin, RtFloat xMax, RtFloat yMin, RtFloat yMax), cropWindow(ri.at(), xMin, xMax, yMin, yMax))
RI_LISTED(Projection, name, (RtToken name), (name), projection(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(Clipping, (RtFloat hither, RtFloat yon), clipping(ri.at(), hither, yon))
RI_PLAIN(ClippingPlane, (RtFloat x, RtFloat y, RtFloat z, RtFloat nx, RtFloat ny, RtFloat nz), clippingPlane(ri.at(), x, y, z, nx, ny, nz))
RI_PLAIN(DepthOfField, (RtFloat fStop, RtFloat focalLength, RtFloat focalDistance), depthOfField(ri.at(), {{fStop, focalLength, focalDistance}}))
RI_PLAIN(Shutter, (RtFloat opening, RtFloat closing), shutter(ri.at(), opening, closing))
RI_PLAIN(PixelVariance, (RtFloat variation), pixelVariance(ri.at(), variation))
RI_PLAIN(PixelSamples, (RtFloat x, RtFloat y), pixelSamples(ri.at(), x, y))
RI_PLAIN(Exposure, (RtFloat gain, RtFloat gamma), exposure(ri.at(), gain, gamma))
RI_LISTED(Imager, name, (RtToken name), (name), imager(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(Quantize, (RtToken type, RtInt one, RtInt minimum, RtInt maximum, RtFloat ditherAmplitude), quantize(ri.at(), text(type), one, minimum, maximum, ditherAmplitude))
RI_LISTED(Display, mode, (RtToken name, RtToken type, RtToken mode), (name, type, mode), display(ri.at(), text(name), text(type), text(mode), ri.list(single, {n, tokens, values})))
RI_LISTED(DisplayChannel, channel, (RtToken channel), (channel), displayChannel(ri.at(), text(channel), ri.list(single, {n, tokens, values})))
RI_LISTED(Hider, type, (RtToken type), (type), hider(ri.at(), text(type), ri.list(single, {n, tokens, values})))
RI_PLAIN(ColorSamples, (RtInt n, const RtFloat *nRGB, const RtFloat *RGBn), colorSamples(ri.at(), floats(3 * n, nRGB), floats(3 * n, RGBn)))
RI_PLAIN(RelativeDetail, (RtFloat detail), relativeDetail(ri.at(), detail))
RI_LISTED(Option, name, (RtToken name), (name), option(ri.at(), text(name), ri.list(single, {n, tokens, values}, text(name))))

// SPDX-License-Identifier: Apache-2.0
// Filters, and textures from pictures (RI 3.2, section 7).
#include "binding/c/calls.h"

#include <cmath>

using namespace candela;
using namespace candela::c;

RtFloat RiBoxFilter(RtFloat, RtFloat, RtFloat, RtFloat) { return 1; }

RtFloat RiTriangleFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth) {
    return std::max(0.f, 1 - std::fabs(2 * x / xWidth)) *
           std::max(0.f, 1 - std::fabs(2 * y / yWidth));
}

RtFloat RiCatmullRomFilter(RtFloat x, RtFloat y, RtFloat, RtFloat) {
    const float r = std::hypot(x, y);
    if (r >= 2)
        return 0;
    return r < 1 ? ((3 * r - 5) * r * r + 2) / 2 : (((-r + 5) * r - 8) * r + 4) / 2;
}

RtFloat RiGaussianFilter(RtFloat x, RtFloat y, RtFloat xWidth, RtFloat yWidth) {
    const float u = 2 * x / xWidth, v = 2 * y / yWidth;
    return std::exp(-2 * (u * u + v * v));
}

RtFloat RiSincFilter(RtFloat x, RtFloat y, RtFloat, RtFloat) {
    const auto sinc = [](float t) {
        return t == 0 ? 1 : std::sin(float(M_PI) * t) / (float(M_PI) * t);
    };
    return sinc(x) * sinc(y);
}

/// The name of a filter; one's own is reported, and the Gaussian taken.
static std::string nameOf(Context &ri, RtFilterFunc filter) {
    const std::pair<RtFilterFunc, const char *> known[] = {{RiBoxFilter, "box"},
                                                           {RiTriangleFilter, "triangle"},
                                                           {RiCatmullRomFilter, "catmull-rom"},
                                                           {RiGaussianFilter, "gaussian"},
                                                           {RiSincFilter, "sinc"}};
    for (const auto &[function, name] : known)
        if (filter == function)
            return name;
    ri.error("filters of one's own cannot be used; it is \"gaussian\" instead");
    return "gaussian";
}

RI_PLAIN(PixelFilter, (RtFilterFunc filter, RtFloat xWidth, RtFloat yWidth),
         pixelFilter(ri.at(), nameOf(ri, filter), xWidth, yWidth))

RI_LISTED(MakeTexture, tWidth,
          (RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap, RtFilterFunc filter,
           RtFloat sWidth, RtFloat tWidth),
          (picture, texture, sWrap, tWrap, filter, sWidth, tWidth),
          makeTexture(ri.at(), text(picture), text(texture), text(sWrap), text(tWrap),
                      nameOf(ri, filter), sWidth, tWidth, ri.list(single, {n, tokens, values})))
RI_LISTED(MakeBump, tWidth,
          (RtToken picture, RtToken texture, RtToken sWrap, RtToken tWrap, RtFilterFunc filter,
           RtFloat sWidth, RtFloat tWidth),
          (picture, texture, sWrap, tWrap, filter, sWidth, tWidth),
          makeBump(ri.at(), text(picture), text(texture), text(sWrap), text(tWrap),
                   nameOf(ri, filter), sWidth, tWidth, ri.list(single, {n, tokens, values})))
RI_LISTED(MakeLatLongEnvironment, tWidth,
          (RtToken picture, RtToken texture, RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth),
          (picture, texture, filter, sWidth, tWidth),
          makeLatLongEnvironment(ri.at(), text(picture), text(texture), nameOf(ri, filter), sWidth,
                                 tWidth, ri.list(single, {n, tokens, values})))
RI_LISTED(MakeCubeFaceEnvironment, tWidth,
          (RtToken px, RtToken nx, RtToken py, RtToken ny, RtToken pz, RtToken nz, RtToken texture,
           RtFloat fieldOfView, RtFilterFunc filter, RtFloat sWidth, RtFloat tWidth),
          (px, nx, py, ny, pz, nz, texture, fieldOfView, filter, sWidth, tWidth),
          makeCubeFaceEnvironment(ri.at(), text(px), text(nx), text(py), text(ny), text(pz),
                                  text(nz), text(texture), fieldOfView, nameOf(ri, filter), sWidth,
                                  tWidth, ri.list(single, {n, tokens, values})))
RI_LISTED(MakeShadow, texture, (RtToken picture, RtToken texture), (picture, texture),
          makeShadow(ri.at(), text(picture), text(texture), ri.list(single, {n, tokens, values})))

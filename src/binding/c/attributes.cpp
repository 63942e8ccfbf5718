// SPDX-License-Identifier: Apache-2.0
// Attributes (RI 3.2, 4.2).
#include "binding/c/calls.h"

#include <array>
#include <utility>

using namespace candela;
using namespace candela::c;

RtBasis RiBezierBasis = {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}};
RtBasis RiBSplineBasis = {{-1.f / 6, 3.f / 6, -3.f / 6, 1.f / 6},
                          {3.f / 6, -6.f / 6, 3.f / 6, 0},
                          {-3.f / 6, 0, 3.f / 6, 0},
                          {1.f / 6, 4.f / 6, 1.f / 6, 0}};
RtBasis RiCatmullRomBasis = {
    {-.5f, 1.5f, -1.5f, .5f}, {1, -2.5f, 2, -.5f}, {-.5f, 0, .5f, 0}, {0, 1, 0, 0}};
RtBasis RiHermiteBasis = {{2, 1, -2, 1}, {-3, -2, 3, -1}, {0, 1, 0, 0}, {1, 0, 0, 0}};
RtBasis RiPowerBasis = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};

/// By its name, if it is one of these.
static BasisArgument basisOf(const RtBasis basis) {
    const std::pair<const RtBasis &, const char *> named[] = {{RiBezierBasis, "bezier"},
                                                              {RiBSplineBasis, "b-spline"},
                                                              {RiCatmullRomBasis, "catmull-rom"},
                                                              {RiHermiteBasis, "hermite"},
                                                              {RiPowerBasis, "power"}};
    for (const auto &[matrix, name] : named)
        if (basis == matrix)
            return name;
    std::array<float, 16> numbers{};
    std::copy(&basis[0][0], &basis[0][0] + 16, numbers.begin());
    return numbers;
}

// clang-format off
RI_LISTED(Attribute, name, (RtToken name), (name), attribute(ri.at(), text(name), ri.list(single, {n, tokens, values}, text(name))))
RI_PLAIN(Color, (const RtFloat *color), color(ri.at(), colorOf(color)))
RI_PLAIN(Opacity, (const RtFloat *color), opacity(ri.at(), colorOf(color)))
RI_PLAIN(TextureCoordinates, (RtFloat s1, RtFloat t1, RtFloat s2, RtFloat t2, RtFloat s3, RtFloat t3, RtFloat s4, RtFloat t4), textureCoordinates(ri.at(), s1, t1, s2, t2, s3, t3, s4, t4))
RI_PLAIN(Illuminate, (RtLightHandle light, RtBoolean on), illuminate(ri.at(), ri.nameOf(light), on != 0))
RI_LISTED(Surface, name, (RtToken name), (name), surface(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Displacement, name, (RtToken name), (name), displacement(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Atmosphere, name, (RtToken name), (name), atmosphere(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Interior, name, (RtToken name), (name), interior(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Exterior, name, (RtToken name), (name), exterior(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_LISTED(Deformation, name, (RtToken name), (name), deformation(ri.at(), text(name), ri.list(single, {n, tokens, values})))
RI_PLAIN(ShadingRate, (RtFloat size), shadingRate(ri.at(), size))
RI_PLAIN(ShadingInterpolation, (RtToken type), shadingInterpolation(ri.at(), text(type)))
RI_PLAIN(Matte, (RtBoolean on), matte(ri.at(), on != 0))
RI_PLAIN(Bound, (const RtFloat *bound), bound(ri.at(), bound[0], bound[1], bound[2], bound[3], bound[4], bound[5]))
RI_PLAIN(Detail, (const RtFloat *bound), detail(ri.at(), bound[0], bound[1], bound[2], bound[3], bound[4], bound[5]))
RI_PLAIN(DetailRange, (RtFloat minVisible, RtFloat lowerTransition, RtFloat upperTransition, RtFloat maxVisible), detailRange(ri.at(), minVisible, lowerTransition, upperTransition, maxVisible))
RI_PLAIN(GeometricApproximation, (RtToken type, RtFloat value), geometricApproximation(ri.at(), text(type), value))
RI_PLAIN(GeometricRepresentation, (RtToken type), geometricRepresentation(ri.at(), text(type)))
RI_PLAIN(Orientation, (RtToken orientation), orientation(ri.at(), text(orientation)))
RI_PLAIN(ReverseOrientation, (), reverseOrientation(ri.at()))
RI_PLAIN(Sides, (RtInt sides), sides(ri.at(), sides))
// clang-format on

void RiBasis(RtBasis uBasis, RtInt uStep, RtBasis vBasis, RtInt vStep) {
    perform("RiBasis", [&](Context &ri) {
        ri.sink().basis(ri.at(), basisOf(uBasis), uStep, basisOf(vBasis), vStep);
        if (uStep > 0 && vStep > 0)
            ri.setSteps(uStep, vStep);
    });
}

void RiTrimCurve(RtInt loops, const RtInt *curves, const RtInt *orders, const RtFloat *knots,
                 const RtFloat *minima, const RtFloat *maxima, const RtInt *points,
                 const RtFloat *u, const RtFloat *v, const RtFloat *w) {
    perform("RiTrimCurve", [&](Context &ri) {
        const RtInt count = sum(loops, curves), vertices = sum(count, points);
        ri.sink().trimCurve(ri.at(), integers(loops, curves), integers(count, orders),
                            floats(vertices + sum(count, orders), knots), floats(count, minima),
                            floats(count, maxima), integers(count, points), floats(vertices, u),
                            floats(vertices, v), floats(vertices, w));
    });
}

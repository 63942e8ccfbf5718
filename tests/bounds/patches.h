// SPDX-License-Identifier: Apache-2.0
// Pieces of surface whose derivatives, and what these leave out, are known in closed form.
#pragma once

#include "world/shading/shader_bounds.h"

#include <array>
#include <cmath>

namespace candela::bounds {

/// A box of (u, v).
struct Box {
    double u, v, Du, Dv;
};

enum class Patch { Square, Cylinder, Sphere };
inline constexpr Patch patches[] = {Patch::Square, Patch::Cylinder, Patch::Sphere};
inline const char *nameOf(Patch patch) {
    return patch == Patch::Square ? "square" : patch == Patch::Cylinder ? "cylinder" : "sphere";
}

using Vector = std::array<double, 3>;

/// A place on a patch, and how P changes there; N is P's on the round ones, and (0, 0, -1).
struct Place {
    Vector P, N, dPdu, dPdv, dNdu, dNdv;
};

inline Place placeAt(Patch patch, double u, double v) {
    if (patch == Patch::Square)
        return {{2 * u - 1, 1 - 2 * v, 3}, {0, 0, -1}, {2, 0, 0}, {0, -2, 0}, {}, {}};
    // A third of a turn about the y axis, whose middle looks at the eye.
    const double a = 2 * (u - .5), s = std::sin(a), c = std::cos(a);
    if (patch == Patch::Cylinder) {
        const Vector N{s, 0, -c}, byU{2 * c, 0, 2 * s};
        return {{s, 1 - 2 * v, 3 - c}, N, byU, {0, -2, 0}, byU, {}};
    }
    const double b = 2 * (v - .5), S = std::sin(b), C = std::cos(b);
    const Vector N{s * C, -S, -c * C}, byU{2 * c * C, 0, 2 * s * C},
        byV{-2 * s * S, -2 * C, 2 * c * S};
    return {{N[0], N[1], 3 + N[2]}, N, byU, byV, byU, byV};
}

/// Sets what a shader reads of a place; `field` turns the uniform field, which does not turn within
/// a box.
inline void put(BoxBounds &boxes, int lane, Patch patch, double u, double v, const Vector &field) {
    const Place at = placeAt(patch, u, v);
    const auto vector = [&](ShaderInput input, const Vector &x) {
        boxes.set(input, lane, {float(x[0]), float(x[1]), float(x[2])});
    };
    vector(ShaderInput::P, at.P);
    vector(ShaderInput::N, at.N);
    vector(ShaderInput::Ng, at.N);
    vector(ShaderInput::dPdu, at.dPdu);
    vector(ShaderInput::dPdv, at.dPdv);
    vector(ShaderInput::dNdu, at.dNdu);
    vector(ShaderInput::dNdv, at.dNdv);
    vector(ShaderInput::dNgdu, at.dNdu);
    vector(ShaderInput::dNgdv, at.dNdv);
    vector(ShaderInput::I, {.25, .4, 1});
    vector(ShaderInput::fieldAxis, field);
    for (ShaderInput across : {ShaderInput::u, ShaderInput::s})
        boxes.set(across, lane, {float(u)});
    for (ShaderInput down : {ShaderInput::v, ShaderInput::t})
        boxes.set(down, lane, {float(v)});
    boxes.set(ShaderInput::dsdu, lane, {1});
    boxes.set(ShaderInput::dtdv, lane, {1});
    boxes.set(ShaderInput::orientation, lane, {1});
    boxes.set(ShaderInput::du, lane, {1.0f / 256});
    boxes.set(ShaderInput::dv, lane, {1.0f / 256});
    boxes.set(ShaderInput::Cs, lane, {.8f, .6f, .3f});
    boxes.set(ShaderInput::Os, lane, {1, .9f, .8f});
}

/// The same of a box, with its extents and with what derivatives leave out: nothing on the square;
/// on the round patches, whose second derivatives are at most 4 (along each parameter, and by both),
/// half of that times the squared way to a corner.
inline void put(BoxBounds &boxes, int lane, Patch patch, const Box &box) {
    put(boxes, lane, patch, box.u, box.v, placeAt(patch, box.u, box.v).N);
    const double way = patch == Patch::Square     ? 0
                       : patch == Patch::Cylinder ? box.Du / 2
                                                  : (box.Du + box.Dv) / 2;
    const double rest = 2 * way * way * (1 + 1e-6) + (way > 0 ? 1e-6 : 0);
    const double ofSlopes = 4 * way * (1 + 1e-6);
    boxes.set(ShaderInput::Du, lane, {float(box.Du)});
    boxes.set(ShaderInput::Dv, lane, {float(box.Dv)});
    for (ShaderInput input : {ShaderInput::PRest, ShaderInput::NRest})
        boxes.set(input, lane, {float(rest)});
    for (ShaderInput input : {ShaderInput::dPRest, ShaderInput::dRest})
        boxes.set(input, lane, {float(ofSlopes)});
}

} // namespace candela::bounds

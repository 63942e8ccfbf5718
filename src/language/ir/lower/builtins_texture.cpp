// SPDX-License-Identifier: Apache-2.0
// Lookups of pictures by name: texture(), environment(), shadow(), bump(), textureinfo() (RI 3.2,
// section 15.7). The renderer answers them; the text says where, and over how much.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/footprints.h"
#include "language/ir/lower/lookup_options.h"
#include "language/ir/lower/place_scope.h"
#include "language/ir/lower/told_values.h"

namespace candela::ir {
namespace {

/// The name of a picture may be chosen at run time.
ValueId fileOf(const BuiltinCall &call) { return call.arguments[0][0]; }

void coordinatesFault(BuiltinCall &call, const std::string &expected) {
    call.lowering.messages.error(call.expr.where, std::string(call.expr.overload->function->name) +
                                                      "() takes " + expected);
}

/// A quantity, how far it reaches along the axes of the footprint, and by how much it differs in
/// the footprint's middle.
struct Reach {
    ValueId at, x, y, shift;
};

Reach reachOf(Lowering &lowering, ValueId at) {
    const Extent extent = extentOf(lowering, at);
    return {at, extent.x, extent.y, extent.shift};
}

ValueId meanOfFour(Builder &b, const ValueId *corner) {
    return mul(b, add(b, add(b, corner[0], corner[1]), add(b, corner[2], corner[3])),
               number(b, 0.25f));
}

/// Of an area with four corners, in the order of TextureCoordinates: the middle, and the mean
/// lengths of the sides that face each other.
Reach reachOfCorners(Builder &b, const ValueId *corner) {
    const auto meanOf = [&](ValueId x, ValueId y) { return mul(b, add(b, x, y), number(b, 0.5f)); };
    return {meanOfFour(b, corner),
            meanOf(sub(b, corner[1], corner[0]), sub(b, corner[3], corner[2])),
            meanOf(sub(b, corner[2], corner[0]), sub(b, corner[3], corner[1])), number(b, 0)};
}

bool areFloats(const BuiltinCall &call, size_t first, size_t end) {
    for (size_t k = first; k < end; ++k)
        if (call.expr.operands[k]->type.base != sl::BaseType::Float)
            return false;
    return true;
}

/// s and t that stand from argument `first` on; without any, the surface's.
std::array<Reach, 2> surfaceReach(BuiltinCall &call, size_t first, size_t end) {
    Lowering &lowering = call.lowering;
    const size_t count = end - first;
    const bool fits = (count == 0 || count == 2 || count == 8) && areFloats(call, first, end);
    if (!fits || (count == 0 && sl::runsFor(lowering.shader.kind) == sl::RunsFor::Picture)) {
        coordinatesFault(call, "a name, then s and t or four pairs of them");
        const ValueId none = number(call.b, 0);
        return {Reach{none, none, none, none}, {none, none, none, none}};
    }
    if (count == 0)
        return {reachOf(lowering, lowering.variables.load(sl::PredefinedId::s)[0]),
                reachOf(lowering, lowering.variables.load(sl::PredefinedId::t)[0])};
    if (count == 2)
        return {reachOf(lowering, call.number(first)), reachOf(lowering, call.number(first + 1))};
    ValueId s[4], t[4];
    for (size_t k = 0; k < 4; ++k)
        s[k] = call.number(first + 2 * k), t[k] = call.number(first + 2 * k + 1);
    return {reachOfCorners(call.b, s), reachOfCorners(call.b, t)};
}

/// A point or direction, or four of them, behind the name.
std::array<Reach, 3> spatialReach(BuiltinCall &call, const char *what) {
    const size_t count = firstOption(call) - 1;
    bool fits = count == 1 || count == 4;
    for (size_t k = 1; k <= count; ++k)
        fits &= sl::isGeometric(call.expr.operands[k]->type.base);
    std::array<Reach, 3> reach;
    if (!fits) {
        coordinatesFault(call, std::string("a name, then a ") + what + " or four of them");
        const ValueId none = number(call.b, 0);
        reach.fill({none, none, none, none});
        return reach;
    }
    for (size_t c = 0; c < 3; ++c) {
        if (count == 1) {
            reach[c] = reachOf(call.lowering, call.arguments[1][c]);
            continue;
        }
        const ValueId corner[] = {call.arguments[1][c], call.arguments[2][c], call.arguments[3][c],
                                  call.arguments[4][c]};
        reach[c] = reachOfCorners(call.b, corner);
    }
    return reach;
}

/// A float, or a color of what has been answered in red, green and blue.
Components asResult(BuiltinCall &call, const Values &answer) {
    if (call.result() == sl::BaseType::Float)
        return {answer[0]};
    return colorOf(call.b, {answer[0], answer[1], answer[2]});
}
int channelsOf(const BuiltinCall &call) { return call.result() == sl::BaseType::Float ? 1 : 3; }

Values textureOperands(Builder &b, const std::array<Reach, 2> &at, const LookupOptions &o) {
    const auto &[s, t] = at;
    // A picture that is wanted as it stands is wanted at the very point.
    const auto shift = [&](const Reach &reach, ValueId width) {
        const ValueId none = number(b, 0);
        return select(b, equal(b, width, none), none, reach.shift);
    };
    return {s.at,
            t.at,
            mul(b, s.x, o.sWidth),
            mul(b, t.x, o.tWidth),
            mul(b, s.y, o.sWidth),
            mul(b, t.y, o.tWidth),
            o.sBlur,
            o.tBlur,
            o.channel,
            o.fill,
            shift(s, o.sWidth),
            shift(t, o.tWidth)};
}

Components texture(BuiltinCall &call) {
    const PlaceScope place(call.b, call.expr.where);
    const LookupOptions options = readLookupOptions(call);
    const auto at = surfaceReach(call, 1, firstOption(call));
    return asResult(call, queryNamed(call.b, info(Service::texture), fileOf(call), {},
                                     textureOperands(call.b, at, options), channelsOf(call)));
}

/// Points or directions, then their changes along x, then those along y.
Values spatialOperands(Builder &b, const std::array<Reach, 3> &reach, const LookupOptions &o) {
    Values operands;
    for (const Reach &each : reach)
        operands.push_back(each.at);
    for (const Reach &each : reach)
        operands.push_back(mul(b, each.x, o.sWidth));
    for (const Reach &each : reach)
        operands.push_back(mul(b, each.y, o.tWidth));
    operands.push_back(o.sBlur);
    operands.push_back(o.tBlur);
    return operands;
}

Components environment(BuiltinCall &call) {
    const PlaceScope place(call.b, call.expr.where);
    const LookupOptions options = readLookupOptions(call);
    Values operands = spatialOperands(call.b, spatialReach(call, "direction"), options);
    operands.push_back(options.channel);
    operands.push_back(options.fill);
    return asResult(call, queryNamed(call.b, info(Service::environment), fileOf(call), {}, operands,
                                     channelsOf(call)));
}

Components shadow(BuiltinCall &call) {
    const PlaceScope place(call.b, call.expr.where);
    const LookupOptions options = readLookupOptions(call);
    Values operands = spatialOperands(call.b, spatialReach(call, "point"), options);
    operands.push_back(options.bias);
    operands.push_back(options.samples);
    const ValueId hidden =
        queryNamed(call.b, info(Service::shadow), fileOf(call), {}, operands, 1)[0];
    return asResult(call, {hidden, hidden, hidden});
}

/// bump(name, norm, dPds, dPdt [, s, t]): the normal of the surface that stands as high above
/// the given one, along norm, as the picture says. With the unit normal n, dPds becomes dPds + hs n
/// and dPdt dPdt + ht n; what is of second order in h is left out. Nothing changes norm's length.
Components bump(BuiltinCall &call) {
    Builder &b = call.b;
    const PlaceScope place(b, call.expr.where);
    const size_t end = firstOption(call);
    const auto isTriple = [&](size_t k) {
        return k < end && sl::isGeometric(call.expr.operands[k]->type.base);
    };
    if (!isTriple(1) || !isTriple(2) || !isTriple(3)) {
        coordinatesFault(call, "a name, a normal, dPds and dPdt, then maybe s and t");
        return zero(b, sl::BaseType::Normal);
    }
    const auto at = surfaceReach(call, 4, end);
    const Values height =
        queryNamed(b, info(Service::textureSlopes), fileOf(call), {},
                   textureOperands(b, at, readLookupOptions(call)), 1 + twinCoordinates);
    const Triple n = normalize(b, call.triple(1)), byS = call.triple(2), byT = call.triple(3);
    const Triple flat = cross(b, byS, byT);
    const Triple rise =
        add(b, scale(b, cross(b, n, byT), height[1]), scale(b, cross(b, byS, n), height[2]));
    // norm may stand on either side of dPds ^ dPdt.
    const ValueId side =
        select(b, less(b, dot(b, flat, n), number(b, 0)), number(b, -1), number(b, 1));
    const Triple raised = add(b, scale(b, n, length(b, flat)), scale(b, rise, side));
    return componentsOf(scale(b, normalize(b, raised), length(b, call.triple(1))));
}

/// The variable gets the fact, or stays as it is if there is none of that type.
Components textureinfo(BuiltinCall &call) {
    Builder &b = call.b;
    const sl::Type &type = call.expr.operands[2]->type;
    const std::string fact = call.text(1, "the name of a texture's fact");
    if (type.base == sl::BaseType::String) {
        call.lowering.messages.warning(call.expr.operands[2]->where,
                                       "textureinfo() tells numbers: strings have to be known "
                                       "when a shader is compiled; it gives 0 here");
        return {number(b, 0)};
    }
    const PlaceScope place(b, call.expr.where);
    const Values answer = queryNamed(b, info(Service::textureinfo), fileOf(call),
                                     {fact, sl::shapeOf(type)}, {}, 1 + numbersTold(type));
    return {takeTold(call, 2, answer)};
}

} // namespace

BuiltinLowering textureBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::texture: return texture;
    case sl::BuiltinId::environment: return environment;
    case sl::BuiltinId::shadow: return shadow;
    case sl::BuiltinId::bump: return bump;
    case sl::BuiltinId::textureinfo: return textureinfo;
    default: return nullptr;
    }
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// diffuse(), specular() and phong() are light loops that the lowering writes (RI 3.1 section 15.6);
// trace(), ambient() and irradiance() ask the renderer.
#include "foundation/units/color.h"
#include "language/ir/lower_internal.h"

#include <numbers>

namespace candela::ir {
namespace {

/// The sum of Cl * factor(L), L of unit length, over the light before the surface.
template <class Factor>
Components gather(BuiltinCall &call, const Triple &normal, const char *category, Factor factor) {
    Builder &b = call.b;
    LightRequest request;
    request.kind = LightRequest::Kind::Loop;
    request.form = ConeForm::Classic;
    request.coneCount = 1;
    request.category = b.category(category);
    request.line = b.line();
    Components cone = componentsOf(normal);
    cone.push_back(b.number(std::numbers::pi_v<float> / 2));
    return b.lightLoop(b.addRequest(request),
                       tripleOf(call.lowering.predefined(sl::PredefinedId::P)), cone,
                       Components(colorSamples, b.number(0)),
                       [&](const Triple &L, const Components &Cl, const Components &carried) {
                           const ValueId weight = factor(b.normalize(L));
                           Components sum;
                           for (int c = 0; c < colorSamples; ++c)
                               sum.push_back(b.add(carried[c], b.mul(Cl[c], weight)));
                           return sum;
                       });
}

Components diffuse(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = b.normalize(call.triple(0));
    return gather(call, normal, "!diffuse", [&](const Triple &L) { return b.dot(L, normal); });
}

/// max(0, N.H)^(1/roughness), with unit vectors.
ValueId highlight(Builder &b, const Triple &L, const Triple &N, const Triple &V,
                  ValueId roughness) {
    const Triple half = b.normalize(b.add(L, V));
    return b.pow(b.max(b.dot(N, half), b.number(0)), b.div(b.number(1), roughness));
}

Components specular(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = b.normalize(call.triple(0)), view = b.normalize(call.triple(1));
    return gather(call, normal, "!specular",
                  [&](const Triple &L) { return highlight(b, L, normal, view, call.number(2)); });
}

Components specularbrdf(BuiltinCall &call) {
    Builder &b = call.b;
    return Components(colorSamples,
                      highlight(b, b.normalize(call.triple(0)), b.normalize(call.triple(1)),
                                b.normalize(call.triple(2)), call.number(3)));
}

Components phong(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = b.normalize(call.triple(0)), view = b.normalize(call.triple(1));
    const Triple mirror = b.reflect(b.neg(view), normal);
    return gather(call, normal, "!specular", [&](const Triple &L) {
        return b.pow(b.max(b.dot(mirror, L), b.number(0)), call.number(2));
    });
}

Components trace(BuiltinCall &call) {
    LightRequest request;
    request.kind = LightRequest::Kind::Trace;
    request.line = call.b.line();
    return call.b.trace(call.b.addRequest(request), call.triple(0), call.triple(1));
}

Components ambient(BuiltinCall &call) { return call.b.ambient(); }

Components irradiance(BuiltinCall &call) {
    return call.b.irradiance(call.triple(0), call.triple(1));
}

} // namespace

BuiltinLowering lightBuiltin(sl::BuiltinId id) {
    using Id = sl::BuiltinId;
    static const std::map<Id, BuiltinLowering> table{{Id::ambient, ambient},
                                                     {Id::diffuse, diffuse},
                                                     {Id::specular, specular},
                                                     {Id::phong, phong},
                                                     {Id::trace, trace},
                                                     {Id::irradiance, irradiance},
                                                     {Id::specularbrdf, specularbrdf}};
    const auto found = table.find(id);
    return found == table.end() ? nullptr : found->second;
}

} // namespace candela::ir

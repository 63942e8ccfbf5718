// SPDX-License-Identifier: Apache-2.0
// diffuse(), specular() and phong() are light loops that the lowering writes (RI 3.1 section 15.6);
// trace(), ambient() and irradiance() ask the renderer.
#include "foundation/units/color.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/light.h"

#include <numbers>

namespace candela::ir {
namespace {

/// The sum of Cl * factor(L), L of unit length, over the light before the surface.
template <class Factor> Components gather(BuiltinCall &call, const char *category, Factor factor) {
    Builder &b = call.b;
    LightRequest request;
    request.kind = LightRequest::Kind::Loop;
    request.form = ConeForm::Classic;
    request.coneCount = 1;
    request.category = categoryIndex(b, category);
    request.line = b.line();
    Components cone = componentsOf(normalize(b, call.triple(0)));
    cone.push_back(number(b, std::numbers::pi_v<float> / 2));
    return lightLoop(b, addRequest(call.lowering, request, call.expr.where),
                     tripleOf(call.lowering.variables.load(sl::PredefinedId::P)), cone,
                     Components(b.colors().samples, number(b, 0)),
                     [&](const LoopLight &light, const Components &carried) {
                         const ValueId weight = factor(normalize(b, light.L));
                         Components sum;
                         for (int c = 0; c < b.colors().samples; ++c)
                             sum.push_back(add(b, carried[c], mul(b, light.Cl[c], weight)));
                         return sum;
                     });
}

Components diffuse(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = normalize(b, call.triple(0));
    return gather(call, "!diffuse", [&](const Triple &L) { return dot(b, L, normal); });
}

/// max(0, N.H)^(highlightScale / roughness), with unit vectors.
ValueId highlight(Lowering &lowering, const Triple &L, const Triple &N, const Triple &V,
                  ValueId roughness) {
    Builder &b = lowering.b;
    const Triple half = normalize(b, add(b, L, V));
    const ValueId exponent = div(b, number(b, lowering.options.highlightScale), roughness);
    return pow(b, max(b, dot(b, N, half), number(b, 0)), exponent);
}

Components specular(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = normalize(b, call.triple(0)), view = normalize(b, call.triple(1));
    return gather(call, "!specular", [&](const Triple &L) {
        return highlight(call.lowering, L, normal, view, call.number(2));
    });
}

Components specularbrdf(BuiltinCall &call) {
    Builder &b = call.b;
    return Components(b.colors().samples, highlight(call.lowering, normalize(b, call.triple(0)),
                                                    normalize(b, call.triple(1)),
                                                    normalize(b, call.triple(2)), call.number(3)));
}

Components phong(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple normal = normalize(b, call.triple(0)), view = normalize(b, call.triple(1));
    const Triple mirror = reflect(b, neg(b, view), normal);
    return gather(call, "!specular", [&](const Triple &L) {
        return pow(b, max(b, dot(b, mirror, L), number(b, 0)), call.number(2));
    });
}

Components trace(BuiltinCall &call) {
    LightRequest request;
    request.kind = LightRequest::Kind::Trace;
    request.line = call.b.line();
    return trace(call.b, addRequest(call.lowering, request, call.expr.where), call.triple(0),
                 call.triple(1));
}

Components ambient(BuiltinCall &call) { return ambient(call.b); }

Components irradiance(BuiltinCall &call) {
    return irradiance(call.b, call.triple(0), call.triple(1));
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

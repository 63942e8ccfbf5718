// SPDX-License-Identifier: Apache-2.0
// diffuse(), specular() and phong() are light loops that the lowering writes (RI 3.1 section 15.6);
// trace(), ambient() and irradiance() ask the renderer.
#include "foundation/units/color.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/cone_direction.h"
#include "language/ir/lower/light.h"
#include "language/ir/lower/scan.h"

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

/// The mean radiance from the hemisphere, by the cosine: a path for each of a few directions where
/// the eye sees the point, and one where a ray does.
Components indirectByRays(BuiltinCall &call, const Triple &from, const Triple &normal) {
    constexpr int rays = 8;
    Builder &b = call.b;
    const auto shift = [&] { return random(b, call.lowering.variables.cells[call.lowering.turn]); };
    const ValueId x = shift(), y = shift();
    const Triple axis = normalize(b, normal);
    const auto part = [&](ValueId start, float step) {
        const ValueId sum = add(b, start, number(b, step));
        return sub(b, sum, unary(b, Op::Floor, sum));
    };
    Components sum(b.colors().samples, number(b, 0));
    const ValueId fromEye = equal(b, input(b, ShaderInput::rayDepth), number(b, 0));
    for (int ray = 0; ray < rays; ++ray) {
        // Rows of x, and y by the golden ratio: they fill the hemisphere evenly.
        const Triple direction = directionInCone(
            b, axis, number(b, std::numbers::pi_v<float> / 2), part(x, float(ray) / rays),
            part(y, float(ray) * std::numbers::phi_v<float>), ConeWeight::Cosine);
        LightRequest request;
        request.kind = LightRequest::Kind::Trace;
        request.line = b.line();
        const Components light =
            trace(b, addRequest(call.lowering, request, call.expr.where), from, direction);
        const ValueId share =
            select(b, fromEye, number(b, 1.0f / rays), number(b, ray == 0 ? 1 : 0));
        for (size_t c = 0; c < sum.size(); ++c)
            sum[c] = add(b, sum[c], mul(b, light[c], share));
    }
    return sum;
}

/// E/pi where the shader has it from nowhere else: light loops get all light, and irradiance() is E
/// itself (DESIGN section 4).
Components indirectdiffuse(BuiltinCall &call) {
    Builder &b = call.b;
    size_t point = 0;
    while (point < call.count() && call.isText(point))
        ++point;
    const bool ofMap = call.count() < point + 2 || call.isText(point + 1);
    if (!ofMap && call.lowering.options.indirectByRays)
        return indirectByRays(call, call.triple(point), call.triple(point + 1));
    if (ofMap || gathersLight(call.lowering.shader))
        return Components(b.colors().samples, number(b, 0));
    const Triple I = tripleOf(call.lowering.variables.load(sl::PredefinedId::I));
    Components result = irradiance(b, call.triple(point), neg(b, I));
    for (ValueId &v : result)
        v = mul(b, v, number(b, 1 / std::numbers::pi_v<float>));
    return result;
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
                                                     {Id::indirectdiffuse, indirectdiffuse},
                                                     {Id::indirect, indirectdiffuse},
                                                     {Id::specularbrdf, specularbrdf}};
    const auto found = table.find(id);
    return found == table.end() ? nullptr : found->second;
}

} // namespace candela::ir

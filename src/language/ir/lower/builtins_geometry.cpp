// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/matrix.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// Colors of fewer samples have their last one.
template <std::size_t index> Components getComponent(BuiltinCall &call) {
    const Components &value = call.arguments[0];
    return {value[std::min(index, value.size() - 1)]};
}

template <int index> Components setComponent(BuiltinCall &call) {
    Components value = call.arguments[0];
    value[index] = call.number(1);
    call.assign(0, value);
    return {};
}

/// Column `c` of a matrix, its four rows.
Components column(const Components &m, int c) { return {m[c], m[4 + c], m[8 + c], m[12 + c]}; }

Components comp(BuiltinCall &call) {
    if (call.count() == 2)
        return {component(call.lowering.b, call.arguments[0], call.number(1))};
    Components row;
    for (int c = 0; c < 4; ++c)
        row.push_back(component(call.lowering.b, column(call.arguments[0], c), call.number(1)));
    return {component(call.lowering.b, row, call.number(2))};
}

Components setcomp(BuiltinCall &call) {
    Lowering &lowering = call.lowering;
    if (call.count() == 3) {
        call.assign(
            0, replaceComponent(lowering.b, call.arguments[0], call.number(1), call.number(2)));
        return {};
    }
    Components m = call.arguments[0], row;
    for (int c = 0; c < 4; ++c)
        row.push_back(component(lowering.b, column(m, c), call.number(1)));
    row = replaceComponent(lowering.b, row, call.number(2), call.number(3));
    for (int c = 0; c < 4; ++c) {
        const Components changed =
            replaceComponent(lowering.b, column(m, c), call.number(1), row[c]);
        for (int r = 0; r < 4; ++r)
            m[4 * r + c] = changed[r];
    }
    call.assign(0, m);
    return {};
}

Components length(BuiltinCall &call) { return {length(call.b, call.triple(0))}; }

Components normalize(BuiltinCall &call) { return componentsOf(normalize(call.b, call.triple(0))); }

Components distance(BuiltinCall &call) {
    return {length(call.b, sub(call.b, call.triple(0), call.triple(1)))};
}

/// Distance of q to the segment from p0 to p1.
Components ptlined(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple p0 = call.triple(0);
    const Triple along = sub(b, call.triple(1), p0), toPoint = sub(b, call.triple(2), p0);
    const ValueId squared = dot(b, along, along), zero = number(b, 0);
    const ValueId inside = div(b, dot(b, toPoint, along), squared);
    const ValueId clamped = min(b, max(b, inside, zero), number(b, 1));
    const ValueId t = select(b, equal(b, squared, zero), zero, clamped);
    return {length(b, sub(b, toPoint, scale(b, along, t)))};
}

/// Rodrigues' formula about a unit axis; about none, the zero vector, nothing turns.
Triple rotated(Builder &b, const Triple &v, ValueId asked, const Triple &axis) {
    const ValueId zero = number(b, 0);
    const ValueId angle = select(b, equal(b, dot(b, axis, axis), zero), zero, asked);
    const ValueId cosine = unary(b, Op::Cos, angle), sine = unary(b, Op::Sin, angle);
    const ValueId along = mul(b, dot(b, axis, v), sub(b, number(b, 1), cosine));
    return add(b, add(b, scale(b, v, cosine), scale(b, cross(b, axis, v), sine)),
               scale(b, axis, along));
}

Components rotate(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId angle = call.number(1);
    if (call.result() == sl::BaseType::Matrix) {
        const Triple axis = normalize(b, call.triple(2));
        Matrix rotation = identityMatrix(b);
        for (int row = 0; row < 3; ++row) {
            const Triple image = rotated(b, triple(b, row == 0, row == 1, row == 2), angle, axis);
            std::copy(image.begin(), image.end(), rotation.begin() + 4 * row);
        }
        return componentsOf(multiply(b, matrixOf(call.arguments[0]), rotation));
    }
    const Triple p0 = call.triple(2);
    const Triple axis = normalize(b, sub(b, call.triple(3), p0));
    if (call.result() == sl::BaseType::Vector)
        return componentsOf(rotated(b, call.triple(0), angle, axis));
    const Triple turned = rotated(b, sub(b, call.triple(0), p0), angle, axis);
    return componentsOf(add(b, p0, turned));
}

Components faceforward(BuiltinCall &call) {
    const Triple reference = call.count() == 3
                                 ? call.triple(2)
                                 : tripleOf(call.lowering.variables.load(sl::PredefinedId::Ng));
    return componentsOf(faceforward(call.b, call.triple(0), call.triple(1), reference));
}

Components reflect(BuiltinCall &call) {
    return componentsOf(reflect(call.b, call.triple(0), call.triple(1)));
}

/// 1 - eta^2 (1 - cosine^2): the squared cosine beyond the surface; negative on total reflection.
ValueId transmittedCosineSquared(Builder &b, ValueId cosine, ValueId eta) {
    const ValueId one = number(b, 1);
    return sub(b, one, mul(b, mul(b, eta, eta), sub(b, one, mul(b, cosine, cosine))));
}

Triple refracted(Builder &b, const Triple &i, const Triple &n, ValueId eta) {
    const ValueId cosine = dot(b, i, n);
    const ValueId squared = transmittedCosineSquared(b, cosine, eta);
    const ValueId normalPart = add(b, mul(b, eta, cosine), sqrt(b, squared));
    const Triple direction = sub(b, scale(b, i, eta), scale(b, n, normalPart));
    return select(b, less(b, squared, number(b, 0)), triple(b, 0, 0, 0), direction);
}

Components refract(BuiltinCall &call) {
    return componentsOf(refracted(call.b, call.triple(0), call.triple(1), call.number(2)));
}

/// Reflectance of unpolarised light; eta is the index of the ray's side over that beyond.
ValueId fresnelReflectance(Builder &b, ValueId cosine, ValueId eta) {
    const ValueId squared = transmittedCosineSquared(b, cosine, eta);
    const ValueId beyond = sqrt(b, squared);
    const auto ratioSquared = [&](ValueId x, ValueId y) {
        const ValueId ratio = div(b, sub(b, x, y), add(b, x, y));
        return mul(b, ratio, ratio);
    };
    const ValueId across = ratioSquared(mul(b, eta, cosine), beyond);
    const ValueId along = ratioSquared(mul(b, eta, beyond), cosine);
    const ValueId mean = mul(b, number(b, 0.5f), add(b, across, along));
    // Grazing light of equal indices would be 0/0; all light is reflected at the horizon.
    const ValueId total = either(b, less(b, squared, number(b, 0)), equal(b, cosine, number(b, 0)));
    return select(b, total, number(b, 1), mean);
}

Components fresnel(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple i = call.triple(0), n = call.triple(1);
    const ValueId eta = call.number(2);
    const ValueId cosine = unary(b, Op::Abs, dot(b, normalize(b, i), normalize(b, n)));
    const ValueId reflected = fresnelReflectance(b, cosine, eta);
    call.assign(3, {reflected});
    call.assign(4, {sub(b, number(b, 1), reflected)});
    if (call.count() > 5) {
        call.assign(5, componentsOf(reflect(b, i, n)));
        call.assign(6, componentsOf(refracted(b, i, n, eta)));
    }
    return {};
}

Components arraylength(BuiltinCall &call) {
    return {number(call.b, float(call.expr.operands[0]->type.length))};
}

} // namespace

BuiltinLowering geometryBuiltin(sl::BuiltinId id) {
    using Id = sl::BuiltinId;
    static const std::map<Id, BuiltinLowering> table{{Id::xcomp, getComponent<0>},
                                                     {Id::ycomp, getComponent<1>},
                                                     {Id::zcomp, getComponent<2>},
                                                     {Id::setxcomp, setComponent<0>},
                                                     {Id::setycomp, setComponent<1>},
                                                     {Id::setzcomp, setComponent<2>},
                                                     {Id::comp, comp},
                                                     {Id::setcomp, setcomp},
                                                     {Id::length, length},
                                                     {Id::normalize, normalize},
                                                     {Id::distance, distance},
                                                     {Id::ptlined, ptlined},
                                                     {Id::rotate, rotate},
                                                     {Id::faceforward, faceforward},
                                                     {Id::reflect, reflect},
                                                     {Id::refract, refract},
                                                     {Id::fresnel, fresnel},
                                                     {Id::arraylength, arraylength}};
    const auto found = table.find(id);
    return found == table.end() ? nullptr : found->second;
}

} // namespace candela::ir

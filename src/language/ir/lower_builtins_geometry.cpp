// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower_internal.h"

namespace candela::ir {
namespace {

template <int index> Components getComponent(BuiltinCall &call) {
    return {call.arguments[0][index]};
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
        return {call.lowering.component(call.arguments[0], call.number(1))};
    Components row;
    for (int c = 0; c < 4; ++c)
        row.push_back(call.lowering.component(column(call.arguments[0], c), call.number(1)));
    return {call.lowering.component(row, call.number(2))};
}

Components setcomp(BuiltinCall &call) {
    Lowering &lowering = call.lowering;
    if (call.count() == 3) {
        call.assign(0,
                    lowering.replaceComponent(call.arguments[0], call.number(1), call.number(2)));
        return {};
    }
    Components m = call.arguments[0], row;
    for (int c = 0; c < 4; ++c)
        row.push_back(lowering.component(column(m, c), call.number(1)));
    row = lowering.replaceComponent(row, call.number(2), call.number(3));
    for (int c = 0; c < 4; ++c) {
        const Components changed = lowering.replaceComponent(column(m, c), call.number(1), row[c]);
        for (int r = 0; r < 4; ++r)
            m[4 * r + c] = changed[r];
    }
    call.assign(0, m);
    return {};
}

Components length(BuiltinCall &call) { return {call.b.length(call.triple(0))}; }

Components normalize(BuiltinCall &call) { return componentsOf(call.b.normalize(call.triple(0))); }

Components distance(BuiltinCall &call) {
    return {call.b.length(call.b.sub(call.triple(0), call.triple(1)))};
}

/// Distance of q to the segment from p0 to p1.
Components ptlined(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple p0 = call.triple(0);
    const Triple along = b.sub(call.triple(1), p0), toPoint = b.sub(call.triple(2), p0);
    const ValueId squared = b.dot(along, along), zero = b.number(0);
    const ValueId inside = b.div(b.dot(toPoint, along), squared);
    const ValueId clamped = b.min(b.max(inside, zero), b.number(1));
    const ValueId t = b.select(b.equal(squared, zero), zero, clamped);
    return {b.length(b.sub(toPoint, b.scale(along, t)))};
}

/// Rodrigues' formula about a unit axis.
Triple rotated(Builder &b, const Triple &v, ValueId angle, const Triple &axis) {
    const ValueId cosine = b.unary(Op::Cos, angle), sine = b.unary(Op::Sin, angle);
    const ValueId along = b.mul(b.dot(axis, v), b.sub(b.number(1), cosine));
    return b.add(b.add(b.scale(v, cosine), b.scale(b.cross(axis, v), sine)), b.scale(axis, along));
}

Components rotate(BuiltinCall &call) {
    Builder &b = call.b;
    const ValueId angle = call.number(1);
    if (call.result() == sl::BaseType::Matrix) {
        const Triple axis = b.normalize(call.triple(2));
        Matrix rotation = identityMatrix(b);
        for (int row = 0; row < 3; ++row) {
            const Triple image = rotated(b, b.triple(row == 0, row == 1, row == 2), angle, axis);
            std::copy(image.begin(), image.end(), rotation.begin() + 4 * row);
        }
        return componentsOf(multiply(b, matrixOf(call.arguments[0]), rotation));
    }
    const Triple p0 = call.triple(2);
    const Triple axis = b.normalize(b.sub(call.triple(3), p0));
    if (call.result() == sl::BaseType::Vector)
        return componentsOf(rotated(b, call.triple(0), angle, axis));
    const Triple turned = rotated(b, b.sub(call.triple(0), p0), angle, axis);
    return componentsOf(b.add(p0, turned));
}

Components faceforward(BuiltinCall &call) {
    const Triple reference = call.count() == 3
                                 ? call.triple(2)
                                 : tripleOf(call.lowering.predefined(sl::PredefinedId::Ng));
    return componentsOf(call.b.faceforward(call.triple(0), call.triple(1), reference));
}

Components reflect(BuiltinCall &call) {
    return componentsOf(call.b.reflect(call.triple(0), call.triple(1)));
}

/// 1 - eta^2 (1 - cosine^2): the squared cosine beyond the surface; negative on total reflection.
ValueId transmittedCosineSquared(Builder &b, ValueId cosine, ValueId eta) {
    const ValueId one = b.number(1);
    return b.sub(one, b.mul(b.mul(eta, eta), b.sub(one, b.mul(cosine, cosine))));
}

Triple refracted(Builder &b, const Triple &i, const Triple &n, ValueId eta) {
    const ValueId cosine = b.dot(i, n);
    const ValueId squared = transmittedCosineSquared(b, cosine, eta);
    const ValueId normalPart = b.add(b.mul(eta, cosine), b.sqrt(squared));
    const Triple direction = b.sub(b.scale(i, eta), b.scale(n, normalPart));
    return b.select(b.less(squared, b.number(0)), b.triple(0, 0, 0), direction);
}

Components refract(BuiltinCall &call) {
    return componentsOf(refracted(call.b, call.triple(0), call.triple(1), call.number(2)));
}

/// Reflectance of unpolarised light; eta is the index of the ray's side over that beyond.
ValueId fresnelReflectance(Builder &b, ValueId cosine, ValueId eta) {
    const ValueId squared = transmittedCosineSquared(b, cosine, eta);
    const ValueId beyond = b.sqrt(squared);
    const auto ratioSquared = [&](ValueId x, ValueId y) {
        const ValueId ratio = b.div(b.sub(x, y), b.add(x, y));
        return b.mul(ratio, ratio);
    };
    const ValueId across = ratioSquared(b.mul(eta, cosine), beyond);
    const ValueId along = ratioSquared(b.mul(eta, beyond), cosine);
    const ValueId mean = b.mul(b.number(0.5f), b.add(across, along));
    // Grazing light of equal indices would be 0/0; all light is reflected at the horizon.
    const ValueId total = b.either(b.less(squared, b.number(0)), b.equal(cosine, b.number(0)));
    return b.select(total, b.number(1), mean);
}

Components fresnel(BuiltinCall &call) {
    Builder &b = call.b;
    const Triple i = call.triple(0), n = call.triple(1);
    const ValueId eta = call.number(2);
    const ValueId cosine = b.unary(Op::Abs, b.dot(b.normalize(i), b.normalize(n)));
    const ValueId reflected = fresnelReflectance(b, cosine, eta);
    call.assign(3, {reflected});
    call.assign(4, {b.sub(b.number(1), reflected)});
    if (call.count() > 5) {
        call.assign(5, componentsOf(b.reflect(i, n)));
        call.assign(6, componentsOf(refracted(b, i, n, eta)));
    }
    return {};
}

Components arraylength(BuiltinCall &call) {
    return {call.b.number(float(call.expr.operands[0]->type.length))};
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

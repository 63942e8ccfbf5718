// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/spaces.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/matrix.h"

namespace candela::ir {

void Spaces::refuse(const std::string &name, const sl::Place &where) {
    messages_.error(where, "a default value can name a space only around the whole value, as in "
                           "point \"" +
                               name + "\" (0, 0, 0)");
}

/// "NDC" of an imager's pixels, whose u and v lead from 0 to 1 across the frame.
SpaceMatrices Spaces::frame() {
    const Triple P = input3(b_, ShaderInput::P);
    const ValueId one = number(b_, 1), none = number(b_, 0);
    const ValueId u = input(b_, ShaderInput::u), v = input(b_, ShaderInput::v);
    const auto scaling = [&](ValueId x, ValueId y) {
        return Matrix{x,    none, none, none, none, y,    none, none,
                      none, none, one,  none, none, none, none, one};
    };
    return {scaling(div(b_, P[0], u), div(b_, P[1], v)),
            scaling(div(b_, u, P[0]), div(b_, v, P[1]))};
}

std::optional<SpaceMatrices> Spaces::find(const std::string &name, const sl::Place &where) {
    if (name == "current" || (onlyShader_ && name == "shader"))
        return std::nullopt;
    if (onlyShader_) {
        refuse(name, where);
        return std::nullopt;
    }
    if (inImager_ && name == "raster")
        return std::nullopt;
    if (inImager_ && name == "NDC")
        return frame();
    if (onPicture_) {
        messages_.warning(where, "pictures have no coordinate systems: the space \"" + name +
                                     "\" is taken for \"current\" in filters and imagers");
        return std::nullopt;
    }
    if (name == "object")
        return SpaceMatrices{currentFromObject(b_), objectFromCurrent(b_)};
    if (name != "shader")
        return SpaceMatrices{currentFromSpace(b_, name), spaceFromCurrent(b_, name)};
    if (shaderSlot_ < 0) {
        auto &slots = b_.function().parameters;
        shaderSlot_ = int(slots.size());
        for (int i = 0; i < 32; ++i)
            slots.push_back({"shader", i});
    }
    SpaceMatrices result;
    for (int i = 0; i < 16; ++i) {
        result.toCurrent[i] = parameter(b_, shaderSlot_ + i);
        result.fromCurrent[i] = parameter(b_, shaderSlot_ + 16 + i);
    }
    return result;
}

namespace {

/// A point, vector or normal by a matrix and its inverse, each by its own rule.
Triple transformBy(Builder &b, sl::BaseType base, const Triple &value, const Matrix &m,
                   const Matrix &inverseOfM) {
    switch (base) {
    case sl::BaseType::Point: return transformPoint(b, m, value);
    case sl::BaseType::Normal: return transformNormal(b, inverseOfM, value);
    default: return transformVector(b, m, value);
    }
}

/// transform(), vtransform() and ntransform(): ([from,] to, value), `to` a name or a matrix.
Components transformBuiltin(BuiltinCall &call) {
    Builder &b = call.b;
    const sl::BaseType base = call.result();
    const size_t last = call.count() - 1;
    Triple value = call.triple(last);
    const sl::Place &where = call.expr.where;
    const std::string from = last == 2 ? call.text(0, "the name of a space") : "current";
    if (!call.isText(last - 1)) {
        if (const auto source = call.lowering.spaces.find(from, where))
            value = transformBy(b, base, value, source->toCurrent, source->fromCurrent);
        const Matrix m = matrixOf(call.arguments[last - 1]);
        const Matrix inverted = base == sl::BaseType::Normal ? inverse(b, m) : m;
        return componentsOf(transformBy(b, base, value, m, inverted));
    }
    const std::string to = call.text(last - 1, "the name of a space");
    if (from == to)
        return componentsOf(value);
    if (const auto source = call.lowering.spaces.find(from, where))
        value = transformBy(b, base, value, source->toCurrent, source->fromCurrent);
    if (const auto target = call.lowering.spaces.find(to, where))
        value = transformBy(b, base, value, target->fromCurrent, target->toCurrent);
    return componentsOf(value);
}

/// A matrix that acts in current space, as it acts in the other; or the way back.
Matrix conjugate(Builder &b, const Matrix &first, const Matrix &m, const Matrix &last) {
    return multiply(b, multiply(b, first, m), last);
}

Components mtransformBuiltin(BuiltinCall &call) {
    const sl::Place &where = call.expr.where;
    const size_t last = call.count() - 1;
    Matrix m = matrixOf(call.arguments[last]);
    const std::string from = last == 2 ? call.text(0, "the name of a space") : "current";
    const std::string to = call.text(last - 1, "the name of a space");
    if (from == to)
        return componentsOf(m);
    if (const auto source = call.lowering.spaces.find(from, where))
        m = conjugate(call.b, source->fromCurrent, m, source->toCurrent);
    if (const auto target = call.lowering.spaces.find(to, where))
        m = conjugate(call.b, target->toCurrent, m, target->fromCurrent);
    return componentsOf(m);
}

Components depthBuiltin(BuiltinCall &call) {
    const Triple point = call.triple(0);
    const auto depth = call.lowering.spaces.find("depth", call.expr.where);
    return {(depth ? transformPoint(call.b, depth->fromCurrent, point) : point)[2]};
}

} // namespace

Components fromSpace(Lowering &lowering, sl::BaseType base, const Components &value,
                     const std::string &name, const sl::Place &where) {
    if (base == sl::BaseType::Matrix && lowering.spaces.isShaderOnly() && name == "shader")
        lowering.spaces.refuse(name, where); // Matrices start at current space, not at "shader".
    const auto source = lowering.spaces.find(name, where);
    if (!source)
        return value;
    if (base == sl::BaseType::Matrix)
        return componentsOf(multiply(lowering.b, source->fromCurrent, matrixOf(value)));
    return componentsOf(
        transformBy(lowering.b, base, tripleOf(value), source->toCurrent, source->fromCurrent));
}

BuiltinLowering spaceBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::transform:
    case sl::BuiltinId::vtransform:
    case sl::BuiltinId::ntransform: return transformBuiltin;
    case sl::BuiltinId::mtransform: return mtransformBuiltin;
    case sl::BuiltinId::depth: return depthBuiltin;
    default: return nullptr;
    }
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_sources.h"

#include <algorithm>

namespace candela::ir {

ValueId number(Builder &b, float x) { return b.emit(Op::ConstFloat, {}, 0, x)[0]; }
ValueId boolean(Builder &b, bool truth) { return b.emit(Op::ConstBool, {}, truth)[0]; }
ValueId integer(Builder &b, int i) { return b.emit(Op::ConstInteger, {}, i)[0]; }
ValueId text(Builder &b, const std::string &s) {
    return b.emit(Op::ConstString, {}, intern(b.function().strings, s))[0];
}
Triple triple(Builder &b, float x, float y, float z) {
    return {number(b, x), number(b, y), number(b, z)};
}

const float *constantFloat(const Builder &b, ValueId v) {
    const Instruction *c = b.constant(v);
    return c && c->op == Op::ConstFloat ? &c->number : nullptr;
}

std::optional<bool> constantBool(const Builder &b, ValueId v) {
    const Instruction *c = b.constant(v);
    return c && c->op == Op::ConstBool ? std::optional(c->immediate != 0) : std::nullopt;
}

const std::string *constantText(Builder &b, ValueId v) {
    const Instruction *c = b.constant(v);
    return c && c->op == Op::ConstString ? &b.function().strings[c->immediate] : nullptr;
}

ValueId input(Builder &b, ShaderInput plane, int component) {
    return b.emit(Op::Input, {}, int(plane) + component)[0];
}
Triple input3(Builder &b, ShaderInput plane) {
    return {input(b, plane, 0), input(b, plane, 1), input(b, plane, 2)};
}
ValueId parameter(Builder &b, int slot) { return b.emit(Op::Parameter, {}, slot)[0]; }
ValueId variable(Builder &b, int plane) { return b.emit(Op::Variable, {}, plane)[0]; }

namespace {

Matrix matrixOf(Builder &b, Op op, int immediate) {
    Values elements = b.emit(op, {}, immediate);
    Matrix result;
    std::copy(elements.begin(), elements.end(), result.begin());
    return result;
}

} // namespace

ValueId captured(Builder &b, int index) { return b.emit(Op::Captured, {}, index)[0]; }
Matrix currentFromSpace(Builder &b, const std::string &name) {
    return matrixOf(b, Op::Space, intern(b.function().spaces, name));
}
Matrix spaceFromCurrent(Builder &b, const std::string &name) {
    return matrixOf(b, Op::SpaceInverse, intern(b.function().spaces, name));
}
Matrix currentFromObject(Builder &b) { return matrixOf(b, Op::Object, 0); }
Matrix objectFromCurrent(Builder &b) { return matrixOf(b, Op::ObjectInverse, 0); }

ValueId random(Builder &b, ValueId turn) { return b.emit(Op::Random, {turn}, b.nextRandom())[0]; }

} // namespace candela::ir

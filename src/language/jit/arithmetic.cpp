// SPDX-License-Identifier: Apache-2.0
#include "language/jit/arithmetic.h"

#include "language/ir/core/evaluate.h"

#include <llvm/IR/Intrinsics.h>

namespace candela::codegen {

using ir::Op;
using runtime::MathFunction;

Value *like(Value *model, float number) {
    return llvm::ConstantFP::get(model->getType(), double(number));
}

static Value *unary(CodeFunction &code, llvm::Intrinsic::ID id, Value *a) {
    return code.builder.CreateUnaryIntrinsic(id, a);
}

static Value *clampToUnit(CodeFunction &code, Value *x) {
    auto &make = code.builder;
    auto *least = make.CreateSelect(make.CreateFCmpOGT(x, like(x, -1)), x, like(x, -1));
    return make.CreateSelect(make.CreateFCmpOLT(least, like(x, 1)), least, like(x, 1));
}

/// As runtime::pow(): 0 for a negative base and an exponent that is no integer.
static Value *power(CodeFunction &code, Value *base, Value *exponent) {
    auto &make = code.builder;
    auto *negative = make.CreateFCmpOLT(base, like(base, 0));
    auto *whole = unary(code, llvm::Intrinsic::floor, exponent);
    auto *fractional = make.CreateFCmpUNE(exponent, whole);
    return make.CreateSelect(make.CreateAnd(negative, fractional), like(base, 0),
                             callMath(code, MathFunction::pow, {base, exponent}));
}

static Value *transcendental(CodeFunction &code, Op op, Value *a, Value *b) {
    switch (op) {
    case Op::Asin: return callMath(code, MathFunction::asin, {clampToUnit(code, a)});
    case Op::Acos: return callMath(code, MathFunction::acos, {clampToUnit(code, a)});
    case Op::Atan2: return callMath(code, MathFunction::atan2, {a, b});
    case Op::Pow: return power(code, a, b);
    case Op::Sin: return callMath(code, MathFunction::sin, {a});
    case Op::Cos: return callMath(code, MathFunction::cos, {a});
    case Op::Tan: return callMath(code, MathFunction::tan, {a});
    case Op::Atan: return callMath(code, MathFunction::atan, {a});
    case Op::Exp: return callMath(code, MathFunction::exp, {a});
    default: return callMath(code, MathFunction::log, {a});
    }
}

Value *floatOperation(CodeFunction &code, Op op, Value *a, Value *b) {
    auto &make = code.builder;
    switch (op) {
    case Op::Add: return make.CreateFAdd(a, b);
    case Op::Sub: return make.CreateFSub(a, b);
    case Op::Mul: return make.CreateFMul(a, b);
    case Op::Div: return make.CreateFDiv(a, b);
    case Op::Neg: return make.CreateFNeg(a);
    case Op::Abs: return unary(code, llvm::Intrinsic::fabs, a);
    case Op::Min: return make.CreateSelect(make.CreateFCmpOLT(a, b), a, b);
    case Op::Max: return make.CreateSelect(make.CreateFCmpOGT(a, b), a, b);
    case Op::Floor: return unary(code, llvm::Intrinsic::floor, a);
    case Op::Ceil: return unary(code, llvm::Intrinsic::ceil, a);
    case Op::Round:
        return unary(code, llvm::Intrinsic::floor, make.CreateFAdd(a, like(a, ir::belowHalf)));
    case Op::Sqrt:
        return make.CreateSelect(make.CreateFCmpOLT(a, like(a, 0)), like(a, 0),
                                 unary(code, llvm::Intrinsic::sqrt, a));
    case Op::Sloped: return a;
    default: return transcendental(code, op, a, b);
    }
}

Value *fusedProduct(CodeFunction &code, Value *a, Value *b, Value *c) {
    return code.builder.CreateIntrinsic(llvm::Intrinsic::fma, {a->getType()}, {a, b, c});
}

Value *logicOperation(CodeFunction &code, Op op, ir::Uniformity result,
                      llvm::function_ref<Value *(int k)> operand) {
    auto &make = code.builder;
    switch (op) {
    case Op::Less: return make.CreateFCmpOLT(operand(0), operand(1));
    case Op::LessEqual: return make.CreateFCmpOLE(operand(0), operand(1));
    case Op::Equal: return make.CreateFCmpOEQ(operand(0), operand(1));
    case Op::NotEqual: return make.CreateFCmpUNE(operand(0), operand(1));
    case Op::StringEqual: return make.CreateICmpEQ(operand(0), operand(1));
    case Op::And: return make.CreateAnd(operand(0), operand(1));
    case Op::Or: return make.CreateOr(operand(0), operand(1));
    case Op::Not: return make.CreateNot(operand(0));
    case Op::Select: return make.CreateSelect(operand(0), operand(1), operand(2));
    case Op::FloatFromBool:
        return make.CreateUIToFP(operand(0), code.lanes.type(ir::Type::Float, result));
    default: { // IntegerFromFloat, StringFromFloat.
        auto *type = code.lanes.type(ir::Type::Integer, result);
        Value *whole = make.CreateIntrinsic(llvm::Intrinsic::fptosi_sat,
                                            {type, operand(0)->getType()}, {operand(0)});
        return op == Op::IntegerFromFloat
                   ? whole
                   : make.CreateOr(make.CreateNot(whole), // stringOfNumber().
                                   llvm::ConstantInt::get(type, 0x80000000u));
    }
    }
}

Value *randomNumber(CodeFunction &code, Value *seed, int place, Value *turn) {
    auto &make = code.builder;
    Value *h = seed;
    const auto number = [&](std::uint32_t k) { return code.lanes.splat(make.getInt32(k)); };
    const auto shifted = [&](int by) { return make.CreateXor(h, make.CreateLShr(h, by)); };
    h = make.CreateAdd(h, number(std::uint32_t(place) * 0x9e3779b9u));
    auto *bits = make.CreateBitCast(turn, code.lanes.varying(code.integerType));
    h = make.CreateAdd(h, make.CreateMul(bits, number(0x85ebca77u)));
    h = make.CreateMul(shifted(16), number(0x7feb352du));
    h = make.CreateMul(shifted(15), number(0x846ca68bu));
    h = make.CreateLShr(shifted(16), 8);
    auto *whole = make.CreateSIToFP(h, code.lanes.varying(code.floatType));
    return make.CreateFMul(whole, like(whole, 0x1p-24f));
}

/// Vectors of one width, joined in pairs to one of all lanes.
static Value *joined(CodeFunction &code, Values parts) {
    while (parts.size() > 1) {
        llvm::SmallVector<int, 16> numbers;
        const int size =
            int(llvm::cast<llvm::FixedVectorType>(parts[0]->getType())->getNumElements());
        for (int k = 0; k < 2 * size; ++k)
            numbers.push_back(k);
        Values wider;
        for (std::size_t k = 0; k < parts.size(); k += 2)
            wider.push_back(code.builder.CreateShuffleVector(parts[k], parts[k + 1], numbers));
        parts = wider;
    }
    return parts[0];
}

/// The number that all lanes have, if the code says so.
static const llvm::ConstantFP *constantOf(Value *value) {
    auto *constant = llvm::dyn_cast<llvm::Constant>(value);
    if (constant && constant->getType()->isVectorTy())
        constant = constant->getSplatValue();
    return llvm::dyn_cast_or_null<llvm::ConstantFP>(constant);
}

/// The result if all arguments are constants and this machine rounds as the one that the code is
/// for; else null.
static Value *foldedMath(CodeFunction &code, MathFunction function, const Values &arguments) {
    using runtime::IsaLevel;
    if ((code.target.level == IsaLevel::V2) != (runtime::hostIsaLevel() == IsaLevel::V2))
        return nullptr;
    float x[2] = {};
    for (std::size_t k = 0; k < arguments.size(); ++k) {
        const auto *constant = constantOf(arguments[k]);
        if (!constant)
            return nullptr;
        x[k] = constant->getValueAPF().convertToFloat();
    }
    const void *address = runtime::scalarMath(function, code.target.level).address;
    const float result = arguments.size() == 1
                             ? reinterpret_cast<float (*)(float)>(address)(x[0])
                             : reinterpret_cast<float (*)(float, float)>(address)(x[0], x[1]);
    return like(arguments[0], result);
}

/// A uniform argument calls the scalar code; a varying one the vector code, as often as the
/// level's registers need.
Value *callMath(CodeFunction &code, MathFunction function, const Values &arguments) {
    if (Value *known = foldedMath(code, function, arguments))
        return known;
    const bool isVector = arguments[0]->getType()->isVectorTy();
    const auto callable = isVector ? runtime::vectorMath(function, code.target.level)
                                   : runtime::scalarMath(function, code.target.level);
    llvm::Type *type =
        isVector ? llvm::FixedVectorType::get(code.floatType, callable.width) : code.floatType;
    const std::vector<llvm::Type *> types(arguments.size(), type);
    auto callee = code.external(callable.name, llvm::FunctionType::get(type, types, false), true);
    if (!isVector || callable.width == code.lanes.width())
        return code.builder.CreateCall(callee, arguments);
    Values parts;
    for (int first = 0; first < code.lanes.width(); first += callable.width) {
        llvm::SmallVector<int, 16> piece;
        for (int k = 0; k < callable.width; ++k)
            piece.push_back(first + k);
        Values pieces;
        for (Value *argument : arguments)
            pieces.push_back(code.builder.CreateShuffleVector(argument, piece));
        parts.push_back(code.builder.CreateCall(callee, pieces));
    }
    return joined(code, std::move(parts));
}

Value *dot(CodeFunction &code, const Values &a, const Values &b) {
    auto &make = code.builder;
    const auto plus = [&](Value *sum, int k) {
        return code.fusesProducts ? fusedProduct(code, a[k], b[k], sum)
                                  : make.CreateFAdd(sum, make.CreateFMul(a[k], b[k]));
    };
    return plus(plus(make.CreateFMul(a[0], b[0]), 1), 2);
}

Values normalized(CodeFunction &code, const Values &a) {
    auto &make = code.builder;
    auto *size = unary(code, llvm::Intrinsic::sqrt, dot(code, a, a));
    auto *isZero = make.CreateFCmpOEQ(size, like(size, 0));
    auto *divisor = make.CreateSelect(isZero, like(size, 1), size);
    auto *inverse = make.CreateFDiv(like(size, 1), divisor);
    Values result;
    for (Value *component : a)
        result.push_back(make.CreateFMul(component, inverse));
    return result;
}

Value *anyNonZero(CodeFunction &code, const Values &color) {
    auto &make = code.builder;
    auto *words = code.lanes.varying(code.integerType);
    Value *bits = nullptr;
    for (Value *channel : color) {
        auto *own = make.CreateBitCast(channel, words);
        bits = bits ? make.CreateOr(bits, own) : own;
    }
    return make.CreateIsNotNull(make.CreateAnd(bits, code.lanes.splat(make.getInt32(0x7fffffff))));
}

} // namespace candela::codegen

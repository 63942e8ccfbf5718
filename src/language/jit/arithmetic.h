// SPDX-License-Identifier: Apache-2.0
// Operations on values alone, uniform ones or all lanes at once. Results are those of
// ir::interpret, bit by bit.
#pragma once

#include "language/jit/code_function.h"
#include "language/runtime/vector_math.h"

namespace candela::codegen {

/// The number in the model's type.
Value *like(Value *model, float);

/// An operation for which ir::isFloatArithmetic() holds; `b` is the last operand.
Value *floatOperation(CodeFunction &, ir::Op, Value *a, Value *b);
/// a b + c, rounded once; below v3 by a call for each lane.
Value *fusedProduct(CodeFunction &, Value *a, Value *b, Value *c);
/// Comparisons, logic, choice, conversions (the classes of operations of those names).
/// Operands are taken as uniform as the result is.
Value *logicOperation(CodeFunction &, ir::Op, ir::Uniformity result,
                      llvm::function_ref<Value *(int k)> operand);
/// As ir::randomNumber(): of the lanes' seeds, the place in the text, and the turn.
Value *randomNumber(CodeFunction &, Value *seed, int place, Value *turn);
Value *callMath(CodeFunction &, runtime::MathFunction, const Values &arguments);

Value *dot(CodeFunction &, const Values &, const Values &);
/// As ir::normalize: a zero vector stays zero.
Values normalized(CodeFunction &, const Values &);
/// Lanes in which a channel is not zero: in which it has any bit but its sign.
Value *anyNonZero(CodeFunction &, const Values &color);

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/operator_forms.h"

#include <vector>

namespace candela::sl {
namespace {

using enum BaseType;
using Forms = std::vector<OperatorForm>;
constexpr BaseType geometric[] = {Point, Vector, Normal};

Forms sums(bool subtract) {
    Forms forms{{Float, Float, Float, 0}, {Color, Color, Color, 0}};
    for (BaseType a : geometric)
        for (BaseType b : geometric) {
            bool bothPoints = a == Point && b == Point;
            bool onePoint = a == Point || b == Point;
            BaseType mixed = onePoint ? Point : a == b ? a : Vector;
            forms.push_back({a, b, bothPoints && subtract ? Vector : mixed, 0});
        }
    forms.push_back({Matrix, Matrix, Matrix, 0});
    return forms;
}

Forms products(bool divide) {
    Forms forms{{Float, Float, Float, 0}};
    for (BaseType a : geometric) {
        forms.push_back({a, Float, a, 0});
        if (!divide)
            forms.push_back({Float, a, a, 0});
    }
    forms.push_back({Color, Color, Color, 0});
    forms.push_back({Color, Float, Color, 1});
    if (!divide)
        forms.push_back({Float, Color, Color, 1});
    for (BaseType a : geometric)
        for (BaseType b : geometric)
            forms.push_back({a, b, a == b ? a : Vector, 2});
    forms.push_back({Matrix, Matrix, Matrix, 0});
    forms.push_back({Matrix, Float, Matrix, 0});
    if (!divide)
        forms.push_back({Float, Matrix, Matrix, 0});
    return forms;
}

Forms equalities() {
    Forms forms{{Float, Float, Float, 0},
                {Color, Color, Float, 0},
                {Matrix, Matrix, Float, 0},
                {String, String, Float, 0}};
    for (BaseType a : geometric)
        for (BaseType b : geometric)
            forms.push_back({a, b, Float, 0});
    return forms;
}

const Forms &formsOf(BinaryOp op) {
    static const Forms add = sums(false), subtract = sums(true), multiply = products(false),
                       divide = products(true), equal = equalities(),
                       dot{{Vector, Vector, Float, 0}, {Color, Color, Float, 3}},
                       cross{{Vector, Vector, Vector, 0}}, floats{{Float, Float, Float, 0}};
    switch (op) {
    case BinaryOp::Add: return add;
    case BinaryOp::Subtract: return subtract;
    case BinaryOp::Multiply: return multiply;
    case BinaryOp::Divide: return divide;
    case BinaryOp::Dot: return dot;
    case BinaryOp::Cross: return cross;
    case BinaryOp::Equal:
    case BinaryOp::NotEqual: return equal;
    default: return floats;
    }
}

int operandCost(const OperatorForm &form, const TypeSet &left, const TypeSet &right) {
    return form.cost + conversionCost(left, form.left) + conversionCost(right, form.right);
}

} // namespace

const OperatorForm *chooseForm(BinaryOp op, const TypeSet &left, const TypeSet &right,
                               std::optional<BaseType> wanted) {
    const OperatorForm *best = nullptr;
    int bestCost = impossible;
    for (const OperatorForm &form : formsOf(op)) {
        int operands = operandCost(form, left, right);
        int cost = operands + contextCost(form.result, wanted);
        if (operands < impossible && cost < bestCost) {
            best = &form;
            bestCost = cost;
        }
    }
    return best;
}

TypeSet resultsOf(BinaryOp op, const TypeSet &left, const TypeSet &right) {
    TypeSet result;
    if (left.empty() && right.empty())
        return result;
    for (const OperatorForm &form : formsOf(op))
        if (operandCost(form, left, right) < impossible)
            result.add(form.result);
    return result;
}

} // namespace candela::sl

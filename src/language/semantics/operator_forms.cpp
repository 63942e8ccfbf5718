// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/operator_forms.h"

#include <algorithm>
#include <vector>

namespace candela::sl {
namespace {

using enum BaseType;
using Forms = std::vector<OperatorForm>;
// With a promotion more than contextCost() asks for the float result: `color c = i / d` divides
// floats. Less for points than by components: `noise(P) * N` scales.
constexpr int scaling = 2;
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
        forms.push_back({a, Float, a, scaling});
        if (!divide)
            forms.push_back({Float, a, a, scaling});
    }
    forms.push_back({Color, Color, Color, 0});
    forms.push_back({Color, Float, Color, scaling});
    if (!divide)
        forms.push_back({Float, Color, Color, scaling});
    for (BaseType a : geometric)
        for (BaseType b : geometric)
            forms.push_back({a, b, a == b ? a : Vector, 2 * scaling});
    forms.push_back({Matrix, Matrix, Matrix, 0});
    forms.push_back({Matrix, Float, Matrix, scaling});
    if (!divide)
        forms.push_back({Float, Matrix, Matrix, scaling});
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

/// Of triples, a relation holds if it does in each component.
Forms orders() {
    Forms forms{{Float, Float, Float, 0}, {Color, Color, Float, 0}};
    for (BaseType a : geometric)
        for (BaseType b : geometric)
            forms.push_back({a, b, Float, 0});
    return forms;
}

const Forms &formsOf(BinaryOp op) {
    static const Forms add = sums(false), subtract = sums(true), multiply = products(false),
                       divide = products(true), equal = equalities(), order = orders(),
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
    case BinaryOp::Less:
    case BinaryOp::LessEqual:
    case BinaryOp::Greater:
    case BinaryOp::GreaterEqual: return order;
    default: return floats;
    }
}

int operandCost(const OperatorForm &form, const TypeSet &left, const TypeSet &right) {
    return form.cost + conversionCost(left, form.left) + conversionCost(right, form.right);
}

/// Beside a float, what may be float is: `.5 * noise(P)` and `noise(P) - .5` are floats whatever
/// the context wants, as files of thirty years expect.
TypeSet besideFloat(const TypeSet &types, const TypeSet &other) {
    return other.isOnly(Float) && types.has(Float) ? TypeSet{Float} : types;
}

} // namespace

const OperatorForm *chooseForm(BinaryOp op, const TypeSet &leftTypes, const TypeSet &rightTypes,
                               std::optional<BaseType> wanted) {
    const TypeSet left = besideFloat(leftTypes, rightTypes);
    const TypeSet right = besideFloat(rightTypes, leftTypes);
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

/// Whether an operand is of the form's type by itself, not by promotion of a float alone.
static bool fitsNatively(const OperatorForm &form, const TypeSet &left, const TypeSet &right) {
    bool floats = form.left == Float && form.right == Float;
    return floats || (form.left != Float && conversionCost(left, form.left) <= 1) ||
           (form.right != Float && conversionCost(right, form.right) <= 1);
}

// Not what could only be had by promotion (float + float is no color), and of point, vector and
// normal only what comes cheapest.
TypeSet resultsOf(BinaryOp op, const TypeSet &leftTypes, const TypeSet &rightTypes) {
    const TypeSet left = besideFloat(leftTypes, rightTypes);
    const TypeSet right = besideFloat(rightTypes, leftTypes);
    TypeSet result;
    if (left.empty() && right.empty())
        return result;
    int cheapest = impossible;
    for (const OperatorForm &form : formsOf(op))
        if (isGeometric(form.result))
            cheapest = std::min(cheapest, operandCost(form, left, right));
    for (const OperatorForm &form : formsOf(op)) {
        int cost = operandCost(form, left, right);
        bool best = !isGeometric(form.result) || cost == cheapest;
        if (cost < impossible && best && fitsNatively(form, left, right))
            result.add(form.result);
    }
    return result;
}

} // namespace candela::sl

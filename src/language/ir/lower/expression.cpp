// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/expression.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/call.h"
#include "language/ir/lower/color.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/matrix.h"
#include "language/ir/lower/scan.h"
#include "language/ir/lower/targets.h"

namespace candela::ir {
namespace {

bool isTruth(const sl::Expr &expr) {
    if (expr.kind == sl::ExprKind::Not)
        return true;
    return expr.kind == sl::ExprKind::Binary && expr.op >= sl::BinaryOp::Less;
}

ValueId sameComponents(Builder &b, const Components &x, const Components &y) {
    ValueId same = boolean(b, true);
    for (size_t i = 0; i < x.size(); ++i)
        same = i == 0 ? equal(b, x[i], y[i]) : both(b, same, equal(b, x[i], y[i]));
    return same;
}

ValueId sameText(Lowering &lowering, ValueId x, ValueId y) {
    Builder &b = lowering.b;
    return lowering.stringsAtRunTime.differ(b, x, y) ? boolean(b, false)
                                                     : binary(b, Op::StringEqual, x, y);
}

/// Of triples, what holds in all components.
template <class Relation>
ValueId inAll(Builder &b, const Components &x, const Components &y, Relation holds) {
    ValueId all = holds(b, x[0], y[0]);
    for (size_t i = 1; i < x.size(); ++i)
        all = both(b, all, holds(b, x[i], y[i]));
    return all;
}

ValueId compare(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const Components x = evaluate(lowering, *expr.operands[0]);
    const Components y = evaluate(lowering, *expr.operands[1]);
    const bool text = expr.operands[0]->type.base == sl::BaseType::String;
    switch (expr.op) {
    case sl::BinaryOp::Less: return inAll(b, x, y, less);
    case sl::BinaryOp::LessEqual: return inAll(b, x, y, lessEqual);
    case sl::BinaryOp::Greater: return inAll(b, y, x, less);
    case sl::BinaryOp::GreaterEqual: return inAll(b, y, x, lessEqual);
    case sl::BinaryOp::Equal:
        return text ? sameText(lowering, x[0], y[0]) : sameComponents(b, x, y);
    default:
        if (text)
            return negate(b, sameText(lowering, x[0], y[0]));
        return x.size() == 1 ? notEqual(b, x[0], y[0]) : negate(b, sameComponents(b, x, y));
    }
}

/// && and ||: the right side runs only where it decides, if running it costs or does something.
ValueId shortCircuit(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const bool isAnd = expr.op == sl::BinaryOp::And;
    const ValueId left = condition(lowering, *expr.operands[0]);
    if (const auto known = constantBool(b, left))
        return *known == isAnd ? condition(lowering, *expr.operands[1]) : left;
    if (isCheapAndPure(*expr.operands[1])) {
        const ValueId right = condition(lowering, *expr.operands[1]);
        return isAnd ? both(b, left, right) : either(b, left, right);
    }
    const int result = lowering.variables.newCells({boolean(b, !isAnd)});
    const auto right = [&] {
        lowering.variables.cells[result] = condition(lowering, *expr.operands[1]);
    };
    if (isAnd)
        branch(lowering, left, right, [] {});
    else
        branch(
            lowering, left, [] {}, right);
    return lowering.variables.cells[result];
}

Components conditional(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const ValueId decision = condition(lowering, *expr.operands[0]);
    if (const auto known = constantBool(b, decision))
        return evaluate(lowering, *expr.operands[*known ? 1 : 2]);
    if (isCheapAndPure(*expr.operands[1]) && isCheapAndPure(*expr.operands[2])) {
        const Components x = evaluate(lowering, *expr.operands[1]);
        const Components y = evaluate(lowering, *expr.operands[2]);
        Components result;
        for (size_t i = 0; i < x.size(); ++i)
            result.push_back(select(b, decision, x[i], y[i]));
        return result;
    }
    const Components start = zero(lowering.b, expr.type.base);
    const int cell = lowering.variables.newCells(start);
    const auto choose = [&](int operand) {
        lowering.variables.setCells(cell, evaluate(lowering, *expr.operands[operand]));
    };
    branch(
        lowering, decision, [&] { choose(1); }, [&] { choose(2); });
    return lowering.variables.inCells(cell, int(start.size()));
}

Components byComponents(Builder &b, Op op, const Components &x, const Components &y) {
    Components result;
    for (size_t i = 0; i < std::max(x.size(), y.size()); ++i)
        result.push_back(binary(b, op, x.size() == 1 ? x[0] : x[i], y.size() == 1 ? y[0] : y[i]));
    return result;
}

Components arithmetic(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const Components x = evaluate(lowering, *expr.operands[0]);
    const Components y = evaluate(lowering, *expr.operands[1]);
    const bool matrices = x.size() == 16 && y.size() == 16;
    switch (expr.op) {
    case sl::BinaryOp::Dot: return {dot(b, tripleOf(x), tripleOf(y))};
    case sl::BinaryOp::Cross: return componentsOf(cross(b, tripleOf(x), tripleOf(y)));
    case sl::BinaryOp::Multiply:
        if (matrices)
            return componentsOf(multiply(b, matrixOf(x), matrixOf(y)));
        return byComponents(b, Op::Mul, x, y);
    case sl::BinaryOp::Divide:
        if (matrices)
            return componentsOf(multiply(b, matrixOf(x), inverse(b, matrixOf(y))));
        return byComponents(b, Op::Div, x, y);
    case sl::BinaryOp::Add: return byComponents(b, Op::Add, x, y);
    default: return byComponents(b, Op::Sub, x, y);
    }
}

Components convert(Lowering &lowering, const sl::Expr &expr) {
    const Components value = evaluate(lowering, *expr.operands[0]);
    const sl::BaseType from = expr.operands[0]->type.base, to = expr.type.base;
    const size_t wanted = size_t(componentCount(lowering.b, to));
    if (from != sl::BaseType::Float && from != to) {
        if (from == sl::BaseType::Color)
            return componentsOf(rgbOf(lowering.b, value));
        if (to == sl::BaseType::Color)
            return colorOf(lowering.b, tripleOf(value));
    }
    if (from != sl::BaseType::Float || value.size() == wanted)
        return value;
    if (wanted == 16) {
        Components result(16, number(lowering.b, 0));
        for (int i = 0; i < 4; ++i)
            result[i * 5] = value[0];
        return result;
    }
    return Components(wanted, value[0]);
}

Components evaluateTuple(Lowering &lowering, const sl::Expr &expr) {
    Components result;
    for (const sl::ExprPtr &operand : expr.operands)
        result.push_back(evaluateFloat(lowering, *operand));
    return result;
}

/// What is given in a named space.
Components spaced(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const sl::Expr &given = *expr.operands[0];
    const Components value = given.kind == sl::ExprKind::Tuple ? evaluateTuple(lowering, given)
                                                               : evaluate(lowering, given);
    const ValueId name = evaluate(lowering, *expr.operands[1])[0];
    const std::string space =
        requiredText(lowering, name, expr.operands[1]->where, "the name of a space");
    if (expr.type.base != sl::BaseType::Color)
        return fromSpace(lowering, expr.type.base, value, space, expr.where);
    const Triple numbers = given.kind == sl::ExprKind::Tuple ? tripleOf(value) : rgbOf(b, value);
    return colorOf(b, convertColor(lowering, numbers, space, "rgb", expr.where));
}

} // namespace

ValueId condition(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    if (isTooLarge(lowering, expr.where))
        return boolean(b, false);
    if (expr.kind == sl::ExprKind::Not)
        return negate(b, condition(lowering, *expr.operands[0]));
    if (isTruth(expr)) {
        if (expr.op == sl::BinaryOp::And || expr.op == sl::BinaryOp::Or)
            return shortCircuit(lowering, expr);
        return compare(lowering, expr);
    }
    return notEqual(b, evaluateFloat(lowering, expr), number(b, 0));
}

ValueId evaluateFloat(Lowering &lowering, const sl::Expr &expr) {
    return evaluate(lowering, expr)[0];
}

Components evaluate(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    if (isTooLarge(lowering, expr.where))
        return zero(b, expr.type.base, expr.type.length);
    if (isTruth(expr))
        return {unary(b, Op::FloatFromBool, condition(lowering, expr))};
    switch (expr.kind) {
    case sl::ExprKind::Number: return {number(b, float(expr.number))};
    case sl::ExprKind::Text: return {text(b, expr.text)};
    case sl::ExprKind::Tuple: {
        const Components tuple = evaluateTuple(lowering, expr);
        if (expr.type.base == sl::BaseType::Color)
            return colorOf(b, tripleOf(tuple));
        const bool inShaderSpace = lowering.inDefault && expr.type.base != sl::BaseType::Matrix;
        return inShaderSpace ? fromSpace(lowering, expr.type.base, tuple, "shader", expr.where)
                             : tuple;
    }
    case sl::ExprKind::Variable:
        return lowering.variables.load(lowering.variables.storageOf(*expr.symbol));
    case sl::ExprKind::Element: return load(lowering, resolve(lowering, expr), expr.where);
    case sl::ExprKind::Component: {
        const Components value = evaluate(lowering, *expr.operands[0]);
        return {component(b, value, evaluateFloat(lowering, *expr.operands[1]))};
    }
    case sl::ExprKind::Negate: {
        Components value = evaluate(lowering, *expr.operands[0]);
        for (ValueId &component : value)
            component = neg(b, component);
        return value;
    }
    case sl::ExprKind::Conditional: return conditional(lowering, expr);
    case sl::ExprKind::Assign: {
        const Target target = resolve(lowering, *expr.operands[0]);
        lowering.targetValues.push_back(load(lowering, target, expr.where));
        const Components value = evaluate(lowering, *expr.operands[1]);
        lowering.targetValues.pop_back();
        store(lowering, target, value, expr.where);
        return value;
    }
    case sl::ExprKind::TargetValue: return lowering.targetValues.back();
    case sl::ExprKind::Convert: return convert(lowering, expr);
    case sl::ExprKind::FromSpace: return spaced(lowering, expr);
    case sl::ExprKind::Call: return call(lowering, expr);
    case sl::ExprKind::Builtin: return builtin(lowering, expr);
    default: return arithmetic(lowering, expr);
    }
}

} // namespace candela::ir

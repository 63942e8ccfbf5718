// SPDX-License-Identifier: Apache-2.0
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_sources.h"
#include "language/ir/builder_vectors.h"
#include "language/ir/lower_internal.h"

namespace candela::ir {
namespace {

bool isTruth(const sl::Expr &expr) {
    if (expr.kind == sl::ExprKind::Not)
        return true;
    return expr.kind == sl::ExprKind::Binary && expr.op >= sl::BinaryOp::Less;
}

ValueId compareComponents(Builder &b, const Components &x, const Components &y, bool text) {
    ValueId same = boolean(b, true);
    for (size_t i = 0; i < x.size(); ++i) {
        const ValueId one = text ? binary(b, Op::StringEqual, x[i], y[i]) : equal(b, x[i], y[i]);
        same = i == 0 ? one : both(b, same, one);
    }
    return same;
}

ValueId compare(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const Components x = lowering.evaluate(*expr.operands[0]);
    const Components y = lowering.evaluate(*expr.operands[1]);
    const bool text = expr.operands[0]->type.base == sl::BaseType::String;
    switch (expr.op) {
    case sl::BinaryOp::Less: return less(b, x[0], y[0]);
    case sl::BinaryOp::LessEqual: return lessEqual(b, x[0], y[0]);
    case sl::BinaryOp::Greater: return less(b, y[0], x[0]);
    case sl::BinaryOp::GreaterEqual: return lessEqual(b, y[0], x[0]);
    case sl::BinaryOp::Equal: return compareComponents(b, x, y, text);
    default:
        if (x.size() == 1 && !text)
            return notEqual(b, x[0], y[0]);
        return negate(b, compareComponents(b, x, y, text));
    }
}

/// && and ||: the right side runs only where it decides, if running it costs or does something.
ValueId shortCircuit(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const bool isAnd = expr.op == sl::BinaryOp::And;
    const ValueId left = lowering.condition(*expr.operands[0]);
    if (const auto known = constantBool(b, left))
        return *known == isAnd ? lowering.condition(*expr.operands[1]) : left;
    if (isCheapAndPure(*expr.operands[1])) {
        const ValueId right = lowering.condition(*expr.operands[1]);
        return isAnd ? both(b, left, right) : either(b, left, right);
    }
    const int result = lowering.newCells({boolean(b, !isAnd)});
    const auto right = [&] { lowering.cells[result] = lowering.condition(*expr.operands[1]); };
    if (isAnd)
        lowering.branch(left, right, [] {});
    else
        lowering.branch(
            left, [] {}, right);
    return lowering.cells[result];
}

Components conditional(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const ValueId decision = lowering.condition(*expr.operands[0]);
    if (const auto known = constantBool(b, decision))
        return lowering.evaluate(*expr.operands[*known ? 1 : 2]);
    if (isCheapAndPure(*expr.operands[1]) && isCheapAndPure(*expr.operands[2])) {
        const Components x = lowering.evaluate(*expr.operands[1]);
        const Components y = lowering.evaluate(*expr.operands[2]);
        Components result;
        for (size_t i = 0; i < x.size(); ++i)
            result.push_back(select(b, decision, x[i], y[i]));
        return result;
    }
    const Components start = lowering.zero(expr.type.base);
    const int cell = lowering.newCells(start);
    const auto choose = [&](int operand) {
        const Components value = lowering.evaluate(*expr.operands[operand]);
        std::copy(value.begin(), value.end(), lowering.cells.begin() + cell);
    };
    lowering.branch(
        decision, [&] { choose(1); }, [&] { choose(2); });
    const auto first = lowering.cells.begin() + cell;
    return {first, first + start.size()};
}

Components byComponents(Builder &b, Op op, const Components &x, const Components &y) {
    Components result;
    for (size_t i = 0; i < std::max(x.size(), y.size()); ++i)
        result.push_back(binary(b, op, x.size() == 1 ? x[0] : x[i], y.size() == 1 ? y[0] : y[i]));
    return result;
}

Components arithmetic(Lowering &lowering, const sl::Expr &expr) {
    Builder &b = lowering.b;
    const Components x = lowering.evaluate(*expr.operands[0]);
    const Components y = lowering.evaluate(*expr.operands[1]);
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
    const Components value = lowering.evaluate(*expr.operands[0]);
    const size_t wanted = size_t(componentCount(expr.type.base));
    if (value.size() == wanted)
        return value;
    if (wanted == 16) {
        Components result(16, number(lowering.b, 0));
        for (int i = 0; i < 4; ++i)
            result[i * 5] = value[0];
        return result;
    }
    return Components(wanted, value[0]);
}

/// Formals that are written see the argument itself (a variable) or a copy that is handed back (a
/// part of one); others get values.
class Inlining {
public:
    Inlining(Lowering &lowering, const sl::Expr &call) : lowering_(lowering), call_(call) {
        for (size_t i = 0; i < call.operands.size(); ++i)
            prepare(*call.operands[i], *call.function->formals[i]);
    }

    Components run() {
        const sl::Function &function = *call_.function;
        for (size_t i = 0; i < arguments_.size(); ++i)
            bind(*function.formals[i], arguments_[i]);
        const Components none = lowering_.zero(function.result.base);
        Frame frame{.function = &function, .returned = 0, .result = 0, .loops = {}};
        frame.returned = lowering_.newCells({boolean(lowering_.b, false)});
        frame.result = lowering_.newCells(none);
        lowering_.frames.push_back(frame);
        const int line = lowering_.b.line();
        lowering_.lower(function.body);
        lowering_.b.setLine(line);
        lowering_.frames.pop_back();
        for (size_t i = 0; i < arguments_.size(); ++i)
            if (arguments_[i].target)
                lowering_.store(*arguments_[i].target,
                                lowering_.load(lowering_.storageOf(*function.formals[i])),
                                call_.operands[i]->where);
        const auto first = lowering_.cells.begin() + frame.result;
        return {first, first + none.size()};
    }

private:
    struct Argument {
        std::optional<Storage> shared;
        std::optional<Target> target; ///< To be handed back to.
        Components value;
    };

    void prepare(const sl::Expr &operand, const sl::Symbol &formal) {
        Argument argument;
        const bool isVariable = operand.kind == sl::ExprKind::Variable;
        if (isVariable && (formal.output || (operand.type.isArray() && !formal.written))) {
            argument.shared = lowering_.storageOf(*operand.symbol);
        } else if (formal.output) {
            argument.target = lowering_.resolve(operand);
            argument.value = lowering_.load(*argument.target, operand.where);
        } else {
            argument.value = lowering_.evaluate(operand);
        }
        arguments_.push_back(std::move(argument));
    }
    void bind(const sl::Symbol &formal, const Argument &argument) {
        if (argument.shared)
            lowering_.bind(formal, *argument.shared);
        else
            lowering_.declare(formal, argument.value);
    }

    Lowering &lowering_;
    const sl::Expr &call_;
    std::vector<Argument> arguments_;
};

} // namespace

ValueId Lowering::condition(const sl::Expr &expr) {
    if (expr.kind == sl::ExprKind::Not)
        return negate(b, condition(*expr.operands[0]));
    if (isTruth(expr)) {
        if (expr.op == sl::BinaryOp::And || expr.op == sl::BinaryOp::Or)
            return shortCircuit(*this, expr);
        return compare(*this, expr);
    }
    return notEqual(b, evaluateFloat(expr), number(b, 0));
}

Components Lowering::call(const sl::Expr &expr) {
    // Calls are inlined: a chain of functions that each call the next twice would never end.
    constexpr size_t mostValues = 1 << 18;
    if (function_.values.size() + cells.size() > mostValues) {
        error(expr.where, "with all functions inlined, the shader is too large to compile");
        return zero(expr.type.base);
    }
    return Inlining(*this, expr).run();
}

Components Lowering::evaluate(const sl::Expr &expr) {
    if (isTruth(expr))
        return {unary(b, Op::FloatFromBool, condition(expr))};
    switch (expr.kind) {
    case sl::ExprKind::Number: return {number(b, float(expr.number))};
    case sl::ExprKind::Text: return {text(b, expr.text)};
    case sl::ExprKind::Tuple: {
        Components result;
        for (const sl::ExprPtr &operand : expr.operands)
            result.push_back(evaluateFloat(*operand));
        return result;
    }
    case sl::ExprKind::Variable: return load(storageOf(*expr.symbol));
    case sl::ExprKind::Element: return load(resolve(expr), expr.where);
    case sl::ExprKind::Component: {
        const Components value = evaluate(*expr.operands[0]);
        return {component(value, evaluateFloat(*expr.operands[1]))};
    }
    case sl::ExprKind::Negate: {
        Components value = evaluate(*expr.operands[0]);
        for (ValueId &component : value)
            component = neg(b, component);
        return value;
    }
    case sl::ExprKind::Conditional: return conditional(*this, expr);
    case sl::ExprKind::Assign: {
        const Target target = resolve(*expr.operands[0]);
        targetValues_.push_back(load(target, expr.where));
        const Components value = evaluate(*expr.operands[1]);
        targetValues_.pop_back();
        store(target, value, expr.where);
        return value;
    }
    case sl::ExprKind::TargetValue: return targetValues_.back();
    case sl::ExprKind::Convert: return convert(*this, expr);
    case sl::ExprKind::FromSpace: {
        const Components value = evaluate(*expr.operands[0]);
        const ValueId name = evaluate(*expr.operands[1])[0];
        return fromSpace(expr.type.base, value,
                         requiredText(name, expr.operands[1]->where, "the name of a space"),
                         expr.where);
    }
    case sl::ExprKind::Call: return call(expr);
    case sl::ExprKind::Builtin: return builtin(expr);
    default: return arithmetic(*this, expr);
    }
}

} // namespace candela::ir

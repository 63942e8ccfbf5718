// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/call.h"

#include "language/ir/lower/control.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/statement.h"
#include "language/ir/lower/targets.h"

namespace candela::ir {
namespace {

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
        enter(lowering_, &function);
        const int line = lowering_.b.line();
        lower(lowering_, function.body);
        lowering_.b.setLine(line);
        const int result = lowering_.frames.back().result;
        lowering_.frames.pop_back();
        for (size_t i = 0; i < arguments_.size(); ++i)
            if (arguments_[i].target)
                store(lowering_, *arguments_[i].target,
                      lowering_.variables.load(lowering_.variables.storageOf(*function.formals[i])),
                      call_.operands[i]->where);
        return lowering_.variables.inCells(result,
                                           componentCount(lowering_.b, function.result.base));
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
            argument.shared = lowering_.variables.storageOf(*operand.symbol);
        } else if (formal.output) {
            argument.target = resolve(lowering_, operand);
            argument.value = load(lowering_, *argument.target, operand.where);
        } else {
            argument.value = evaluate(lowering_, operand);
        }
        arguments_.push_back(std::move(argument));
    }
    void bind(const sl::Symbol &formal, const Argument &argument) {
        if (argument.shared)
            lowering_.variables.bind(formal, *argument.shared);
        else
            lowering_.variables.declare(formal, argument.value);
    }

    Lowering &lowering_;
    const sl::Expr &call_;
    std::vector<Argument> arguments_;
};

} // namespace

Components call(Lowering &lowering, const sl::Expr &expr) {
    // A chain of functions that each call the next twice would never end.
    constexpr size_t mostValues = 1 << 18;
    if (lowering.b.function().values.size() + lowering.variables.cells.size() > mostValues) {
        lowering.messages.error(expr.where,
                                "with all functions inlined, the shader is too large to compile");
        return zero(lowering.b, expr.type.base);
    }
    return Inlining(lowering, expr).run();
}

} // namespace candela::ir

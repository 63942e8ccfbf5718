// SPDX-License-Identifier: Apache-2.0
// Expressions, from the outside in: the context says which type it wants. Functions return null
// where they have reported an error; null operands pass through without another report.
#pragma once

#include <optional>
#include <string>

#include "language/semantics/conversion.h"
#include "language/semantics/operator_forms.h"
#include "language/semantics/surroundings.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

namespace candela::sl {

class ExpressionChecker {
public:
    using Wanted = std::optional<BaseType>;

    /// The surroundings must outlive it and may change between its calls.
    explicit ExpressionChecker(const Surroundings &here) : here_(here) {}

    ExprPtr check(const ast::Expr &, Wanted wanted = std::nullopt);
    /// Converted to the type; `role` names the expression in the message if that cannot be.
    ExprPtr checkAs(const ast::Expr &, BaseType, const std::string &role);
    /// Something that can be assigned.
    ExprPtr checkTarget(const ast::Expr &);
    /// The name of an array, to be read or (as a target) written.
    ExprPtr checkWholeArray(const ast::Expr &, bool asTarget);

private:
    /// An operator of a chain like a + b - c, whose left operand is all before it.
    struct Link {
        const ast::Expr *e;
        TypeSet left, right; ///< What the operands may be.
        const OperatorForm *form;
    };

    ExprPtr name(const ast::Expr &);
    ExprPtr tuple(const ast::Expr &, Wanted);
    ExprPtr index(const ast::Expr &, bool asTarget);
    ExprPtr negation(const ast::Expr &, Wanted);
    ExprPtr logicalNot(const ast::Expr &);
    ExprPtr binary(const ast::Expr &, Wanted);
    ExprPtr operation(const Link &, ExprPtr left);
    ExprPtr conditional(const ast::Expr &, Wanted);
    ExprPtr assignment(const ast::Expr &);
    ExprPtr assignedValue(const ast::Expr &, const Type &target);
    ExprPtr cast(const ast::Expr &);

    const Surroundings &here_;
};

} // namespace candela::sl

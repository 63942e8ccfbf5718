// SPDX-License-Identifier: Apache-2.0
// Calls: the function that is meant, and its arguments.
#pragma once

#include <string>

#include "language/semantics/expression_checker.h"

namespace candela::sl {

class CallChecker {
public:
    CallChecker(const Surroundings &here, ExpressionChecker &expressions)
        : here_(here), expressions_(expressions) {}

    ExprPtr check(const ast::Expr &call, ExpressionChecker::Wanted);

private:
    bool isDistance(const ast::Expr &, ExpressionChecker::Wanted) const;
    ExprPtr unknown(const ast::Expr &, ExpressionChecker::Wanted);
    /// Of a function that is known, but not to be had.
    ExprPtr zero(const ast::Expr &, const BuiltinOverload &);
    void hintAtDegrees(const ast::Expr &call, const BuiltinOverload &);
    ExprPtr optionalArgument(const ast::Expr &call, size_t i, BuiltinId);
    ExprPtr fittingNone(const ast::Expr &);
    ExprPtr builtin(const ast::Expr &, const BuiltinOverload &);
    const ast::Expr *channelOf(const Builtin &, const ast::Expr &argument) const;
    void addChannel(const ast::Expr &channel, std::vector<ExprPtr> &arguments);
    ExprPtr argument(const ast::Expr &, const BuiltinParameter &, const std::string &name);
    ExprPtr user(const ast::Expr &, FunctionDefinition &);
    ExprPtr userArgument(const ast::Expr &, const ast::Variable &formal, const std::string &name);

    const Surroundings &here_;
    ExpressionChecker &expressions_;
};

} // namespace candela::sl

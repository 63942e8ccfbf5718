// SPDX-License-Identifier: Apache-2.0
// Statements: of the body of a shader or of an instance of a function.
#pragma once

#include <vector>

#include "language/semantics/expression_checker.h"
#include "language/semantics/surroundings.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"

namespace candela::sl {

class StatementChecker {
public:
    using Statements = std::vector<StmtPtr>;

    /// `definition`: the function whose instance is checked; null for a shader.
    StatementChecker(Surroundings &here, FunctionDefinition *definition)
        : here_(here), definition_(definition), expressions_(here) {}

    /// In the scope that the surroundings have; what is right of them goes to `out`.
    void check(const std::vector<ast::StmtPtr> &, Statements &out);

    /// The return statements with a value so far.
    struct Returned {
        bool any = false;
        Detail detail = Detail::Uniform; ///< Of the results of all.
    };
    const Returned &returned() const { return returned_; }

private:
    void statement(const ast::Stmt &, Statements &out);
    void scoped(const ast::Stmt &, Statements &out);
    void declaration(const ast::Variable &, Statements &out);
    void evaluation(const ast::Stmt &, Statements &out);
    void ifStatement(const ast::Stmt &, Statements &out);
    void loop(const ast::Stmt &, Statements &out);
    StmtPtr loopItself(const ast::Stmt &);
    void gatherStatement(const ast::Stmt &, Statements &);
    void jump(const ast::Stmt &, Statements &out);
    void returnStatement(const ast::Stmt &, Statements &out);
    ExprPtr returnedValue(const ast::Stmt &);
    void lightStatement(const ast::Stmt &, Statements &out);
    ExprPtr condition(const ast::Expr &);

    Surroundings &here_;
    FunctionDefinition *definition_;
    ExpressionChecker expressions_;
    std::vector<const Stmt *> loops_; ///< And light statements; outermost first.
    bool varyingControl_ = false;     ///< Perhaps not all points come here.
    Returned returned_;
};

} // namespace candela::sl

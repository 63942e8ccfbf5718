// SPDX-License-Identifier: Apache-2.0
// The type checker of one shader; for the sources of this room only. Functions return null where
// they have reported an error; null operands pass through without another report.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "language/semantics/conversion.h"
#include "language/semantics/scope.h"
#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

class Checker {
public:
    Checker(const ast::File &file, const SourceFile &mainFile, Reporter &);

    /// The typed shader; of use only if the reporter has counted no errors.
    std::unique_ptr<TypedShader> check(const ast::Shader &);

private:
    using Wanted = std::optional<BaseType>;

    /// Where in the program the checker is.
    struct Context {
        Scope *scope = nullptr;
        Function *function = nullptr; ///< The instance being checked, or null.
        FunctionDefinition *definition = nullptr;
        std::vector<const Stmt *> loops;       ///< Outermost first.
        const Stmt *lightStatement = nullptr;  ///< illuminance, illuminate or solar around.
        bool varyingControl = false;           ///< Under a varying condition.
        bool inDefaults = false;               ///< In the default of a parameter.
        Detail resultDetail = Detail::Uniform; ///< Of all return statements so far.
        bool returns = false;                  ///< A return with a value was seen.
    };

    /// What a call may mean.
    struct Callee {
        const BuiltinOverload *overload = nullptr;
        FunctionDefinition *definition = nullptr;
        BaseType result = BaseType::Void;
        int cost = impossible;
    };

    // Types before the context is known (checker_types.cpp).
    TypeSet typesOf(const ast::Expr &);
    TypeSet typesOfName(const ast::Expr &);
    TypeSet typesOfIndex(const ast::Expr &);
    TypeSet typesOfConditional(const ast::Expr &);
    TypeSet typesOfCall(const ast::Expr &);
    std::vector<TypeSet> argumentTypes(const ast::Expr &call);

    // Expressions (checker_expressions.cpp).
    ExprPtr check(const ast::Expr &, Wanted wanted = std::nullopt);
    ExprPtr checkAs(const ast::Expr &, BaseType, const std::string &role);
    ExprPtr checkName(const ast::Expr &);
    ExprPtr checkTuple(const ast::Expr &, Wanted);
    ExprPtr checkIndex(const ast::Expr &, bool asTarget);
    ExprPtr checkSign(const ast::Expr &, Wanted);
    ExprPtr checkBinary(const ast::Expr &, Wanted);
    ExprPtr checkConditional(const ast::Expr &, Wanted);
    ExprPtr checkAssign(const ast::Expr &);
    ExprPtr assignedValue(const ast::Expr &, const Type &target);
    ExprPtr checkCast(const ast::Expr &);
    ExprPtr checkTarget(const ast::Expr &);
    bool mayWrite(const Symbol &, const Place &);
    bool detailFits(const Expr &target, Detail value, const Place &);
    bool constantIndexFits(const ast::Expr &index, int length, const std::string &what);
    ExprPtr coerce(ExprPtr, BaseType, const std::string &role);
    ExprPtr node(ExprKind, Type, const Place &, std::vector<ExprPtr> operands = {});
    ExprPtr variable(Symbol &, const Place &);

    // Calls (checker_calls.cpp).
    ExprPtr checkCall(const ast::Expr &, Wanted);
    Callee chooseCallee(const ast::Expr &, Wanted);
    int builtinCost(const BuiltinOverload &, const ast::Expr &, const std::vector<TypeSet> &);
    int userCost(const FunctionDefinition &, const ast::Expr &, const std::vector<TypeSet> &);
    ExprPtr callBuiltin(const ast::Expr &, const BuiltinOverload &);
    ExprPtr builtinArgument(const ast::Expr &, const BuiltinParameter &, const std::string &name);
    ExprPtr callUser(const ast::Expr &, FunctionDefinition &);
    ExprPtr userArgument(const ast::Expr &, const ast::Variable &formal, const std::string &name);
    ExprPtr wholeArray(const ast::Expr &, bool asTarget);
    void unknownFunction(const ast::Expr &);
    void noFittingOverload(const ast::Expr &);
    void checkStrings(const ast::Expr &, const BuiltinOverload &,
                      const std::vector<ExprPtr> &arguments);
    bool componentExists(const ast::Expr &, const BuiltinOverload &);
    void checkPattern(const ast::Expr &, const std::vector<ExprPtr> &arguments);

    // Functions (checker_functions.cpp).
    void defineFunction(const ast::Function &, Scope *);
    BaseType resultOf(FunctionDefinition &);
    const Function *instantiate(FunctionDefinition &, const std::vector<Type> &arguments,
                                const Place &call);
    void checkInstance(FunctionDefinition &, Function &, const std::vector<Type> &arguments);
    std::vector<Type> generalArguments(const FunctionDefinition &);
    void checkUncalled();

    // Statements (checker_statements.cpp).
    void statement(const ast::Stmt &, std::vector<StmtPtr> &out);
    void statements(const std::vector<ast::StmtPtr> &, std::vector<StmtPtr> &out);
    void scopedStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    void declare(const ast::Variable &, std::vector<StmtPtr> &out);
    void declareExternal(const ast::Variable &);
    void ifStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    void loopStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    void jumpStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    void returnStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    ExprPtr condition(const ast::Expr &);
    StmtPtr make(StmtKind, const Place &);

    // illuminance, illuminate, solar (checker_lights.cpp).
    void lightStatement(const ast::Stmt &, std::vector<StmtPtr> &out);
    bool lightStatementAllowed(const ast::Stmt &);
    std::unique_ptr<LightArguments> lightArguments(const ast::Stmt &);
    void coneArguments(const ast::Stmt &, size_t first, LightArguments &);
    void extendedCones(const ast::Stmt &, size_t first, LightArguments &);

    // Variables and the shader itself (checker_shader.cpp).
    void parameter(const ast::Variable &);
    std::optional<int> arrayLength(const ast::Variable &);
    std::vector<ExprPtr> initialValues(const ast::Variable &, const Symbol &);
    Symbol *newSymbol(Symbol::Kind, const std::string &name, Type, const Place &);
    Symbol *declareSymbol(Symbol::Kind, const ast::Variable &, Type);
    Symbol *findVariable(const std::string &name);
    Symbol *predefinedSymbol(const PredefinedVariable &);
    Scope *newScope(Scope *outer, Scope *externs = nullptr);
    std::string variableSuggestion(const std::string &name);
    void warnAboutUnused();

    const ast::File &file_;
    const SourceFile &mainFile_;
    Reporter &reporter_;
    TypedShader *shader_ = nullptr;
    Scope *fileScope_ = nullptr;
    Scope *parameterScope_ = nullptr;
    Context context_;
    std::vector<std::unique_ptr<Scope>> scopes_;
    std::vector<std::unique_ptr<FunctionDefinition>> definitions_;
    std::map<std::string, Symbol *> predefined_;
    int instanceDepth_ = 0;
};

} // namespace candela::sl

// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/shader_checker.h"

#include <algorithm>

#include "language/semantics/expression_checker.h"
#include "language/semantics/statement_checker.h"
#include "language/semantics/user_functions.h"
#include "language/semantics/variables.h"

namespace candela::sl {
namespace {

class ShaderChecker {
public:
    ShaderChecker(TypedShader &shader, const std::string &headersRead, Reporter &reporter)
        : shader_(shader), reporter_(reporter), symbols_(shader),
          functions_(shader, symbols_, reporter, headersRead) {}

    void defineFunctions(const ast::File &);
    void parameters(const std::vector<ast::Variable> &);
    void body(const ast::Stmt &);
    void uncalledFunctions(const ast::File &, const SourceFile &mainFile);
    void hintAtUnset(const SourceFile &mainFile) const;

private:
    Surroundings surroundings(Scope &scope) {
        return {Names(symbols_, reporter_, scope, nullptr), functions_, reporter_};
    }
    Parameter parameter(const ast::Variable &, Surroundings &);

    TypedShader &shader_;
    Reporter &reporter_;
    Symbols symbols_;
    UserFunctions functions_;
    // Functions of the file see parameters only by extern.
    Scope externScope_;
    Scope fileScope_{nullptr, &externScope_};
    Scope &shaderScope_ = fileScope_.addInner();
};

void ShaderChecker::defineFunctions(const ast::File &file) {
    for (const ast::Item &item : file.items)
        if (const auto *function = std::get_if<ast::Function>(&item))
            functions_.define(*function, fileScope_);
}

void ShaderChecker::parameters(const std::vector<ast::Variable> &list) {
    Surroundings here = surroundings(shaderScope_);
    here.inDefaults = true;
    for (const ast::Variable &variable : list)
        shader_.parameters.push_back(parameter(variable, here));
}

Parameter ShaderChecker::parameter(const ast::Variable &v, Surroundings &here) {
    Parameter result;
    ExpressionChecker expressions(here);
    Type type = declaredType(v, Detail::Uniform, reporter_);
    result.defaults = initialValues(v, type, expressions, reporter_);
    if (!v.initialised)
        reporter_.hint(v.where, "parameter " + v.name + " has no default; it is " +
                                    (v.type == BaseType::String ? "\"\"" : "0"));
    result.symbol = &here.names.declare(Symbol::Kind::Parameter, v, type);
    Symbol *ignored = nullptr;
    externScope_.declare(v.name, result.symbol, &ignored);
    result.doc = v.doc;
    return result;
}

void ShaderChecker::body(const ast::Stmt &block) {
    Surroundings here = surroundings(shaderScope_.addInner());
    StatementChecker(here, nullptr).check(block.body, shader_.body);
}

// Errors in functions of this file are told even if nobody calls them; those that an #include
// brought in, or that stand between several shaders, may be meant for other kinds of shaders.
void ShaderChecker::uncalledFunctions(const ast::File &file, const SourceFile &mainFile) {
    auto isShader = [](const ast::Item &item) { return std::holds_alternative<ast::Shader>(item); };
    bool several = std::ranges::count_if(file.items, isShader) > 1;
    functions_.checkUncalled(mainFile, several ? &fileScope_ : nullptr);
}

void ShaderChecker::hintAtUnset(const SourceFile &mainFile) const {
    for (const Symbol *symbol : symbols_.unset())
        if (symbol->read && !symbol->written && symbol->where.file == &mainFile)
            reporter_.hint(symbol->where,
                           "variable " + symbol->name + " is read, but never set: it is " +
                               (symbol->type.base == BaseType::String ? "\"\"" : "0"));
}

void hintAtUnused(const TypedShader &shader, const SourceFile &mainFile, Reporter &reporter) {
    for (const auto &symbol : shader.symbols) {
        bool read = symbol->read || symbol->output;
        // Light categories and the like are read by others: __category, __nondiffuse.
        if (read || symbol->where.file != &mainFile || symbol->name.starts_with("__"))
            continue;
        if (symbol->kind == Symbol::Kind::Parameter)
            reporter.hint(symbol->where, "parameter " + symbol->name + " is never used");
        if (symbol->kind == Symbol::Kind::Local && !symbol->written)
            reporter.hint(symbol->where, "variable " + symbol->name + " is never used");
    }
}

} // namespace

std::unique_ptr<TypedShader> checkShader(const ast::Shader &syntax, const ast::File &file,
                                         const SourceFile &mainFile, const std::string &headersRead,
                                         Reporter &reporter) {
    auto shader = std::make_unique<TypedShader>();
    shader->kind = syntax.kind;
    shader->name = syntax.name;
    shader->where = syntax.where;
    shader->doc = syntax.doc;
    ShaderChecker checker(*shader, headersRead, reporter);
    checker.defineFunctions(file);
    checker.parameters(syntax.parameters);
    checker.body(*syntax.body);
    checker.uncalledFunctions(file, mainFile);
    if (reporter.errorCount() == 0) {
        hintAtUnused(*shader, mainFile, reporter);
        checker.hintAtUnset(mainFile);
    }
    return shader;
}

} // namespace candela::sl

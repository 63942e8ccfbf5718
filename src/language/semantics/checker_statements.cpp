// SPDX-License-Identifier: Apache-2.0
// Statements.
#include "language/semantics/checker.h"

namespace candela::sl {

StmtPtr Checker::make(StmtKind kind, const Place &where) {
    auto result = std::make_unique<Stmt>();
    result->kind = kind;
    result->where = where;
    return result;
}

void Checker::statements(const std::vector<ast::StmtPtr> &list, std::vector<StmtPtr> &out) {
    for (const ast::StmtPtr &s : list)
        statement(*s, out);
}

void Checker::scopedStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    Scope *outer = context_.scope;
    context_.scope = newScope(outer);
    if (s.kind == ast::StmtKind::Block)
        statements(s.body, out);
    else
        statement(s, out);
    context_.scope = outer;
}

void Checker::statement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    switch (s.kind) {
    case ast::StmtKind::Empty: return;
    case ast::StmtKind::Block: {
        StmtPtr block = make(StmtKind::Block, s.where);
        scopedStatement(s, block->body);
        out.push_back(std::move(block));
        return;
    }
    case ast::StmtKind::Declare:
        for (const ast::Variable &variable : s.variables)
            declare(variable, out);
        return;
    case ast::StmtKind::Function: defineFunction(*s.function, context_.scope); return;
    case ast::StmtKind::Evaluate:
        if (ExprPtr value = check(*s.value)) {
            StmtPtr result = make(StmtKind::Evaluate, s.where);
            bool acts =
                s.value->kind == ast::ExprKind::Assign || s.value->kind == ast::ExprKind::Call;
            if (!acts)
                reporter_.warning(s.value->where, "this expression has no effect");
            result->value = std::move(value);
            out.push_back(std::move(result));
        }
        return;
    case ast::StmtKind::If: ifStatement(s, out); return;
    case ast::StmtKind::While:
    case ast::StmtKind::For: loopStatement(s, out); return;
    case ast::StmtKind::Break:
    case ast::StmtKind::Continue: jumpStatement(s, out); return;
    case ast::StmtKind::Return: returnStatement(s, out); return;
    case ast::StmtKind::Illuminance:
    case ast::StmtKind::Illuminate:
    case ast::StmtKind::Solar: lightStatement(s, out); return;
    case ast::StmtKind::Gather:
        reporter_.error(s.where, "the gather statement is not available yet in this version of "
                                 "Candela");
        return;
    }
}

void Checker::declare(const ast::Variable &v, std::vector<StmtPtr> &out) {
    if (v.external)
        return declareExternal(v);
    if (v.output)
        reporter_.error(v.where, "only parameters can be output, not variable " + v.name);
    Detail natural = v.type == BaseType::String ? Detail::Uniform : Detail::Varying;
    Type type{v.type, v.detail.value_or(natural), 0};
    if (v.isArray)
        type.length = arrayLength(v).value_or(1);
    // Its initial value still sees an outer variable of that name.
    Symbol shape;
    shape.name = v.name;
    shape.type = type;
    std::vector<ExprPtr> values = initialValues(v, shape);
    Symbol *symbol = declareSymbol(Symbol::Kind::Local, v, type);
    for (const ExprPtr &value : values) {
        ExprPtr target = variable(*symbol, v.where);
        if (!detailFits(*target, value->type.detail, value->where))
            break;
    }
    StmtPtr result = make(StmtKind::Declare, v.where);
    result->symbol = symbol;
    result->values = std::move(values);
    out.push_back(std::move(result));
}

// extern makes an outer variable known; the symbol stays the outer one.
void Checker::declareExternal(const ast::Variable &v) {
    Symbol *found = context_.scope->findExternal(v.name);
    if (const PredefinedVariable *p = found ? nullptr : findPredefined(v.name, shader_->kind))
        found = predefinedSymbol(*p);
    if (!found) {
        reporter_.error(v.where, "extern variable " + v.name + " is not known outside of here" +
                                     variableSuggestion(v.name));
        return;
    }
    bool same =
        found->type.base == v.type || (isGeometric(found->type.base) && isGeometric(v.type));
    if (!same || found->type.isArray() != v.isArray)
        reporter_.error(v.where, "extern variable " + v.name + " is a " + shapeOf(found->type) +
                                     " where it is defined");
    Symbol *existing = nullptr;
    if (!context_.scope->declare(v.name, found, &existing) && existing != found)
        reporter_.error(v.where, v.name + " is declared here already");
}

ExprPtr Checker::condition(const ast::Expr &e) {
    if (e.kind == ast::ExprKind::Assign && !e.compound)
        reporter_.warning(e.where, "'=' assigns; did you mean '=='?");
    return checkAs(e, BaseType::Float, "a condition");
}

void Checker::ifStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    StmtPtr result = make(StmtKind::If, s.where);
    result->value = condition(*s.value);
    bool outer = context_.varyingControl;
    bool varies = result->value && result->value->type.isVarying();
    context_.varyingControl = outer || varies;
    bool returned = context_.returns;
    scopedStatement(*s.body[0], result->body);
    if (s.body.size() > 1)
        scopedStatement(*s.body[1], result->otherwise);
    // Behind a return that only some points took, all is under varying control.
    bool someReturned = varies && context_.returns && !returned;
    context_.varyingControl = outer || someReturned;
    if (result->value)
        out.push_back(std::move(result));
}

void Checker::loopStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    Scope *outerScope = context_.scope;
    bool outerControl = context_.varyingControl;
    context_.scope = newScope(outerScope);
    StmtPtr block = make(StmtKind::Block, s.where);
    if (s.first)
        statement(*s.first, block->body);
    StmtPtr loop = make(StmtKind::Loop, s.where);
    if (s.value)
        loop->value = condition(*s.value);
    bool failed = s.value && !loop->value;
    if (loop->value && loop->value->type.isVarying())
        context_.varyingControl = true;
    context_.loops.push_back(loop.get());
    scopedStatement(*s.body[0], loop->body);
    context_.loops.pop_back();
    for (const ast::ExprPtr &step : s.steps)
        if (ExprPtr e = check(*step))
            loop->steps.push_back(std::move(e));
    context_.scope = outerScope;
    context_.varyingControl = outerControl;
    if (failed)
        return;
    block->body.push_back(std::move(loop));
    if (s.first)
        out.push_back(std::move(block));
    else
        out.push_back(std::move(block->body.back()));
}

void Checker::jumpStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    bool breaks = s.kind == ast::StmtKind::Break;
    size_t loops = context_.loops.size();
    std::string word = breaks ? "break" : "continue";
    if (loops == 0) {
        reporter_.error(s.where, "'" + word + "' stands in no loop");
        return;
    }
    if (size_t(s.levels) > loops) {
        reporter_.error(s.where,
                        "'" + word + " " + std::to_string(s.levels) +
                            "' wants more loops than stand around it: " + std::to_string(loops));
        return;
    }
    StmtPtr result = make(breaks ? StmtKind::Break : StmtKind::Continue, s.where);
    result->target = context_.loops[loops - size_t(s.levels)];
    out.push_back(std::move(result));
}

void Checker::returnStatement(const ast::Stmt &s, std::vector<StmtPtr> &out) {
    StmtPtr result = make(StmtKind::Return, s.where);
    if (!context_.definition) {
        if (s.value)
            reporter_.error(s.value->where, "a shader returns no value");
        out.push_back(std::move(result));
        return;
    }
    FunctionDefinition &definition = *context_.definition;
    context_.returns = true;
    const std::string &name = definition.syntax->name;
    if (s.value && !definition.result) {
        result->value = check(*s.value);
        if (result->value)
            definition.result = result->value->type.base;
    } else if (s.value && *definition.result == BaseType::Void) {
        reporter_.error(s.value->where, "void function " + name + " cannot return a value");
    } else if (s.value) {
        result->value = checkAs(*s.value, *definition.result, "what " + name + " returns");
    } else if (definition.result.value_or(BaseType::Void) != BaseType::Void) {
        reporter_.error(s.where,
                        "function " + name + " must return a " + nameOf(*definition.result));
    }
    if (context_.varyingControl || (result->value && result->value->type.isVarying()))
        context_.resultDetail = Detail::Varying;
    out.push_back(std::move(result));
}

} // namespace candela::sl

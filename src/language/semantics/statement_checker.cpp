// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/statement_checker.h"

#include "language/semantics/gather_statement.h"
#include "language/semantics/light_arguments.h"
#include "language/semantics/targets.h"
#include "language/semantics/typed_nodes.h"
#include "language/semantics/user_functions.h"
#include "language/semantics/variables.h"

namespace candela::sl {

void StatementChecker::check(const std::vector<ast::StmtPtr> &list, Statements &out) {
    for (const ast::StmtPtr &s : list)
        statement(*s, out);
}

void StatementChecker::scoped(const ast::Stmt &s, Statements &out) {
    Names::InnerScope scope(here_.names);
    if (s.kind == ast::StmtKind::Block)
        check(s.body, out);
    else
        statement(s, out);
}

void StatementChecker::statement(const ast::Stmt &s, Statements &out) {
    switch (s.kind) {
    case ast::StmtKind::Empty: return;
    case ast::StmtKind::Block: {
        StmtPtr block = makeNode(StmtKind::Block, s.where);
        scoped(s, block->body);
        out.push_back(std::move(block));
        return;
    }
    case ast::StmtKind::Declare:
        for (const ast::Variable &variable : s.variables)
            declaration(variable, out);
        return;
    case ast::StmtKind::Function: here_.functions.define(*s.function, here_.names.scope()); return;
    case ast::StmtKind::Evaluate: evaluation(s, out); return;
    case ast::StmtKind::If: ifStatement(s, out); return;
    case ast::StmtKind::While:
    case ast::StmtKind::For: loop(s, out); return;
    case ast::StmtKind::Break:
    case ast::StmtKind::Continue: jump(s, out); return;
    case ast::StmtKind::Return: returnStatement(s, out); return;
    case ast::StmtKind::Illuminance:
    case ast::StmtKind::Illuminate:
    case ast::StmtKind::Solar: lightStatement(s, out); return;
    case ast::StmtKind::Gather: gatherStatement(s, out); return;
    }
}

void StatementChecker::declaration(const ast::Variable &v, Statements &out) {
    if (v.external)
        return here_.names.declareExternal(v);
    if (v.output)
        here_.reporter.error(v.where, "only parameters can be output, not variable " + v.name);
    Type type = declaredType(v, naturalDetail(v.type), here_.reporter);
    // Its initial value still sees an outer variable of that name.
    std::vector<ExprPtr> values = initialValues(v, type, expressions_, here_.reporter);
    Symbol &symbol = here_.names.declare(Symbol::Kind::Local, v, type);
    for (const ExprPtr &value : values) {
        ExprPtr target = makeVariable(symbol, v.where);
        if (!detailFits(*target, value->type.detail, value->where, here_.reporter))
            break;
    }
    StmtPtr result = makeNode(StmtKind::Declare, v.where);
    result->symbol = &symbol;
    result->values = std::move(values);
    out.push_back(std::move(result));
}

void StatementChecker::evaluation(const ast::Stmt &s, Statements &out) {
    ExprPtr value = expressions_.check(*s.value);
    if (!value)
        return;
    bool acts = s.value->kind == ast::ExprKind::Assign || s.value->kind == ast::ExprKind::Call;
    if (!acts)
        here_.reporter.hint(s.value->where, "this expression has no effect");
    StmtPtr result = makeNode(StmtKind::Evaluate, s.where);
    result->value = std::move(value);
    out.push_back(std::move(result));
}

ExprPtr StatementChecker::condition(const ast::Expr &e) {
    if (e.kind == ast::ExprKind::Assign && !e.compound)
        here_.reporter.hint(e.where, "'=' assigns; did you mean '=='?");
    return expressions_.checkAs(e, BaseType::Float, "a condition");
}

void StatementChecker::ifStatement(const ast::Stmt &s, Statements &out) {
    StmtPtr result = makeNode(StmtKind::If, s.where);
    result->value = condition(*s.value);
    bool outer = varyingControl_;
    bool varies = result->value && result->value->type.isVarying();
    varyingControl_ = outer || varies;
    bool returned = returned_.any;
    scoped(*s.body[0], result->body);
    if (s.body.size() > 1)
        scoped(*s.body[1], result->otherwise);
    // Behind a return that only some points took, all is under varying control.
    bool someReturned = varies && returned_.any && !returned;
    varyingControl_ = outer || someReturned;
    if (result->value)
        out.push_back(std::move(result));
}

void StatementChecker::loop(const ast::Stmt &s, Statements &out) {
    Names::InnerScope scope(here_.names);
    bool outer = varyingControl_;
    StmtPtr block = makeNode(StmtKind::Block, s.where);
    if (s.first)
        statement(*s.first, block->body);
    StmtPtr loop = loopItself(s);
    varyingControl_ = outer;
    if (!loop)
        return;
    if (!s.first)
        return out.push_back(std::move(loop));
    block->body.push_back(std::move(loop));
    out.push_back(std::move(block));
}

/// Without the initialiser of `for`; null if the condition is wrong.
StmtPtr StatementChecker::loopItself(const ast::Stmt &s) {
    StmtPtr result = makeNode(StmtKind::Loop, s.where);
    if (s.value)
        result->value = condition(*s.value);
    if (result->value && result->value->type.isVarying())
        varyingControl_ = true;
    loops_.push_back(result.get());
    scoped(*s.body[0], result->body);
    loops_.pop_back();
    for (const ast::ExprPtr &step : s.steps)
        if (ExprPtr e = expressions_.check(*step))
            result->steps.push_back(std::move(e));
    bool failed = s.value && !result->value;
    return failed ? nullptr : std::move(result);
}

void StatementChecker::gatherStatement(const ast::Stmt &s, Statements &out) {
    Names::InnerScope scope(here_.names);
    auto gather = checkGather(s, here_, expressions_);
    if (!gather)
        return;
    const bool outer = varyingControl_;
    varyingControl_ = true;
    StmtPtr block = makeNode(StmtKind::Block, s.where), loop = makeNode(StmtKind::Loop, s.where);
    StmtPtr choice = makeNode(StmtKind::If, s.where);
    loops_.push_back(loop.get());
    scoped(*s.body[0], choice->body);
    if (s.body.size() > 1)
        scoped(*s.body[1], choice->otherwise);
    loops_.pop_back();
    varyingControl_ = outer;
    choice->value = std::move(gather->hit);
    loop->value = std::move(gather->more);
    loop->steps.push_back(std::move(gather->next));
    loop->body.push_back(std::move(choice));
    for (StmtPtr &declaration : gather->declarations)
        block->body.push_back(std::move(declaration));
    block->body.push_back(std::move(loop));
    out.push_back(std::move(block));
}

void StatementChecker::jump(const ast::Stmt &s, Statements &out) {
    bool breaks = s.kind == ast::StmtKind::Break;
    std::string word = breaks ? "break" : "continue";
    size_t levels = size_t(s.levels);
    if (loops_.empty()) {
        here_.reporter.error(s.where, "'" + word + "' stands in no loop");
        return;
    }
    if (levels > loops_.size()) {
        here_.reporter.error(s.where, "'" + word + " " + std::to_string(levels) +
                                          "' wants more loops than stand around it: " +
                                          std::to_string(loops_.size()));
        return;
    }
    StmtPtr result = makeNode(breaks ? StmtKind::Break : StmtKind::Continue, s.where);
    result->target = loops_[loops_.size() - levels];
    out.push_back(std::move(result));
}

void StatementChecker::returnStatement(const ast::Stmt &s, Statements &out) {
    StmtPtr result = makeNode(StmtKind::Return, s.where);
    if (definition_)
        result->value = returnedValue(s);
    else if (s.value)
        here_.reporter.error(s.value->where, "a shader returns no value");
    out.push_back(std::move(result));
}

/// Null if there is none, or a wrong one. The first return decides what an untyped function
/// returns.
ExprPtr StatementChecker::returnedValue(const ast::Stmt &s) {
    ExprPtr value;
    std::optional<BaseType> &result = definition_->result;
    const std::string &name = definition_->syntax->name;
    returned_.any = true;
    if (s.value && !result) {
        value = expressions_.check(*s.value);
        if (value)
            result = value->type.base;
    } else if (s.value && *result == BaseType::Void) {
        here_.reporter.error(s.value->where, "void function " + name + " cannot return a value");
    } else if (s.value) {
        value = expressions_.checkAs(*s.value, *result, "what " + name + " returns");
    } else if (result.value_or(BaseType::Void) != BaseType::Void) {
        here_.reporter.error(s.where, "function " + name + " must return a " + nameOf(*result));
    }
    if (varyingControl_ || (value && value->type.isVarying()))
        returned_.detail = Detail::Varying;
    return value;
}

void StatementChecker::lightStatement(const ast::Stmt &s, Statements &out) {
    if (!lightStatementAllowed(s, here_))
        return;
    StmtKind kind = s.kind == ast::StmtKind::Illuminance  ? StmtKind::Illuminance
                    : s.kind == ast::StmtKind::Illuminate ? StmtKind::Illuminate
                                                          : StmtKind::Solar;
    StmtPtr result = makeNode(kind, s.where);
    CheckedLight checked = checkLightArguments(s, here_, expressions_);
    result->light = std::move(checked.light);
    for (ExprPtr &call : checked.received) {
        StmtPtr received = makeNode(StmtKind::Evaluate, call->where);
        received->value = std::move(call);
        result->body.push_back(std::move(received));
    }
    if (here_.function)
        here_.function->hasLightStatement = true;
    bool outer = varyingControl_;
    varyingControl_ = true;
    here_.lightStatement = result.get();
    loops_.push_back(result.get());
    scoped(*s.body[0], result->body);
    loops_.pop_back();
    here_.lightStatement = nullptr;
    varyingControl_ = outer;
    out.push_back(std::move(result));
}

} // namespace candela::sl

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/scan.h"

#include "foundation/base/deep_stack.h"
#include "language/ir/lower/lower.h"
#include "language/semantics/named_arguments.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// Visits every node of a tree, parents first.
class Walker {
public:
    virtual ~Walker() = default;

    void walk(const sl::Expr *expr) {
        if (!expr)
            return;
        visit(*expr);
        for (const sl::ExprPtr &operand : expr->operands)
            walk(operand.get());
    }
    void walk(const std::vector<sl::StmtPtr> &list) {
        for (const sl::StmtPtr &statement : list)
            walk(*statement);
    }
    void walk(const sl::Stmt &statement) {
        visit(statement);
        walk(statement.value.get());
        for (const sl::ExprPtr &value : statement.values)
            walk(value.get());
        if (statement.light)
            walk(*statement.light);
        walk(statement.body);
        walk(statement.otherwise);
        for (const sl::ExprPtr &step : statement.steps)
            walk(step.get());
    }

protected:
    virtual void visit(const sl::Expr &) {}
    virtual void visit(const sl::Stmt &) {}

private:
    void walk(const sl::LightArguments &light) {
        for (const sl::ExprPtr *part :
             {&light.category, &light.position, &light.axis, &light.angle, &light.coneCount})
            walk(part->get());
        for (const sl::Cone &cone : light.cones)
            for (const sl::ExprPtr *part :
                 {&cone.axis, &cone.angle, &cone.exponent, &cone.importance})
                walk(part->get());
    }
};

template <class T> void addOnce(std::vector<T> &list, T item) {
    if (std::find(list.begin(), list.end(), item) == list.end())
        list.push_back(item);
}

/// Whether calls draw random numbers.
bool drawsRandom(const sl::Builtin &function) {
    using enum sl::BuiltinId;
    constexpr sl::BuiltinId drawing[] = {random, occlusion, transmission, visibility};
    return std::ranges::find(drawing, function.id) != std::end(drawing);
}

/// Collects what is assigned, following calls into the functions' bodies.
class AssignmentWalker : public Walker {
public:
    const std::vector<const sl::Symbol *> &everything() const { return assigned_; }
    std::vector<const sl::Symbol *> outside() const {
        std::vector<const sl::Symbol *> result;
        for (const sl::Symbol *symbol : assigned_)
            if (!inside_.contains(symbol) && !called_.contains(symbol->owner))
                result.push_back(symbol);
        return result;
    }

    bool draws = false, loops = false;

protected:
    void visit(const sl::Stmt &statement) override {
        if (statement.kind == sl::StmtKind::Declare)
            inside_.insert(statement.symbol);
        loops |= statement.kind == sl::StmtKind::Loop;
    }
    void visit(const sl::Expr &expr) override {
        if (expr.kind == sl::ExprKind::Assign)
            assign(*expr.operands[0]);
        else if (expr.kind == sl::ExprKind::Builtin)
            assignOutputs(expr);
        else if (expr.kind == sl::ExprKind::Call)
            enter(expr);
    }

private:
    void assign(const sl::Expr &target) {
        if (const sl::Symbol *symbol = rootSymbol(target))
            addOnce(assigned_, symbol);
    }
    void assignOutputs(const sl::Expr &call) {
        draws |= drawsRandom(*call.overload->function);
        for (size_t i = 0; i < call.operands.size(); ++i)
            if (sl::setsOperand(call, i))
                assign(*call.operands[i]);
    }
    void enter(const sl::Expr &call) {
        for (size_t i = 0; i < call.operands.size(); ++i)
            if (call.function->formals[i]->output)
                assign(*call.operands[i]);
        if (called_.insert(call.function).second)
            walk(call.function->body);
    }

    std::vector<const sl::Symbol *> assigned_;
    std::set<const sl::Symbol *> inside_;
    std::set<const sl::Function *> called_;
};

/// Collects jumps that leave the statement's rounds.
class JumpWalker : public Walker {
public:
    explicit JumpWalker(LoopEffects &effects) : effects_(effects) {}

    void forgetInner() {
        const auto inner = [&](const sl::Stmt *target) { return inner_.contains(target); };
        std::erase_if(effects_.breaks, inner);
        std::erase_if(effects_.continues, inner);
    }

protected:
    void visit(const sl::Stmt &statement) override {
        switch (statement.kind) {
        case sl::StmtKind::Loop:
        case sl::StmtKind::Illuminance:
        case sl::StmtKind::Illuminate:
        case sl::StmtKind::Solar: inner_.insert(&statement); break;
        case sl::StmtKind::Break: addOnce(effects_.breaks, statement.target); break;
        case sl::StmtKind::Continue: addOnce(effects_.continues, statement.target); break;
        case sl::StmtKind::Return: effects_.returns = true; break;
        default: break;
        }
    }

private:
    LoopEffects &effects_;
    std::set<const sl::Stmt *> inner_;
};

class CostWalker : public Walker {
public:
    int cost = 0;
    bool effects = false;

protected:
    void visit(const sl::Expr &expr) override {
        ++cost;
        if (expr.kind == sl::ExprKind::Assign || expr.kind == sl::ExprKind::Call)
            effects = true;
        if (expr.kind == sl::ExprKind::FromSpace)
            cost += 10;
        if (expr.kind == sl::ExprKind::Builtin)
            visitBuiltin(expr);
    }

private:
    void visitBuiltin(const sl::Expr &call) {
        for (size_t i = 0; i < call.operands.size(); ++i)
            effects = effects || sl::setsOperand(call, i);
        const sl::Builtin &function = *call.overload->function;
        const sl::Lowering lowering = function.lowering;
        effects = effects || function.id == sl::BuiltinId::random ||
                  (lowering != sl::Lowering::Inline && lowering != sl::Lowering::Runtime &&
                   lowering != sl::Lowering::Context);
        cost += lowering == sl::Lowering::Inline ? 3 : 10;
    }
};

class GatheringWalker : public Walker {
public:
    bool gathers = false;

protected:
    void visit(const sl::Stmt &statement) override {
        gathers |= statement.kind == sl::StmtKind::Illuminance;
    }
    void visit(const sl::Expr &expr) override {
        using enum sl::BuiltinId;
        if (expr.kind != sl::ExprKind::Builtin)
            return;
        const sl::BuiltinId id = expr.overload->function->id;
        gathers |= id == diffuse || id == specular || id == phong || id == irradiance;
    }
};

class ArrayWalker : public Walker {
public:
    std::set<const sl::Symbol *> computed;
    struct Passing {
        const sl::Symbol *argument, *formal;
    };
    std::vector<Passing> passings;

protected:
    void visit(const sl::Expr &expr) override {
        if (expr.kind == sl::ExprKind::Element) {
            if (expr.operands[1]->kind != sl::ExprKind::Number)
                computed.insert(rootSymbol(expr));
        } else if (expr.kind == sl::ExprKind::Call) {
            for (size_t i = 0; i < expr.operands.size(); ++i)
                if (expr.operands[i]->type.isArray())
                    passings.push_back({rootSymbol(*expr.operands[i]), expr.function->formals[i]});
        }
    }
};

class TextChoiceWalker : public Walker {
public:
    bool chooses = false;

protected:
    void visit(const sl::Expr &expr) override {
        if (expr.type.base != sl::BaseType::String)
            return;
        const bool isBuilt = expr.kind == sl::ExprKind::Builtin && !expr.operands.empty();
        const bool isChosen =
            expr.kind == sl::ExprKind::Element && expr.operands[1]->kind != sl::ExprKind::Number;
        chooses |= isBuilt || isChosen || expr.kind == sl::ExprKind::Assign;
    }
};

class TextWalker : public Walker {
public:
    std::vector<std::string> texts;

protected:
    void visit(const sl::Expr &expr) override {
        if (expr.kind == sl::ExprKind::Text)
            addOnce(texts, expr.text);
    }
};

class AskingWalker : public Walker {
public:
    bool asks = false;

protected:
    void visit(const sl::Expr &expr) override {
        if (expr.kind != sl::ExprKind::Builtin)
            return;
        switch (expr.overload->function->id) {
        case sl::BuiltinId::surface:
        case sl::BuiltinId::displacement:
        case sl::BuiltinId::atmosphere:
        case sl::BuiltinId::incident:
        case sl::BuiltinId::opposite: asks = true; break;
        default: break;
        }
    }
};

/// Everything that the shader runs, but for its parameters' defaults.
void walkAll(const sl::TypedShader &shader, Walker &walker) {
    walker.walk(shader.body);
    for (const auto &function : shader.functions)
        walker.walk(function->body);
}

} // namespace

std::vector<std::string> textsOf(const sl::TypedShader &shader) {
    TextWalker walker;
    onDeepStack([&] {
        walkAll(shader, walker);
        for (const sl::Parameter &parameter : shader.parameters)
            for (const sl::ExprPtr &value : parameter.defaults)
                walker.walk(value.get());
    });
    return walker.texts;
}

bool choosesTexts(const sl::Stmt &loop) {
    TextChoiceWalker walker;
    walker.walk(loop);
    return walker.chooses;
}

std::set<const sl::Symbol *> fixedTexts(const sl::TypedShader &shader) {
    AssignmentWalker assignments;
    ArrayWalker arrays;
    walkAll(shader, assignments);
    walkAll(shader, arrays);
    std::set<const sl::Symbol *> fixed;
    for (const sl::Symbol *symbol : arrays.computed)
        if (symbol && symbol->type.base == sl::BaseType::String && !symbol->written)
            fixed.insert(symbol);
    for (const sl::Symbol *symbol : assignments.everything())
        fixed.erase(symbol);
    for (const ArrayWalker::Passing &passing : arrays.passings)
        if (passing.formal->written)
            fixed.erase(passing.argument);
    return fixed;
}

bool asksOtherShaders(const sl::TypedShader &shader) {
    AskingWalker walker;
    onDeepStack([&] { walkAll(shader, walker); });
    return walker.asks;
}

const sl::Symbol *rootSymbol(const sl::Expr &expr) {
    const sl::Expr *root = &expr;
    while (root->kind == sl::ExprKind::Element || root->kind == sl::ExprKind::Component)
        root = root->operands[0].get();
    return root->kind == sl::ExprKind::Variable ? root->symbol : nullptr;
}

LoopEffects loopEffects(const sl::Stmt &loop) {
    LoopEffects effects;
    AssignmentWalker assignments;
    if (loop.kind == sl::StmtKind::Loop)
        assignments.walk(loop); // The condition and the steps run each round, too.
    else
        assignments.walk(loop.body);
    effects.assigned = assignments.outside();
    effects.drawsAnew = assignments.draws && assignments.loops;
    JumpWalker jumps(effects);
    jumps.walk(loop.body);
    jumps.forgetInner();
    return effects;
}

bool isCheapAndPure(const sl::Expr &expr) {
    CostWalker walker;
    walker.walk(&expr);
    return !walker.effects && walker.cost < 16;
}

bool gathersLight(const sl::TypedShader &shader) {
    GatheringWalker walker;
    walkAll(shader, walker);
    return walker.gathers;
}

std::set<const sl::Symbol *> computedArrays(const sl::TypedShader &shader) {
    ArrayWalker walker;
    walkAll(shader, walker);
    for (bool grown = true; grown;) {
        grown = false;
        for (const ArrayWalker::Passing &passing : walker.passings)
            if (walker.computed.contains(passing.formal))
                grown |= walker.computed.insert(passing.argument).second;
    }
    return walker.computed;
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/gather_statement.h"

#include "language/semantics/named_arguments.h"
#include "language/semantics/type_inference.h"
#include "language/semantics/typed_nodes.h"

#include <span>

namespace candela::sl {
namespace {

using Arguments = std::span<const ast::ExprPtr>;

constexpr size_t fixedArguments = 4; // Position, axis, angle, samples.
constexpr float mostSamples = 4096;  // As occlusion() and transmission() take.

/// What follows the fixed arguments: names and values; false if one is wrong.
bool addOptional(Arguments given, ExpressionChecker &expressions, const Surroundings &here,
                 std::vector<ExprPtr> &operands) {
    for (size_t i = 0; i < given.size(); i += 2) {
        if (given[i]->kind != ast::ExprKind::Text || i + 1 == given.size()) {
            here.reporter.error(given[i]->where, "behind the number of samples gather takes pairs "
                                                 "of a name (a string constant) and a value");
            return false;
        }
        const ast::Expr &value = *given[i + 1];
        const bool isResult = isResultName(BuiltinId::gather, given[i]->text);
        ExprPtr checked = isResult ? expressions.checkTarget(value) : expressions.check(value);
        if (!checked)
            return false;
        operands.push_back(makeText(given[i]->text, given[i]->where));
        operands.push_back(std::move(checked));
    }
    return true;
}

/// In [0, 1), the same in all turns.
ExprPtr randomNumber(const Place &where) {
    ExprPtr result = makeNode(ExprKind::Builtin, {BaseType::Float, Detail::Varying, 0}, where);
    result->overload = &builtin(BuiltinId::random).overloads[0];
    return result;
}

/// As many as are wanted, within bounds.
ExprPtr turnsOf(ExprPtr wanted, const Place &where) {
    ExprPtr result = makeNode(ExprKind::Builtin, {BaseType::Float, Detail::Varying, 0}, where,
                              list(std::move(wanted), makeNumber(mostSamples, where)));
    result->overload = &builtin(BuiltinId::min).overloads[0];
    return result;
}

/// A variable that no text can name.
Symbol &addLocal(const char *name, ExprPtr value, const ast::Stmt &s, Surroundings &here,
                 GatherLoop &loop) {
    ast::Variable variable;
    variable.name = name;
    variable.where = s.where;
    Symbol &symbol =
        here.names.declare(Symbol::Kind::Local, variable, {BaseType::Float, Detail::Varying, 0});
    symbol.read = symbol.written = true;
    StmtPtr declaration = makeNode(StmtKind::Declare, s.where);
    declaration->symbol = &symbol;
    declaration->values = list(std::move(value));
    loop.declarations.push_back(std::move(declaration));
    return symbol;
}

} // namespace

std::optional<GatherLoop> checkGather(const ast::Stmt &s, Surroundings &here,
                                      ExpressionChecker &expressions) {
    Arguments given = s.arguments;
    if (!given.empty() && typesOf(*given[0], here).isOnly(BaseType::String))
        given = given.subspan(1); // Which of the ways to gather; there is one.
    if (given.size() < fixedArguments) {
        here.reporter.error(s.where, "gather needs a category, a position, a direction, an angle "
                                     "and a number of samples");
        return std::nullopt;
    }
    GatherLoop loop;
    Symbol &turn = addLocal("gather turn", makeNumber(0, s.where), s, here, loop);
    Symbol *shift[] = {&addLocal("gather x", randomNumber(s.where), s, here, loop),
                       &addLocal("gather y", randomNumber(s.where), s, here, loop)};
    std::vector<ExprPtr> operands;
    operands.push_back(expressions.checkAs(*given[0], BaseType::Point, "the position of gather"));
    operands.push_back(expressions.checkAs(*given[1], BaseType::Vector, "the axis of gather"));
    operands.push_back(expressions.checkAs(*given[2], BaseType::Float, "the angle of gather"));
    operands.push_back(makeVariable(turn, s.where));
    operands.push_back(
        expressions.checkAs(*given[3], BaseType::Float, "the number of samples of gather"));
    for (Symbol *symbol : shift)
        operands.push_back(makeVariable(*symbol, s.where));
    for (const ExprPtr &operand : operands)
        if (!operand)
            return std::nullopt;
    if (!addOptional(given.subspan(fixedArguments), expressions, here, operands))
        return std::nullopt;

    ExprPtr samples =
        expressions.checkAs(*given[3], BaseType::Float, "the number of samples of gather");
    loop.more = makeBinary(BinaryOp::Less, BaseType::Float, s.where, makeVariable(turn, s.where),
                           turnsOf(std::move(samples), s.where));
    loop.next = makeNode(ExprKind::Assign, single(BaseType::Float), s.where,
                         list(makeVariable(turn, s.where),
                              makeBinary(BinaryOp::Add, BaseType::Float, s.where,
                                         makeVariable(turn, s.where), makeNumber(1, s.where))));
    loop.hit = makeNode(ExprKind::Builtin, {BaseType::Float, Detail::Varying, 0}, s.where,
                        std::move(operands));
    loop.hit->overload = &builtin(BuiltinId::gather).overloads[0];
    return loop;
}

} // namespace candela::sl

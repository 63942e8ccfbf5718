// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/statement.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/light.h"
#include "language/ir/lower/scan.h"

#include <algorithm>
#include <functional>

namespace candela::ir {
namespace {

/// Of the rounds of a loop that stand in each other the innermost is meant.
void jump(Lowering &lowering, const sl::Stmt &statement) {
    const std::vector<OpenLoop> &loops = lowering.frames.back().loops;
    const auto loop = std::find_if(loops.rbegin(), loops.rend(), [&](const OpenLoop &open) {
        return open.statement == statement.target;
    });
    if (loop != loops.rend())
        lowering.variables
            .cells[statement.kind == sl::StmtKind::Break ? loop->broken : loop->continued] =
            boolean(lowering.b, true);
}

void declareLocal(Lowering &lowering, const sl::Stmt &statement) {
    const sl::Symbol &symbol = *statement.symbol;
    Components initial = zero(lowering.b, symbol.type.base, symbol.type.length);
    size_t next = 0;
    for (const sl::ExprPtr &value : statement.values)
        for (ValueId component : evaluate(lowering, *value))
            if (next < initial.size())
                initial[next++] = component;
    lowering.variables.declare(symbol, initial);
}

/// An "if" that is all that stands behind the "else"; null if there is none.
const sl::Stmt *nextLink(const sl::Stmt &choice) {
    const auto &otherwise = choice.otherwise;
    const bool isLink = otherwise.size() == 1 && otherwise[0]->kind == sl::StmtKind::If;
    return isLink ? otherwise[0].get() : nullptr;
}

bool isLongChain(const sl::Stmt &choice) {
    constexpr int mostNested = 64;
    int links = 0;
    for (const sl::Stmt *link = &choice; link && links <= mostNested; link = nextLink(*link))
        ++links;
    return links > mostNested;
}

/// A long chain: if (a) ... if (!a && b) ... if (!(a || b) && c) ..., beside each other and not
/// within, as the passes that go down regions and the code of masks would rather have it.
class Chain {
public:
    explicit Chain(Lowering &lowering)
        : lowering_(lowering), b_(lowering.b),
          taken_(size_t(lowering.variables.newCells({boolean(lowering.b, false)}))) {}

    void lower(const sl::Stmt &choice) {
        for (const sl::Stmt *link = &choice; link; link = nextLink(*link)) {
            if (isTooLarge(lowering_, link->where))
                return;
            b_.setLine(link->where.line);
            add(*link);
            if (!nextLink(*link))
                branch(
                    lowering_, isOpen(), [&] { ir::lower(lowering_, link->otherwise); }, [] {});
        }
    }

private:
    ValueId isOpen() { return negate(b_, lowering_.variables.cells[taken_]); }

    void add(const sl::Stmt &link) {
        const auto ask = [&] { return condition(lowering_, *link.value); };
        if (isCheapAndPure(*link.value))
            return takeWhere(both(b_, isOpen(), ask()), link);
        branch(
            lowering_, isOpen(), [&] { takeWhere(ask(), link); }, [] {});
    }
    void takeWhere(ValueId decision, const sl::Stmt &link) {
        branch(
            lowering_, decision, [&] { ir::lower(lowering_, link.body); }, [] {});
        ValueId &taken = lowering_.variables.cells[taken_];
        taken = either(b_, taken, decision);
    }

    Lowering &lowering_;
    Builder &b_;
    const size_t taken_; ///< Cell.
};

void lowerChoice(Lowering &lowering, const sl::Stmt &choice) {
    if (isLongChain(choice))
        return Chain(lowering).lower(choice);
    const ValueId decision = condition(lowering, *choice.value);
    branch(
        lowering, decision, [&] { lower(lowering, choice.body); },
        [&] { lower(lowering, choice.otherwise); });
}

void returnFrom(Lowering &lowering, const sl::Stmt &statement) {
    if (statement.value) {
        const Components value = evaluate(lowering, *statement.value);
        lowering.variables.setCells(lowering.frames.back().result, value);
    }
    lowering.variables.cells[lowering.frames.back().returned] = boolean(lowering.b, true);
}

} // namespace

void lower(Lowering &lowering, const std::vector<sl::StmtPtr> &list, size_t first) {
    for (size_t i = first; i < list.size(); ++i) {
        lower(lowering, *list[i]);
        if (i + 1 < list.size() && !liveFlags(lowering).empty()) {
            whereLive(lowering, [&, i] { lower(lowering, list, i + 1); });
            return;
        }
    }
}

void lower(Lowering &lowering, const sl::Stmt &statement) {
    if (isTooLarge(lowering, statement.where))
        return;
    lowering.b.setLine(statement.where.line);
    switch (statement.kind) {
    case sl::StmtKind::Block: lower(lowering, statement.body); break;
    case sl::StmtKind::Declare: declareLocal(lowering, statement); break;
    case sl::StmtKind::Evaluate: evaluate(lowering, *statement.value); break;
    case sl::StmtKind::If: lowerChoice(lowering, statement); break;
    case sl::StmtKind::Loop: lowerLoop(lowering, statement); break;
    case sl::StmtKind::Break:
    case sl::StmtKind::Continue: jump(lowering, statement); break;
    case sl::StmtKind::Return: returnFrom(lowering, statement); break;
    case sl::StmtKind::Illuminance: lowerIlluminance(lowering, statement); break;
    case sl::StmtKind::Illuminate: lowerIlluminate(lowering, statement); break;
    case sl::StmtKind::Solar: lowerSolar(lowering, statement); break;
    }
}

} // namespace candela::ir

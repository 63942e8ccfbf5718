// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/statement.h"

#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/control.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/light.h"

#include <algorithm>

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
    case sl::StmtKind::If: {
        const ValueId decision = condition(lowering, *statement.value);
        branch(
            lowering, decision, [&] { lower(lowering, statement.body); },
            [&] { lower(lowering, statement.otherwise); });
        break;
    }
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

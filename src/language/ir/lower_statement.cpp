// SPDX-License-Identifier: Apache-2.0
#include "language/ir/builder_sources.h"
#include "language/ir/lower_internal.h"

namespace candela::ir {
namespace {

void jump(Lowering &lowering, const sl::Stmt &statement) {
    for (const OpenLoop &loop : lowering.frames.back().loops)
        if (loop.statement == statement.target)
            lowering.cells[statement.kind == sl::StmtKind::Break ? loop.broken : loop.continued] =
                boolean(lowering.b, true);
}

void declareLocal(Lowering &lowering, const sl::Stmt &statement) {
    const sl::Symbol &symbol = *statement.symbol;
    Components initial = lowering.zero(symbol.type.base, symbol.type.length);
    size_t next = 0;
    for (const sl::ExprPtr &value : statement.values)
        for (ValueId component : lowering.evaluate(*value))
            if (next < initial.size())
                initial[next++] = component;
    lowering.declare(symbol, initial);
}

void returnFrom(Lowering &lowering, const sl::Stmt &statement) {
    if (statement.value) {
        const Components value = lowering.evaluate(*statement.value);
        for (size_t i = 0; i < value.size(); ++i)
            lowering.cells[lowering.frames.back().result + int(i)] = value[i];
    }
    lowering.cells[lowering.frames.back().returned] = boolean(lowering.b, true);
}

} // namespace

void Lowering::lower(const std::vector<sl::StmtPtr> &list, size_t first) {
    for (size_t i = first; i < list.size(); ++i) {
        lower(*list[i]);
        if (i + 1 < list.size() && !liveFlags().empty()) {
            whereLive([&, i] { lower(list, i + 1); });
            return;
        }
    }
}

void Lowering::lower(const sl::Stmt &statement) {
    b.setLine(statement.where.line);
    switch (statement.kind) {
    case sl::StmtKind::Block: lower(statement.body); break;
    case sl::StmtKind::Declare: declareLocal(*this, statement); break;
    case sl::StmtKind::Evaluate: evaluate(*statement.value); break;
    case sl::StmtKind::If: {
        const ValueId decision = condition(*statement.value);
        branch(
            decision, [&] { lower(statement.body); }, [&] { lower(statement.otherwise); });
        break;
    }
    case sl::StmtKind::Loop: lowerLoop(statement); break;
    case sl::StmtKind::Break:
    case sl::StmtKind::Continue: jump(*this, statement); break;
    case sl::StmtKind::Return: returnFrom(*this, statement); break;
    case sl::StmtKind::Illuminance: lowerIlluminance(statement); break;
    case sl::StmtKind::Illuminate: lowerIlluminate(statement); break;
    case sl::StmtKind::Solar: lowerSolar(statement); break;
    }
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/control.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/expression.h"
#include "language/ir/lower/limits.h"
#include "language/ir/lower/place_scope.h"
#include "language/ir/lower/scan.h"
#include "language/ir/lower/statement.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// One of two bools by a third, without a branch where constants allow it.
ValueId chooseBool(Builder &b, ValueId condition, ValueId then, ValueId otherwise) {
    if (const auto known = constantBool(b, then))
        return *known ? either(b, condition, otherwise) : both(b, negate(b, condition), otherwise);
    if (const auto known = constantBool(b, otherwise))
        return *known ? either(b, negate(b, condition), then) : both(b, condition, then);
    return select(b, condition, then, otherwise);
}

bool isKnownFalse(const Builder &b, ValueId flag) { return constantBool(b, flag) == false; }

} // namespace

void enter(Lowering &lowering, const sl::Function *function) {
    Builder &b = lowering.b;
    const Components none = function ? zero(b, function->result.base) : Components{};
    Frame frame{.function = function, .returned = 0, .result = 0, .loops = {}};
    frame.returned = lowering.variables.newCells({boolean(b, false)});
    frame.result = lowering.variables.newCells(none);
    lowering.frames.push_back(frame);
}

void branch(Lowering &lowering, ValueId condition, const std::function<void()> &then,
            const std::function<void()> &otherwise, const std::vector<int> &clear) {
    Builder &b = lowering.b;
    std::vector<ValueId> &cells = lowering.variables.cells;
    if (const auto known = constantBool(b, condition)) {
        (*known ? then : otherwise)();
        return;
    }
    const std::vector<ValueId> before = cells;
    const auto side = [&](const std::function<void()> &lowerSide) {
        Region region = b.region({}, [&] {
            lowerSide();
            return Components{};
        });
        std::vector<ValueId> after = std::move(cells);
        after.resize(before.size());
        cells = before;
        return std::pair(std::move(region), std::move(after));
    };
    auto [thenRegion, thenCells] = side([&] {
        for (int flag : clear)
            cells[flag] = boolean(b, false);
        then();
    });
    for (int flag : clear)
        if (isKnownFalse(b, thenCells[flag]))
            thenCells[flag] = before[flag]; // False on this side already.
    auto [otherRegion, otherCells] = side(otherwise);

    const bool empty = thenRegion.body.empty() && otherRegion.body.empty();
    Instruction instruction{.op = Op::If, .operands = {condition}, .results = {}, .regions = {}};
    instruction.line = b.line();
    for (size_t i = 0; i < before.size(); ++i) {
        const ValueId a = thenCells[i], o = otherCells[i];
        if (a == o) {
            cells[i] = a;
        } else if (b.type(a) == Type::Bool && empty) {
            cells[i] = chooseBool(b, condition, a, o);
        } else if (empty) {
            cells[i] = select(b, condition, a, o);
        } else {
            thenRegion.yields.push_back(a);
            otherRegion.yields.push_back(o);
            cells[i] = b.newValue(b.type(a), Uniformity::Uniform);
            instruction.results.push_back(cells[i]);
            b.unitVectors.note(Op::Select, {condition, a, o}, cells[i]);
        }
    }
    if (empty)
        return;
    instruction.regions.push_back(std::move(thenRegion));
    instruction.regions.push_back(std::move(otherRegion));
    b.append(std::move(instruction));
}

std::vector<int> liveFlags(Lowering &lowering) {
    const Frame &frame = lowering.frames.back();
    std::vector<int> flags{frame.returned};
    for (const OpenLoop &loop : frame.loops) {
        flags.push_back(loop.broken);
        flags.push_back(loop.continued);
    }
    std::erase_if(
        flags, [&](int flag) { return isKnownFalse(lowering.b, lowering.variables.cells[flag]); });
    return flags;
}

static ValueId isLive(Lowering &lowering) {
    Builder &b = lowering.b;
    const std::vector<ValueId> &cells = lowering.variables.cells;
    ValueId stopped = boolean(b, false);
    for (int flag : liveFlags(lowering))
        stopped = isKnownFalse(b, stopped) ? cells[flag] : either(b, stopped, cells[flag]);
    return negate(b, stopped);
}

void whereLive(Lowering &lowering, const std::function<void()> &rest) {
    const std::vector<int> flags = liveFlags(lowering);
    if (flags.empty())
        rest();
    else
        branch(
            lowering, isLive(lowering), rest, [] {}, flags);
}

CarriedCells carriedCells(const Lowering &lowering, const sl::Stmt &loop) {
    const LoopEffects effects = loopEffects(loop);
    CarriedCells carried;
    for (const sl::Symbol *symbol : effects.assigned)
        lowering.variables.appendCells(*symbol, carried.variables);
    if (effects.drawsAnew)
        carried.variables.push_back(lowering.turn);
    carried.drawsAnew = effects.drawsAnew;
    const auto names = [](const std::vector<const sl::Stmt *> &list, const sl::Stmt *target) {
        return std::find(list.begin(), list.end(), target) != list.end();
    };
    carried.breaks = names(effects.breaks, &loop);
    const Frame &frame = lowering.frames.back();
    for (const OpenLoop &outer : frame.loops) {
        if (names(effects.breaks, outer.statement))
            carried.flags.push_back(outer.broken);
        if (names(effects.continues, outer.statement))
            carried.flags.push_back(outer.continued);
    }
    if (effects.returns) {
        carried.flags.push_back(frame.returned);
        const int count =
            frame.function ? componentCount(lowering.b, frame.function->result.base) : 0;
        for (int i = 0; i < count; ++i)
            carried.results.push_back(frame.result + i);
    }
    return carried;
}

namespace {

/// A round of a loop in whose cells stands what the round begins with. Gives whether there is
/// another one.
class Round {
public:
    Round(Lowering &lowering, const sl::Stmt &statement)
        : lowering_(lowering), statement_(statement) {
        const ValueId none = boolean(lowering.b, false);
        broken_ = lowering.variables.newCells({none, none, none});
    }

    /// Body and steps; then `next`, unless the round was broken or returned from.
    ValueId run(const std::function<ValueId()> &next) {
        std::vector<ValueId> &cells = lowering_.variables.cells;
        const int continued = broken_ + 1, goesOn = broken_ + 2;
        lowering_.frames.back().loops.push_back({&statement_, broken_, continued});
        lower(lowering_, statement_.body);
        cells[continued] = boolean(lowering_.b, false);
        whereLive(lowering_, [&] {
            for (const sl::ExprPtr &step : statement_.steps)
                evaluate(lowering_, *step);
            cells[goesOn] = next();
        });
        lowering_.frames.back().loops.pop_back();
        return cells[goesOn];
    }
    /// The condition, and only where it holds the rest.
    ValueId runWhere(ValueId condition) {
        const int goesOn = broken_ + 2;
        branch(
            lowering_, condition, [&] { run([&] { return boolean(lowering_.b, true); }); }, [] {});
        return lowering_.variables.cells[goesOn];
    }

private:
    Lowering &lowering_;
    const sl::Stmt &statement_;
    int broken_; ///< The first of three cells.
};

} // namespace

/// while (condition) body. A cheap condition is written twice: before the loop, and at the end of
/// each round. Others stand once, at the head of the rounds: they may call functions whose loops
/// have such conditions, and so on.
static void lowerRounds(Lowering &lowering, const sl::Stmt &statement) {
    Builder &b = lowering.b;
    Variables &variables = lowering.variables;
    std::vector<ValueId> &cells = variables.cells;
    const auto holds = [&] {
        return statement.value ? condition(lowering, *statement.value) : boolean(b, true);
    };
    const bool isCheap = !statement.value || isCheapAndPure(*statement.value);
    const ValueId first = isCheap ? holds() : boolean(b, true);
    if (isKnownFalse(b, first))
        return;

    const CarriedCells parts = carriedCells(lowering, statement);
    std::vector<int> carried = parts.variables;
    carried.insert(carried.end(), parts.results.begin(), parts.results.end());
    carried.insert(carried.end(), parts.flags.begin(), parts.flags.end());

    const std::vector<ValueId> before = cells;
    Components initial = variables.inCells(carried);
    initial.insert(initial.begin(), first);
    const auto round = [&](const Components &arguments) {
        variables.setCells(carried, {arguments.begin() + 1, arguments.end()});
        for (int flag : parts.flags)
            cells[flag] = boolean(b, false); // Or there would be no round.
        if (parts.drawsAnew)
            cells[lowering.turn] = add(b, cells[lowering.turn], number(b, 1));
        ++variables.openLoops;
        Round turn(lowering, statement);
        const ValueId goesOn = isCheap ? turn.run(holds) : turn.runWhere(holds());
        --variables.openLoops;
        Components yields = variables.inCells(carried);
        yields.insert(yields.begin(), goesOn);
        return yields;
    };
    const PlaceScope place(b, statement.where);
    const Components results = loop(b, initial, round);
    cells = before;
    variables.setCells(carried, {results.begin() + 1, results.end()});
}

/// The first rounds one in the other, as long as it is known that there is another one: where a
/// round may be broken, what it counts is known within what it has not broken.
static void writeRounds(Lowering &lowering, const sl::Stmt &statement, int most) {
    Builder &b = lowering.b;
    std::vector<ValueId> &cells = lowering.variables.cells;
    const auto holds =
        most > 0 ? constantBool(b, condition(lowering, *statement.value)) : std::nullopt;
    if (!holds)
        return lowerRounds(lowering, statement);
    if (!*holds)
        return;
    if (loopEffects(statement).drawsAnew)
        cells[lowering.turn] = add(b, cells[lowering.turn], number(b, 1));
    Round(lowering, statement).run([&] {
        writeRounds(lowering, statement, most - 1);
        return boolean(b, false);
    });
}

void lowerLoop(Lowering &lowering, const sl::Stmt &statement) {
    if (statement.value && isCheapAndPure(*statement.value) && choosesTexts(statement))
        writeRounds(lowering, statement, mostWrittenRounds);
    else
        lowerRounds(lowering, statement);
}

} // namespace candela::ir

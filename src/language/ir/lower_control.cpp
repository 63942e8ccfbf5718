// SPDX-License-Identifier: Apache-2.0
// Control flow: branches merge cells, loops carry them, jumps become flags.
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_control.h"
#include "language/ir/builder_sources.h"
#include "language/ir/lower_internal.h"

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

bool isKnownFalse(Builder &b, ValueId flag) { return constantBool(b, flag) == false; }

} // namespace

void Lowering::branch(ValueId condition, const std::function<void()> &then,
                      const std::function<void()> &otherwise, const std::vector<int> &clear) {
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
            cells[i] = b.newValue(b.type(a), Rate::Uniform);
            instruction.results.push_back(cells[i]);
        }
    }
    if (empty)
        return;
    instruction.regions.push_back(std::move(thenRegion));
    instruction.regions.push_back(std::move(otherRegion));
    b.append(std::move(instruction));
}

std::vector<int> Lowering::liveFlags() {
    std::vector<int> flags{frames.back().returned};
    for (const OpenLoop &loop : frames.back().loops) {
        flags.push_back(loop.broken);
        flags.push_back(loop.continued);
    }
    std::erase_if(flags, [&](int flag) { return isKnownFalse(b, cells[flag]); });
    return flags;
}

ValueId Lowering::isLive() {
    ValueId stopped = boolean(b, false);
    for (int flag : liveFlags())
        stopped = isKnownFalse(b, stopped) ? cells[flag] : either(b, stopped, cells[flag]);
    return negate(b, stopped);
}

void Lowering::whereLive(const std::function<void()> &rest) {
    const std::vector<int> flags = liveFlags();
    if (flags.empty())
        rest();
    else
        branch(
            isLive(), rest, [] {}, flags);
}

/// while (condition) body: the condition is evaluated before the loop and at the end of each
/// round, there only if the round was neither broken nor returned from.
void Lowering::lowerLoop(const sl::Stmt &loop) {
    const auto holds = [&] { return loop.value ? condition(*loop.value) : boolean(b, true); };
    const ValueId first = holds();
    if (isKnownFalse(b, first))
        return;

    const LoopEffects effects = loopEffects(loop);
    std::vector<int> carried;
    for (const sl::Symbol *symbol : effects.assigned)
        appendCells(*symbol, carried);
    std::vector<int> flags; // Of jumps to places outside of this loop.
    for (const OpenLoop &outer : frames.back().loops) {
        const auto jumpsTo = [&](const std::vector<const sl::Stmt *> &targets) {
            return std::find(targets.begin(), targets.end(), outer.statement) != targets.end();
        };
        if (jumpsTo(effects.breaks))
            flags.push_back(outer.broken);
        if (jumpsTo(effects.continues))
            flags.push_back(outer.continued);
    }
    if (effects.returns) {
        flags.push_back(frames.back().returned);
        const sl::Function *function = frames.back().function;
        const int count = function ? componentCount(function->result.base) : 0;
        for (int i = 0; i < count; ++i)
            carried.push_back(frames.back().result + i);
    }
    carried.insert(carried.end(), flags.begin(), flags.end());

    const std::vector<ValueId> before = cells;
    Components initial{first};
    for (int cell : carried)
        initial.push_back(cells[cell]);
    const auto round = [&](const Components &arguments) {
        for (size_t i = 0; i < carried.size(); ++i)
            cells[carried[i]] = arguments[i + 1];
        for (int flag : flags)
            cells[flag] = boolean(b, false); // Or there would be no round.
        const int none = newCells({boolean(b, false), boolean(b, false), boolean(b, false)});
        const int broken = none, continued = none + 1, next = none + 2;
        frames.back().loops.push_back({&loop, broken, continued});
        lower(loop.body);
        cells[continued] = boolean(b, false);
        whereLive([&] {
            for (const sl::ExprPtr &step : loop.steps)
                evaluate(*step);
            cells[next] = holds();
        });
        frames.back().loops.pop_back();
        Components yields{cells[next]};
        for (int cell : carried)
            yields.push_back(cells[cell]);
        return yields;
    };
    const Components results = ir::loop(b, initial, round);
    cells = before;
    for (size_t i = 0; i < carried.size(); ++i)
        cells[carried[i]] = results[i + 1];
}

} // namespace candela::ir

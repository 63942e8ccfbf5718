// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_demand.h"

#include "language/ir/core/dataflow.h"
#include "language/ir/transform/jet_rules.h"

#include <algorithm>
#include <array>

namespace candela::ir {

namespace {

/// Directions with which a value may change, a bit each.
using Directions = std::uint8_t;
constexpr Directions everyDirection = (1 << directionCount) - 1;

constexpr std::array<Direction, directionCount> directions{Direction::U, Direction::V};
constexpr Directions bit(Direction d) { return Directions(1 << int(d)); }

/// What changes at all.
struct Activity : ForwardAnalysis<Directions> {
    using ForwardAnalysis::ForwardAnalysis;

    Directions result(const Instruction &i, std::size_t, const Enclosing *) const {
        if (isArrayAccess(i.op))
            return arrayOf(i);
        Directions all = 0;
        for (Direction d : directions)
            if (changesWith(function, i, d))
                all |= bit(d);
        for (ValueId v : differentiableOperands(function, i))
            all |= at(v);
        return all;
    }
    Directions array(const Instruction &i, const Enclosing *) const {
        return i.op == Op::ArrayStore ? arrayOf(i) | at(i, 1) : arrayOf(i);
    }
    Directions given(const Instruction &, std::size_t) const { return everyDirection; }
    Directions flow(const ValueFlow &flow, const Enclosing *) const {
        Directions all = 0;
        for (ValueId v : flow.from)
            all |= at(v);
        return all;
    }
};

/// All orders at or below these in both directions.
Parts closed(const Parts &parts) {
    Parts result = parts;
    for (int part = partCount - 1; part > 0; --part)
        if (result[size_t(part)]) {
            const Order o = orderOf(part);
            if (o.u > 0)
                result.set(size_t(partOf({o.u - 1, o.v})));
            if (o.v > 0)
                result.set(size_t(partOf({o.u, o.v - 1})));
        }
    return result;
}

/// The orders that may differ from zero.
Parts possible(Directions active) {
    Parts result;
    for (int part = 0; part < partCount; ++part) {
        const Order o = orderOf(part);
        const bool still = (o.u > 0 && !(active & bit(Direction::U))) ||
                           (o.v > 0 && !(active & bit(Direction::V)));
        result.set(size_t(part), !still);
    }
    return result;
}

/// Backward: what the Slopes need.
class Demand {
public:
    explicit Demand(const Function &function) : function_(function), active_(function) {
        solve(active_);
        for (Directions d = 0; d <= everyDirection; ++d)
            possible_[d] = possible(d);
        demand.ofValue.resize(function.values.size());
        demand.ofArray.resize(function.arrays.size());
        do {
            changed_ = false;
            sweep(function.body);
        } while (changed_ && !demand.report.fault);
        if (!demand.report.fault)
            note(function.body);
    }
    JetDemand demand;

private:
    void add(Parts &to, const Parts &more) {
        changed_ |= (more & ~to).any();
        to |= more;
    }
    void add(ValueId v, const Parts &more) {
        add(demand.ofValue[v], more & possible_[active_.at(v)]);
    }
    const Parts &of(ValueId v) const { return demand.ofValue[v]; }

    void sweep(const Region &region) {
        for (auto i = region.body.rbegin(); i != region.body.rend(); ++i)
            sweep(*i);
    }
    void sweep(const Instruction &i) {
        switch (i.op) {
        case Op::If:
            for (const Region &region : i.regions) {
                for (size_t k = 0; k < i.results.size(); ++k)
                    add(region.yields[k], of(i.results[k]));
                sweep(region);
            }
            return;
        case Op::Loop:
        case Op::LightLoop: return sweepLoop(i);
        case Op::ArrayStore: return add(i.operands[1], demand.ofArray[size_t(i.immediate)]);
        case Op::ArrayLoad: return add(demand.ofArray[size_t(i.immediate)], of(i.results[0]));
        case Op::Slope: return sweepSlope(i);
        default: sweepPlain(i);
        }
    }
    void sweepPlain(const Instruction &i) {
        Parts all;
        for (ValueId v : i.results)
            all |= of(v);
        if (all.any())
            for (ValueId v : differentiableOperands(function_, i))
                add(v, all);
    }
    void sweepSlope(const Instruction &i) {
        const auto direction = Direction(i.immediate);
        if (!(active_.at(i, 0) & bit(direction)))
            return;
        Parts raised;
        raised.set(size_t(partOf(Order{}.raised(direction))));
        for (int part = 1; part < partCount; ++part)
            if (of(i.results[0])[size_t(part)]) {
                const Order order = orderOf(part).raised(direction);
                if (order.total() > highestOrder) {
                    demand.report.fault = noteAt(i, "derivatives of derivatives go beyond order " +
                                                        std::to_string(highestOrder) + " here");
                    return;
                }
                raised.set(size_t(partOf(order)));
            }
        raised = closed(raised);
        raised.reset(0);
        add(i.operands[0], raised);
    }
    void sweepLoop(const Instruction &i) {
        for (size_t k = 0; k < i.results.size(); ++k) {
            const ValueId argument = argumentOf(i, k);
            add(argument, of(i.results[k]));
            add(i.regions[0].yields[k], of(argument));
            add(initialOf(i, k), of(argument));
        }
        sweep(i.regions[0]);
    }

    /// Says what the demanded derivatives rest on.
    void note(const Region &region) {
        forEachInstruction(region, [&](const Instruction &i) {
            for (size_t k = 0; k < i.results.size(); ++k)
                if (of(i.results[k]).any())
                    note(i, k);
            for (size_t k = 0; i.op == Op::LightLoop && k < givenArguments(i); ++k)
                if (of(i.regions[0].arguments[k]).any())
                    hold(i, slopeNote(function_, i));
        });
    }
    void note(const Instruction &i, size_t result) {
        const Parts &wanted = of(i.results[result]);
        const SlopeKind kind = slopeKind(function_, i);
        if (kind == SlopeKind::Refused || reaches(wanted, firstRefusedOrder(i, result)))
            demand.report.fault = noteAt(i, slopeNote(function_, i));
        else if (kind == SlopeKind::Held || reaches(wanted, firstHeldOrder(i)))
            hold(i, slopeNote(function_, i));
    }
    static bool reaches(const Parts &parts, int order) {
        for (int part = partOf({order, 0}); part < partCount; ++part)
            if (parts[size_t(part)])
                return true;
        return false;
    }
    void hold(const Instruction &i, const std::string &text) {
        auto &held = demand.report.held;
        if (std::ranges::none_of(held, [&](const SlopeNote &n) { return n.text == text; }))
            held.push_back(noteAt(i, text));
    }

    const Function &function_;
    Activity active_;
    std::array<Parts, everyDirection + 1> possible_;
    bool changed_ = false;
};

} // namespace

JetDemand jetDemand(const Function &function) { return Demand(function).demand; }

} // namespace candela::ir

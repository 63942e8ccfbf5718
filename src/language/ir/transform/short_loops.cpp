// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/short_loops.h"

#include <cmath>
#include <optional>
#include <vector>

namespace candela::ir {

namespace {

constexpr double mostShortTurns = 256; ///< Of a loop in which and around which all are short.

class ShortLoops {
public:
    explicit ShortLoops(Function &function) : function_(function) {}

    void run() {
        define(function_.body);
        mark(function_.body, 1);
    }

private:
    void define(const Region &region) {
        definition_.resize(function_.values.size());
        for (const Instruction &i : region.body) {
            for (ValueId v : i.results)
                definition_[v] = &i;
            for (const Region &inner : i.regions)
                define(inner);
        }
    }

    std::optional<double> number(ValueId v) const {
        const Instruction *i = definition_[v];
        const bool moderate = i && i->op == Op::ConstFloat && std::fabs(i->number) <= 1 << 16;
        return moderate ? std::optional<double>(i->number) : std::nullopt;
    }

    /// `turns` is how often the region may run.
    void mark(Region &region, double turns) {
        for (Instruction &i : region.body) {
            double inner = turns;
            if (i.op == Op::Loop) {
                const auto own = mostTurns(i, i.regions[0].yields[0]);
                i.immediate = own && *own * turns <= mostShortTurns;
                inner = i.immediate ? *own * turns : 1;
            }
            for (Region &content : i.regions)
                mark(content, inner);
        }
    }

    /// Of a loop that goes on only where the condition holds.
    std::optional<double> mostTurns(const Instruction &loop, ValueId condition) const {
        const Instruction *i = definition_[condition];
        if (!i)
            return {};
        if (i->op == Op::And) {
            const auto left = mostTurns(loop, i->operands[0]);
            return left ? left : mostTurns(loop, i->operands[1]);
        }
        if (i->op != Op::Less && i->op != Op::LessEqual)
            return {};
        if (const auto upwards = turnsTo(loop, i->operands[0], i->operands[1], 1))
            return upwards;
        return turnsTo(loop, i->operands[1], i->operands[0], -1);
    }

    /// Turns until the carried value `counter`, by constant steps in that direction, has passed the
    /// bound. Steps below 2^-6 might vanish in rounding; with larger ones the counter runs at half
    /// its speed or more.
    std::optional<double> turnsTo(const Instruction &loop, ValueId counter, ValueId bound,
                                  double direction) const {
        const Region &region = loop.regions[0];
        const Instruction *sum = definition_[counter];
        if (!sum || sum->op != Op::Add)
            return {};
        for (std::size_t k = 1; k < region.yields.size(); ++k) {
            if (region.yields[k] != counter)
                continue;
            for (int side = 0; side < 2; ++side) {
                const auto from = number(loop.operands[k]), to = number(bound);
                const auto step = number(sum->operands[1 - side]);
                if (sum->operands[side] == region.arguments[k] && from && to && step &&
                    direction * *step >= 1.0 / 64)
                    return std::max(0.0, 2 * (*to - *from) / *step) + 2;
            }
        }
        return {};
    }

    Function &function_;
    std::vector<const Instruction *> definition_;
};

} // namespace

void markShortLoops(Function &function) { ShortLoops(function).run(); }

} // namespace candela::ir

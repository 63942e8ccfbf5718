// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/idioms.h"

#include "language/ir/core/regions.h"

namespace candela::ir {

Idioms::Idioms(const Function &function) : definitions_(function.values.size()) {
    forEachInstruction(function.body, [&](const Instruction &i) {
        for (ValueId v : i.results)
            definitions_[v] = &i;
    });
}

const Instruction *Idioms::definition(ValueId v, Op op) const {
    const Instruction *i = definitions_[v];
    return i && i->op == op ? i : nullptr;
}

bool Idioms::isNumber(ValueId v, float x) const {
    const Instruction *i = definition(v, Op::ConstFloat);
    return i && i->number == x;
}

std::optional<Idioms::Scaled> Idioms::scaledBy(ValueId reciprocal) const {
    const Instruction *division = definition(reciprocal, Op::Div);
    const Instruction *divisor = division && isNumber(division->operands[0], 1)
                                     ? definition(division->operands[1], Op::Select)
                                     : nullptr;
    const Instruction *length = divisor ? definition(divisor->operands[2], Op::Sqrt) : nullptr;
    const Instruction *sum = length ? definition(length->operands[0], Op::Add) : nullptr;
    const Instruction *two = sum ? definition(sum->operands[0], Op::Add) : nullptr;
    if (!two || !isNumber(divisor->operands[1], 1))
        return std::nullopt;
    Scaled scaled{{}, length->results[0]};
    const ValueId squares[] = {two->operands[0], two->operands[1], sum->operands[1]};
    for (std::size_t k = 0; k < 3; ++k) {
        const Instruction *square = definition(squares[k], Op::Mul);
        if (!square || square->operands[0] != square->operands[1])
            return std::nullopt;
        scaled.vector[k] = square->operands[0];
    }
    return scaled;
}

std::optional<Idioms::Mix> Idioms::mixOf(const Instruction &sum) const {
    // As one of the factors is the other summand's, less 1; a factor 1 is not written.
    const auto factorsOf = [&](ValueId v) {
        std::vector<std::array<std::optional<ValueId>, 2>> pairs{{std::nullopt, v}};
        if (const Instruction *product = definition(v, Op::Mul)) {
            pairs.push_back({product->operands[0], product->operands[1]});
            pairs.push_back({product->operands[1], product->operands[0]});
        }
        return pairs;
    };
    for (std::size_t k : {0u, 1u})
        for (const auto &[from, rest] : factorsOf(sum.operands[k]))
            for (const auto &[to, share] : factorsOf(sum.operands[1 - k]))
                if (const Instruction *less = definition(*rest, Op::Sub);
                    less && isNumber(less->operands[0], 1) && less->operands[1] == *share)
                    return Mix{from, to, *share};
    return std::nullopt;
}

std::optional<std::array<std::array<ValueId, 3>, 2>> Idioms::dotOf(const Instruction &sum) const {
    const Instruction *two = definition(sum.operands[0], Op::Add);
    if (!two)
        return std::nullopt;
    std::array<std::array<ValueId, 3>, 2> vectors;
    const ValueId products[] = {two->operands[0], two->operands[1], sum.operands[1]};
    for (std::size_t k = 0; k < 3; ++k) {
        const Instruction *product = definition(products[k], Op::Mul);
        if (!product)
            return std::nullopt;
        vectors[0][k] = product->operands[0], vectors[1][k] = product->operands[1];
    }
    return vectors;
}

std::optional<ValueId> Idioms::summandBeside(ValueId sum, ValueId one) const {
    if (const Instruction *whole = definition(sum, Op::Add))
        for (std::size_t k : {0u, 1u})
            if (whole->operands[k] == one)
                return whole->operands[1 - k];
    return std::nullopt;
}

std::optional<ValueId> Idioms::smoothStepOf(const Instruction &i) const {
    const Instruction *below = definition(i.operands[0], Op::Less);
    const Instruction *upper = definition(i.operands[2], Op::Select);
    if (!below || !upper || !isNumber(i.operands[1], 0) || !isNumber(upper->operands[1], 1))
        return std::nullopt;
    const Instruction *above = definition(upper->operands[0], Op::LessEqual);
    const Instruction *cubic = definition(upper->operands[2], Op::Mul);
    const Instruction *square = cubic ? definition(cubic->operands[0], Op::Mul) : nullptr;
    const Instruction *line = cubic ? definition(cubic->operands[1], Op::Sub) : nullptr;
    const Instruction *twice = line ? definition(line->operands[1], Op::Mul) : nullptr;
    if (!above || !square || !twice || square->operands[0] != square->operands[1] ||
        !isNumber(line->operands[0], 3) || !isNumber(twice->operands[0], 2) ||
        twice->operands[1] != square->operands[0])
        return std::nullopt;
    const ValueId x = below->operands[0], low = below->operands[1], high = above->operands[0];
    const ValueId t = square->operands[0];
    // (x - low) / (high - low), as far as constants leave it there.
    const Instruction *ratio = definition(t, Op::Div);
    const ValueId from = ratio ? ratio->operands[0] : t;
    const Instruction *moved = definition(from, Op::Sub);
    const bool isFrom = (from == x && isNumber(low, 0)) ||
                        (moved && moved->operands[0] == x && moved->operands[1] == low);
    const Instruction *least = definition(low, Op::ConstFloat);
    const Instruction *most = definition(high, Op::ConstFloat);
    const Instruction *span = ratio ? definition(ratio->operands[1], Op::Sub) : nullptr;
    const bool isRatio =
        least && most ? most->number > least->number &&
                            (ratio ? isNumber(ratio->operands[1], most->number - least->number)
                                   : most->number - least->number == 1)
                      : (span && span->operands[0] == high && span->operands[1] == low) ||
                            (isNumber(low, 0) && ratio && ratio->operands[1] == high);
    return isFrom && isRatio && above->operands[1] == x ? std::optional(t) : std::nullopt;
}

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
#include "language/ir/filter/counted_loop.h"

namespace candela::ir {

namespace {

bool isOne(const ValueFacts &facts, ValueId v) {
    const float *number = facts.number(v);
    return number && *number == 1;
}

/// variable + 1.
bool isNext(const ValueFacts &facts, ValueId next, ValueId variable) {
    const Instruction *made = facts.definition(next);
    if (!made || made->op != Op::Add)
        return false;
    const ValueId a = made->operands[0], b = made->operands[1];
    return (a == variable && isOne(facts, b)) || (b == variable && isOne(facts, a));
}

/// Made before the loop begins.
bool isOutside(const ValueFacts &facts, ValueId v, const Instruction &loop, int depthOfBody) {
    const ValueFacts::Origin &origin = facts.origin[v];
    return origin.depth < depthOfBody && origin.instruction != &loop;
}

bool isTest(const ValueFacts &facts, ValueId v, Op op, ValueId variable, ValueId end) {
    const Instruction *made = facts.definition(v);
    return made && made->op == op && made->operands[0] == variable && made->operands[1] == end;
}

bool isTrue(const ValueFacts &facts, ValueId v) {
    const Instruction *made = facts.definition(v);
    return made && made->op == Op::ConstBool && made->immediate != 0;
}

} // namespace

std::optional<CountedLoop> countedLoop(const Instruction &loop, const ValueFacts &facts) {
    if (loop.op != Op::Loop)
        return {};
    const Region &body = loop.regions[0];
    const int depth = facts.origin[body.arguments[0]].depth;
    const Instruction *test = facts.definition(body.yields[0]);
    if (!test || (test->op != Op::Less && test->op != Op::LessEqual))
        return {};
    const ValueId next = test->operands[0], end = test->operands[1];
    for (std::size_t k = 1; k < body.arguments.size(); ++k) {
        const ValueId first = loop.operands[k];
        const bool begins = isTrue(facts, loop.operands[0]) ||
                            isTest(facts, loop.operands[0], test->op, first, end);
        if (body.yields[k] == next && isNext(facts, next, body.arguments[k]) && begins &&
            isOutside(facts, end, loop, depth))
            return CountedLoop{&loop, k, first, end, test->op == Op::LessEqual};
    }
    return {};
}

} // namespace candela::ir

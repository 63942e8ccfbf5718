// SPDX-License-Identifier: Apache-2.0
// Unrolling of loops whose count is known.
#include "language/ir/builder_sources.h"
#include "language/ir/specializer.h"
#include "language/ir/trip_count.h"

namespace candela::ir {

namespace {

constexpr int mostTurns = 64, smallUnrolled = 128;
constexpr std::size_t mostRequests = 256; ///< Of a text; nested loops would multiply without end.

struct Size {
    int instructions = 0;
    bool asksForLight = false;
};

Size sizeOf(const Region &region) {
    Size size;
    for (const Instruction &i : region.body) {
        ++size.instructions;
        size.asksForLight |= i.op == Op::LightLoop || i.op == Op::Answer;
        for (const Region &inner : i.regions) {
            Size more = sizeOf(inner);
            size.instructions += more.instructions;
            size.asksForLight |= more.asksForLight;
        }
    }
    return size;
}

} // namespace

bool Specializer::unrollLoop(const Instruction &i, Range range) {
    std::map<ValueId, Known> known;
    auto note = [&](ValueId old) {
        ValueId now = maps_[active_[0]][old];
        if (now == ValueId(-1))
            return;
        if (const float *x = constantFloat(b_, now))
            known[old] = *x;
        if (auto truth = constantBool(b_, now))
            known[old] = *truth ? 1.0f : 0.0f;
    };
    for (ValueId old = 0; old < ValueId(text_.values.size()); ++old)
        note(old);
    auto turns = tripCount(i, known, mostTurns);
    Size size = sizeOf(i.regions[0]);
    bool worthwhile = size.asksForLight ? b_.function().requests.size() < mostRequests
                                        : turns && *turns * size.instructions <= smallUnrolled;
    if (!turns || !worthwhile)
        return false;
    for (int h : active_) {
        Values carried = valuesOf(h, i.operands);
        auto all = active_;
        active_ = {h};
        for (int turn = 0; turn < *turns; ++turn) {
            for (std::size_t k = 0; k < carried.size(); ++k)
                assign(h, i.regions[0].arguments[k], carried[k]);
            walk(i.regions[0], range);
            carried = valuesOf(h, i.regions[0].yields);
        }
        active_ = all;
        for (std::size_t k = 0; k < carried.size(); ++k)
            assign(h, i.results[k], carried[k]);
    }
    return true;
}

} // namespace candela::ir

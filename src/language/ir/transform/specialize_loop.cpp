// SPDX-License-Identifier: Apache-2.0
// Loops: written as they are, or unrolled where their count is known.
#include "language/ir/analyse/dependence.h"
#include "language/ir/analyse/trip_count.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/specialization.h"

#include <algorithm>

namespace candela::ir {

namespace {

constexpr int mostTurns = 64;
constexpr std::size_t smallUnrolled = 128;
constexpr std::size_t mostRequests = 256; ///< Of a text; nested loops would multiply without end.

struct Size {
    int instructions = 0;
    bool asksForLight = false;
};

Size sizeOf(const Region &region) {
    Size size;
    constexpr int codeOfLookup = 16; ///< It may be in a row, or anywhere.
    for (const Instruction &i : region.body) {
        size.instructions += i.op == Op::ImageLoad ? codeOfLookup : 1;
        size.asksForLight |= i.op == Op::LightLoop || i.op == Op::Answer;
        for (const Region &inner : i.regions) {
            Size more = sizeOf(inner);
            size.instructions += more.instructions;
            size.asksForLight |= more.asksForLight;
        }
    }
    return size;
}

bool unrollLoop(Specialization &s, const Instruction &i, BindingTimes range) {
    std::map<ValueId, Known> known;
    for (ValueId old = 0; old < ValueId(s.text.values.size()); ++old)
        if (auto now = s.mapping.known(s.active[0], old)) {
            if (const float *x = constantFloat(s.b, *now))
                known[old] = *x;
            if (auto truth = constantBool(s.b, *now))
                known[old] = *truth ? 1.0f : 0.0f;
        }
    auto turns = tripCount(i, known, mostTurns);
    Size size = sizeOf(i.regions[0]);
    if (!turns)
        return false;
    std::size_t unrolled = std::size_t(*turns) * std::size_t(size.instructions);
    bool worthwhile = size.asksForLight ? s.b.function().requests.size() < mostRequests
                                        : unrolled <= smallUnrolled;
    if (!worthwhile || unrolled > s.b.budget().left() / 2)
        return false;
    for (int h : s.active) {
        Values carried = s.mapping.values(h, i.operands);
        s.under({h}, [&] {
            for (int turn = 0; turn < *turns; ++turn) {
                for (std::size_t k = 0; k < carried.size(); ++k)
                    s.mapping.assign(h, i.regions[0].arguments[k], carried[k]);
                walk(s, i.regions[0], range);
                carried = s.mapping.values(h, i.regions[0].yields);
            }
        });
        for (std::size_t k = 0; k < carried.size(); ++k)
            s.mapping.assign(h, i.results[k], carried[k]);
    }
    return true;
}

bool storesIn(const Specialization &s, const Region &region, BindingTimes range) {
    for (const Instruction &i : region.body) {
        if (i.op == Op::ArrayStore &&
            range.has(s.counted(s.dependence.arrayBindingTime[i.immediate])))
            return true;
        for (const Region &inner : i.regions)
            if (storesIn(s, inner, range))
                return true;
    }
    return false;
}

/// Whether something in the loop is said now.
bool speaksIn(const Specialization &s, const Region &region) {
    return s.options.prints && s.ahead == 0 &&
           anyInstruction(region, [](const Instruction &i) { return i.op == Op::Command; });
}

bool wantsLoop(const Specialization &s, const Instruction &i, BindingTimes range) {
    if (s.bindingTimeOf(i.regions[0].arguments[0]) > range.last)
        return false;
    if (s.loopDepth > 0 || !s.options.framed)
        return true;
    return storesIn(s, i.regions[0], range) || speaksIn(s, i.regions[0]) ||
           std::any_of(i.results.begin(), i.results.end(),
                       [&](ValueId v) { return range.has(s.bindingTimeOf(v)); });
}

/// Writes the whole loop, also what belongs to earlier binding times: it differs from turn to turn
/// and so cannot come from the frame.
void emitLoop(Specialization &s, const Instruction &i, BindingTimes range) {
    const Region &region = i.regions[0];
    std::vector<std::pair<int, int>> carried; // Assumption, which.
    Values initial;
    for (int k = 0; k < int(i.results.size()); ++k) {
        if (s.bindingTimeOf(i.results[k]) > range.last)
            continue;
        for (int h : s.active) {
            carried.push_back({h, k});
            initial.push_back(s.mapping.value(h, i.operands[k]));
            if (!s.dependence.responds(i.results[k]))
                break;
        }
    }
    auto spread = [&](const Values &old, const Values &now, bool onlyInRange) {
        for (std::size_t n = 0; n < carried.size(); ++n) {
            auto [h, k] = carried[n];
            if (onlyInRange && !range.has(s.bindingTimeOf(old[k])))
                continue;
            s.dependence.responds(old[k]) ? s.mapping.assign(h, old[k], now[n])
                                          : s.assignShared(old[k], now[n]);
        }
    };
    Values results = loop(s.b, initial, [&](const Values &arguments) {
        ++s.loopDepth;
        spread(region.arguments, arguments, false);
        walk(s, region, {BindingTime::Surface, range.last});
        Values yields;
        for (auto [h, k] : carried)
            yields.push_back(s.mapping.value(h, region.yields[k]));
        --s.loopDepth;
        return yields;
    });
    spread(i.results, results, s.loopDepth == 0);
}

} // namespace

void walkLoop(Specialization &s, const Instruction &i, BindingTimes range) {
    if (!wantsLoop(s, i, range) || (s.options.unrolls && unrollLoop(s, i, range)))
        return;
    if (!s.dependence.responds(i.regions[0].arguments[0]))
        return emitLoop(s, i, range);
    for (int h : s.active)
        s.under({h}, [&] { emitLoop(s, i, range); });
}

} // namespace candela::ir

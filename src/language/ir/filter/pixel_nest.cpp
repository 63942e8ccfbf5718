// SPDX-License-Identifier: Apache-2.0
#include "language/ir/filter/pixel_nest.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/filter/reduction.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace candela::ir {

std::vector<const Instruction *> PixelNest::before() const {
    std::vector<const Instruction *> all;
    if (isNested())
        for (const Instruction &i : outer->regions[0].body) {
            if (&i == inner)
                break;
            all.push_back(&i);
        }
    return all;
}

namespace {

/// A pixel that is looked up or set.
struct Access {
    const Instruction *instruction;
    const ImageUse *use;
    bool isUnconditional; ///< In every turn.
    ValueId x() const { return instruction->operands[0]; }
    ValueId y() const { return instruction->operands[1]; }
};

class NestProof {
public:
    /// Of one loop, or of `inner` in `outer`; the nest gets what is found.
    NestProof(const Function &function, const ValueFacts &facts, const CountedLoop &outer,
              const CountedLoop &inner, PixelNest &nest)
        : function_(function), facts_(facts), outer_(outer), inner_(inner), nest_(nest) {}

    bool holds() {
        return resultsAreKnown() && collect() && accessesAreApart() && arraysAreApart();
    }
    /// Which variable the map's columns follow in what is set, else in what is read.
    bool columnsAreInner() const;

private:
    enum class Follows { Nothing, Inner, Outer, Unknown };

    bool resultsAreKnown();
    bool collect();
    bool collect(const Region &, bool isUnconditional);
    bool collect(const Instruction &, bool isUnconditional);
    bool accessesAreApart();
    bool isApartAlong(std::size_t axis, const CountedLoop &, int map) const;
    bool isCovered(int map) const;
    bool isApart(int map) const;
    bool arraysAreApart();
    bool isVariant(ValueId v, int depth = 0) const;
    /// By steps of at least one pixel.
    Follows follows(ValueId v) const;
    bool beginsWhole(const CountedLoop &) const;

    const Function &function_;
    const ValueFacts &facts_;
    const CountedLoop &outer_, &inner_;
    PixelNest &nest_;
    std::vector<Access> accesses_;
    std::map<int, bool> arrays_; ///< Those that are accessed; true: set.
    mutable std::map<ValueId, bool> variant_;
};

/// Carried values are the counters, and what is reduced; what they are behind the loops nobody
/// asks, unless it is reduced.
bool NestProof::resultsAreKnown() {
    const auto unused = [&](const Instruction &loop, std::size_t k) {
        return facts_.uses[loop.results[k]] == 0;
    };
    const Instruction &outer = *nest_.outer;
    std::map<std::size_t, std::size_t> outerOf; // Of an inner reduction.
    if (nest_.isNested()) {
        if (!unused(outer, 0) || !unused(outer, outer_.counter))
            return false;
        for (std::size_t k = 1; k < outer.results.size(); ++k) {
            if (k == outer_.counter)
                continue;
            const ValueId carried = outer.regions[0].arguments[k],
                          next = outer.regions[0].yields[k];
            const ValueFacts::Origin &from = facts_.origin[next];
            const bool isInners = from.instruction == inner_.loop && !from.isArgument &&
                                  from.index > 0 && inner_.loop->operands[from.index] == carried;
            if (!isInners || facts_.uses[carried] != 1 || facts_.uses[next] != 1)
                return false;
            outerOf[from.index] = k;
        }
    }
    for (std::size_t k = 0; k < inner_.loop->results.size(); ++k) {
        if (k == 0 || k == inner_.counter) {
            if (!unused(*inner_.loop, k))
                return false;
            continue;
        }
        const auto way = outerOf.find(k);
        if (nest_.isNested() && way == outerOf.end())
            return false;
        const ValueId before = inner_.body().arguments[k], next = inner_.body().yields[k];
        const auto kind = reductionOf(facts_, before, next);
        if (!kind)
            return false;
        const std::size_t at = nest_.isNested() ? way->second : k;
        nest_.reductions.push_back({*kind, outer.operands[at], before, next, outer.results[at]});
    }
    return true;
}

bool NestProof::collect() {
    for (const Instruction *i : nest_.before())
        if (hasEffect(i->op) || !collect(*i, false))
            return false;
    if (!collect(nest_.inner->regions[0], true))
        return false;
    if (!nest_.isNested())
        return true;
    // Behind the inner loop nothing but the counting.
    bool isBehind = false;
    for (const Instruction &i : nest_.outer->regions[0].body) {
        if (isBehind && (!isPure(i.op) || !i.regions.empty()))
            return false;
        isBehind |= &i == nest_.inner;
    }
    return true;
}

bool NestProof::collect(const Region &region, bool isUnconditional) {
    return std::ranges::all_of(region.body,
                               [&](const Instruction &i) { return collect(i, isUnconditional); });
}

bool NestProof::collect(const Instruction &i, bool isUnconditional) {
    switch (i.op) {
    case Op::ImageLoad:
    case Op::ImageStore:
        accesses_.push_back({&i, &function_.images[std::size_t(i.immediate)], isUnconditional});
        return true;
    case Op::ArrayLoad: arrays_.try_emplace(i.immediate, false); return true;
    case Op::ArrayStore: arrays_[i.immediate] = true; return true;
    case Op::If:
    case Op::Loop:
        return std::ranges::all_of(i.regions,
                                   [&](const Region &inner) { return collect(inner, false); });
    default: return isPure(i.op) && info(i.op).kind != OpClass::Random;
    }
}

bool NestProof::isVariant(ValueId v, int depth) const {
    constexpr int deepest = 2000; // Beyond it nothing is known, before the stack ends.
    const auto [known, isNew] = variant_.try_emplace(v, true);
    if (!isNew)
        return known->second;
    const ValueFacts::Origin &origin = facts_.origin[v];
    const int body = facts_.origin[nest_.outer->regions[0].arguments[0]].depth;
    bool is = true;
    if (origin.depth < body || !origin.instruction || isConstant(origin.instruction->op))
        is = false;
    else if (!origin.isArgument && isPure(origin.instruction->op) &&
             origin.instruction->regions.empty() && depth < deepest)
        is = std::ranges::any_of(origin.instruction->operands,
                                 [&](ValueId operand) { return isVariant(operand, depth + 1); });
    return variant_[v] = is;
}

NestProof::Follows NestProof::follows(ValueId v) const {
    if (v == inner_.variable())
        return Follows::Inner;
    if (nest_.isNested() && v == outer_.variable())
        return Follows::Outer;
    if (!isVariant(v))
        return Follows::Nothing;
    const Instruction *made = facts_.definition(v);
    if (!made)
        return Follows::Unknown;
    if (made->op == Op::Neg)
        return follows(made->operands[0]);
    if (made->op != Op::Add && made->op != Op::Sub && made->op != Op::Mul)
        return Follows::Unknown;
    const ValueId a = made->operands[0], b = made->operands[1];
    const ValueId still = isVariant(a) ? b : a, moves = isVariant(a) ? a : b;
    if (isVariant(still))
        return Follows::Unknown;
    if (made->op == Op::Mul) {
        const float *step = facts_.number(still);
        if (!step || !(std::abs(*step) >= 1))
            return Follows::Unknown;
    }
    return follows(moves);
}

bool NestProof::beginsWhole(const CountedLoop &loop) const {
    const float *first = facts_.number(loop.first);
    return first && std::floor(*first) == *first;
}

/// What is set lies, along the axis (operand 0 or 1), where the loop's variable is, and so does
/// what is read of the map: no two turns of the loop meet.
bool NestProof::isApartAlong(std::size_t axis, const CountedLoop &loop, int map) const {
    std::optional<ValueId> place;
    bool isRead = false;
    for (const Access &access : accesses_) {
        if (access.use->map != map)
            continue;
        const ValueId own = access.instruction->operands[axis];
        if (own != place.value_or(own))
            return false;
        place = own;
        isRead |= access.instruction->op == Op::ImageLoad;
        if (access.use->filter > runtime::ImageFilter::Bilinear)
            return false;
    }
    // Between two pixels both would be read.
    const bool isPixel = place == loop.variable() && beginsWhole(loop);
    const Follows wanted = loop.loop == nest_.inner ? Follows::Inner : Follows::Outer;
    return place && follows(*place) == wanted && (!isRead || isPixel);
}

/// Every turn sets its pixel, and none reads one.
bool NestProof::isCovered(int map) const {
    if (!nest_.isNested())
        return false;
    bool isSet = false;
    for (const Access &access : accesses_) {
        if (access.use->map != map)
            continue;
        if (access.instruction->op == Op::ImageLoad)
            return false;
        const std::set<ValueId> place{access.x(), access.y()};
        isSet |= access.isUnconditional && beginsWhole(inner_) && beginsWhole(outer_) &&
                 place == std::set<ValueId>{inner_.variable(), outer_.variable()};
    }
    return isSet;
}

/// What one turn sets no other turn sets or reads.
bool NestProof::isApart(int map) const {
    if (!nest_.isNested())
        return isApartAlong(0, inner_, map) || isApartAlong(1, inner_, map);
    return (isApartAlong(0, inner_, map) && isApartAlong(1, outer_, map)) ||
           (isApartAlong(1, inner_, map) && isApartAlong(0, outer_, map));
}

bool NestProof::accessesAreApart() {
    std::set<int> read, readAround, set;
    for (const Access &access : accesses_) {
        const ValueId x = access.x();
        const bool isOwnColumn =
            x == inner_.variable() || (nest_.isNested() && x == outer_.variable());
        if (access.instruction->op == Op::ImageLoad && !isOwnColumn)
            readAround.insert(access.use->map);
        (access.instruction->op == Op::ImageStore ? set : read).insert(access.use->map);
    }
    if (set.empty() && read.empty())
        return false; // No loop over pixels.
    nest_.mapsRead.assign(read.begin(), read.end());
    nest_.mapsReadAround.assign(readAround.begin(), readAround.end());
    nest_.mapsSet.assign(set.begin(), set.end());
    for (const int map : set)
        if (isCovered(map))
            nest_.mapsCovered.push_back(map);
    return std::ranges::all_of(set, [&](int map) { return isApart(map); });
}

/// Loads and stores of the array in the region.
static int accessesIn(const Region &region, int array) {
    int count = 0;
    forEachInstruction(region, [&](const Instruction &i) {
        count += isArrayAccess(i.op) && i.immediate == array;
    });
    return count;
}

/// An array is the turn's own, or only read.
bool NestProof::arraysAreApart() {
    const int depth = facts_.origin[nest_.inner->regions[0].arguments[0]].depth;
    for (const auto &[array, isSet] : arrays_) {
        if (!isSet) {
            nest_.arrays.push_back(array);
            continue;
        }
        const bool isUsedElsewhere =
            accessesIn(nest_.outer->regions[0], array) != accessesIn(function_.body, array);
        if (isUsedElsewhere || function_.arrays[std::size_t(array)].loopDepth < depth)
            return false;
    }
    return std::ranges::all_of(nest_.arrays, [&](int array) {
        return function_.arrays[std::size_t(array)].type == Type::Float;
    });
}

bool NestProof::columnsAreInner() const {
    if (!nest_.isNested())
        return true;
    for (const Op op : {Op::ImageStore, Op::ImageLoad})
        for (const Access &access : accesses_)
            if (access.instruction->op == op)
                switch (follows(access.x())) {
                case Follows::Inner: return true;
                case Follows::Outer: return false;
                default: break;
                }
    return true;
}

/// The loop and what it holds as one nest; `inner` may be the loop itself.
std::optional<PixelNest> provenNest(const Function &function, const ValueFacts &facts,
                                    const CountedLoop &outer, const CountedLoop &inner) {
    PixelNest nest;
    nest.outer = outer.loop;
    nest.inner = inner.loop;
    NestProof proof(function, facts, outer, inner, nest);
    if (!proof.holds())
        return {};
    const bool isInner = proof.columnsAreInner();
    nest.columns = isInner ? inner : outer;
    if (nest.isNested())
        nest.rows = isInner ? outer : inner;
    return nest;
}

/// The one loop that stands directly in the other, if its bounds do not change there.
std::optional<CountedLoop> loopWithin(const CountedLoop &outer, const ValueFacts &facts) {
    const Instruction *found = nullptr;
    for (const Instruction &i : outer.body().body)
        if (i.op == Op::Loop) {
            if (found)
                return {};
            found = &i;
        }
    const auto inner = found ? countedLoop(*found, facts) : std::nullopt;
    const int depth = facts.origin[outer.body().arguments[0]].depth;
    const auto isOutside = [&](ValueId v) { return facts.origin[v].depth < depth; };
    if (!inner || !isOutside(inner->first) || !isOutside(inner->end))
        return {};
    return inner;
}

} // namespace

std::optional<PixelNest> pixelNest(const Function &function, const ValueFacts &facts,
                                   const Instruction &loop) {
    const auto outer = countedLoop(loop, facts);
    if (!outer)
        return {};
    if (const auto inner = loopWithin(*outer, facts))
        if (auto nest = provenNest(function, facts, *outer, *inner))
            return nest;
    return provenNest(function, facts, *outer, *outer);
}

} // namespace candela::ir

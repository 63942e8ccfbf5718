// SPDX-License-Identifier: Apache-2.0
#include "language/jit/function_pieces.h"

#include "language/ir/core/op_info.h"

#include <algorithm>
#include <functional>
#include <queue>
#include <set>
#include <utility>

namespace candela {

using ir::Instruction;
using ir::Op;
using ir::Region;
using ir::ValueId;

bool isLoadedAtHead(Op op) {
    return op == Op::Parameter || op == Op::Object || op == Op::ObjectInverse;
}

namespace {

/// What a call of a piece adds to the code that it is called from.
constexpr int callWeight = 8;

/// About how much code an instruction becomes, in additions, without its regions.
int ownWeight(const Instruction &i) {
    if (ir::isConstant(i.op))
        return 0;
    switch (i.op) {
    case Op::LightLoop: return 120 + int(i.results.size());
    case Op::If: return 4 + int(i.results.size());
    case Op::Loop: return (i.immediate ? 4 : 24) + int(i.results.size()); // Counts its turns.
    case Op::Call: return 4 + int(i.operands.size() + i.results.size());
    case Op::Query:
    case Op::Command: return 20 + int(i.operands.size() + i.results.size());
    case Op::ImageLoad: return 30 + 4 * int(i.results.size()); // In a row, or anywhere.
    case Op::ImageStore: return 30 + 8 * int(i.operands.size());
    case Op::Output:
    case Op::FrameStore: return 4;
    default: return ir::info(i.op).kind == ir::OpClass::Transcendental ? 4 : 1;
    }
}

/// Finds the cuts, innermost regions first.
class Cutter {
public:
    Cutter(int longest, FunctionPieces &pieces) : longest_(longest), pieces_(pieces) {}

    /// The weight of the region's code where its owner stands.
    int region(const Region &);

private:
    int weight(const Instruction &i) {
        int sum = ir::isArrayAccess(i.op) ? weightOfAccess(i) : ownWeight(i);
        if (i.op == Op::ConstInteger)
            known_.insert(i.results[0]);
        for (const Region &inner : i.regions)
            sum += region(inner);
        return sum;
    }
    /// A computed index is looked at, and each lane has its own.
    int weightOfAccess(const Instruction &i) const {
        return known_.contains(i.operands[0]) ? 4 : 24;
    }
    std::vector<Piece> piecesOf(const Region &, const std::vector<int> &weights) const;

    std::set<ValueId> known_; ///< Constant indices.
    int longest_;
    FunctionPieces &pieces_;
};

int Cutter::region(const Region &region) {
    std::vector<int> weights;
    int sum = 0;
    for (const Instruction &i : region.body) {
        weights.push_back(weight(i));
        sum += weights.back();
    }
    if (sum <= longest_)
        return sum;
    std::vector<Piece> pieces = piecesOf(region, weights);
    const int calls = callWeight * int(pieces.size());
    pieces_.cut.emplace(&region, std::move(pieces));
    return calls;
}

void eachUse(const Instruction &i, const std::function<void(ValueId)> &use) {
    for (ValueId operand : i.operands)
        use(operand);
    for (const Region &inner : i.regions) {
        for (const Instruction &nested : inner.body)
            eachUse(nested, use);
        for (ValueId yield : inner.yields)
            use(yield);
    }
}

/// How many of the region's own values are alive before each of its instructions.
std::vector<int> aliveBefore(const Region &region) {
    std::map<ValueId, std::pair<std::size_t, std::size_t>> lives; // Made at, last used at.
    for (std::size_t at = 0; at < region.body.size(); ++at) {
        const Instruction &i = region.body[at];
        eachUse(i, [&](ValueId v) {
            if (auto life = lives.find(v); life != lives.end())
                life->second.second = at;
        });
        if (!ir::isConstant(i.op) && !isLoadedAtHead(i.op))
            for (ValueId v : i.results)
                lives[v] = {at, at};
    }
    for (ValueId v : region.yields)
        if (auto life = lives.find(v); life != lives.end())
            life->second.second = region.body.size();
    std::vector<int> change(region.body.size() + 2);
    for (const auto &[v, life] : lives)
        if (life.second > life.first) {
            ++change[life.first + 1];
            --change[life.second + 1];
        }
    std::vector<int> alive(region.body.size() + 1);
    for (std::size_t at = 0, now = 0; at < alive.size(); ++at)
        alive[at] = int(now += std::size_t(change[at]));
    return alive;
}

std::vector<Piece> Cutter::piecesOf(const Region &region, const std::vector<int> &weights) const {
    const std::vector<int> alive = aliveBefore(region);
    std::vector<Piece> pieces;
    std::size_t begin = 0;
    while (begin < weights.size()) {
        std::size_t end = begin;
        std::size_t best = 0;
        int sum = 0;
        // Among the places where the piece is long enough, the one with the fewest values.
        while (end < weights.size() && (end == begin || sum + weights[end] <= longest_)) {
            sum += weights[end++];
            if (2 * sum >= longest_ && (best == 0 || alive[end] <= alive[best]))
                best = end;
        }
        if (end == weights.size() || best == 0)
            best = end;
        pieces.push_back({begin, best});
        begin = best;
    }
    return pieces;
}

/// Gives slots to the values that are used in another function than the one that makes them. A
/// slot serves values whose lives do not meet.
class SlotPlanner {
public:
    SlotPlanner(const ir::Function &function, FunctionPieces &pieces)
        : pieces_(pieces), lives_(function.values.size()) {}

    void plan(const Region &body) {
        pieces_.slots = int(pieces_.parametersInMemory.size());
        pieces_.slot.assign(lives_.size(), -1);
        head(body);
        region(body, 0);
        assign();
    }

private:
    struct Life {
        int home = 0; ///< The machine function that makes it; 0 is the entry.
        int from = 0, to = 0;
        bool isEverywhere = false, crosses = false;
    };
    struct RunningLoop {
        int from = 0;
        std::vector<ValueId> used; ///< Values from before the loop: alive until it ends.
    };

    /// What is loaded at the head of a block is made in the entry.
    void head(const Region &);
    void region(const Region &, int home);
    void instruction(const Instruction &, int home);
    void make(ValueId v, int home, bool isEverywhere = false) {
        lives_[v] = {home, now_, now_, isEverywhere, false};
    }
    int slotOfParameter(const Instruction &) const;
    void use(ValueId, int home);
    void assign();

    FunctionPieces &pieces_;
    std::vector<Life> lives_;
    std::vector<RunningLoop> loops_;
    int now_ = 0, functions_ = 1;
};

void SlotPlanner::head(const Region &region) {
    for (const Instruction &i : region.body) {
        const int slot = slotOfParameter(i);
        if (isLoadedAtHead(i.op))
            for (ValueId v : i.results) {
                make(v, 0, slot >= 0);
                pieces_.slot[v] = slot;
            }
        for (const Region &inner : i.regions)
            head(inner);
    }
}

int SlotPlanner::slotOfParameter(const Instruction &i) const {
    const std::vector<int> &all = pieces_.parametersInMemory;
    if (i.op != Op::Parameter || all.empty())
        return -1;
    return int(std::lower_bound(all.begin(), all.end(), i.immediate) - all.begin());
}

void SlotPlanner::use(ValueId v, int home) {
    Life &life = lives_[v];
    if (life.isEverywhere)
        return;
    life.crosses |= life.home != home;
    life.to = std::max(life.to, now_);
    for (RunningLoop &loop : loops_)
        if (loop.from > life.from) {
            loop.used.push_back(v);
            return;
        }
}

void SlotPlanner::region(const Region &region, int home) {
    const auto cut = pieces_.cut.find(&region);
    if (cut == pieces_.cut.end()) {
        for (const Instruction &i : region.body)
            instruction(i, home);
    } else {
        for (const Piece &piece : cut->second) {
            const int own = functions_++;
            for (std::size_t at = piece.begin; at < piece.end; ++at)
                instruction(region.body[at], own);
        }
    }
    ++now_;
    for (ValueId v : region.yields)
        use(v, home);
}

void SlotPlanner::instruction(const Instruction &i, int home) {
    ++now_;
    for (ValueId v : i.operands)
        use(v, home);
    if (isLoadedAtHead(i.op))
        return;
    for (ValueId v : i.results)
        make(v, home, ir::isConstant(i.op));
    const bool repeats = i.op == Op::Loop || i.op == Op::LightLoop;
    if (repeats) {
        loops_.push_back({++now_, {}});
        for (ValueId v : i.regions[0].arguments)
            make(v, home);
    }
    for (const Region &inner : i.regions)
        region(inner, home);
    if (repeats) {
        ++now_;
        for (ValueId v : loops_.back().used)
            lives_[v].to = now_;
        for (ValueId v : i.regions[0].arguments)
            lives_[v].to = now_;
        loops_.pop_back();
    }
}

void SlotPlanner::assign() {
    std::vector<ValueId> order;
    for (ValueId v = 0; v < lives_.size(); ++v)
        if (lives_[v].crosses)
            order.push_back(v);
    std::stable_sort(order.begin(), order.end(),
                     [&](ValueId a, ValueId b) { return lives_[a].from < lives_[b].from; });
    using Ending = std::pair<int, int>; // When, which slot.
    std::priority_queue<Ending, std::vector<Ending>, std::greater<>> taken;
    for (ValueId v : order) {
        int slot = pieces_.slots;
        if (!taken.empty() && taken.top().first < lives_[v].from) {
            slot = taken.top().second;
            taken.pop();
        } else {
            ++pieces_.slots;
        }
        pieces_.slot[v] = slot;
        taken.push({lives_[v].to, slot});
    }
}

void collectParameters(const Region &region, std::set<int> &parameters) {
    for (const Instruction &i : region.body) {
        if (i.op == Op::Parameter)
            parameters.insert(i.immediate);
        for (const Region &inner : i.regions)
            collectParameters(inner, parameters);
    }
}

} // namespace

FunctionPieces cutIntoPieces(const ir::Function &function, int longest) {
    FunctionPieces pieces;
    std::set<int> parameters;
    collectParameters(function.body, parameters);
    if (parameters.size() > mostParametersAlive)
        pieces.parametersInMemory.assign(parameters.begin(), parameters.end());
    Cutter(longest, pieces).region(function.body);
    if (pieces.hasSlots())
        SlotPlanner(function, pieces).plan(function.body);
    return pieces;
}

} // namespace candela

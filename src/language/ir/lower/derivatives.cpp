// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/derivatives.h"

#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/derivative_rules.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace candela::ir {

Components derivative(Builder &b, const Components &values, int direction) {
    Components result;
    for (ValueId value : values) {
        result.push_back(b.newValue(Type::Float, Rate::Varying));
        Instruction placeholder{
            .op = Op::Call, .operands = {value}, .results = {result.back()}, .regions = {}};
        placeholder.immediate = direction;
        placeholder.line = b.line();
        b.append(std::move(placeholder));
    }
    return result;
}

namespace {

bool isPlaceholder(const Instruction &i) { return i.op == Op::Call && i.immediate < 0; }

/// Where the derivative of each value comes from.
class Flow {
public:
    explicit Flow(const Function &function)
        : sources_(function.values.size()), stored_(function.arrays.size()) {
        read(function.body);
    }

    /// All values that the derivatives of these need, themselves included.
    std::vector<bool> closure(std::vector<ValueId> values) const {
        std::vector<bool> reached(sources_.size());
        std::vector<bool> arrays(stored_.size());
        while (!values.empty()) {
            const ValueId v = values.back();
            values.pop_back();
            if (reached[v])
                continue;
            reached[v] = true;
            values.insert(values.end(), sources_[v].begin(), sources_[v].end());
            const auto load = loads_.find(v);
            if (load != loads_.end() && !arrays[load->second]) {
                arrays[load->second] = true;
                const auto &stored = stored_[load->second];
                values.insert(values.end(), stored.begin(), stored.end());
            }
        }
        return reached;
    }

    /// Placeholders whose argument depends on no other's result; all, if they form a circle.
    std::vector<ValueId> innermost() const {
        std::vector<ValueId> all, inner;
        for (const auto &[result, argument] : placeholders_) {
            all.push_back(result);
            const std::vector<bool> reached = closure({argument});
            const bool depends = std::any_of(
                placeholders_.begin(), placeholders_.end(),
                [&, argument = argument](const auto &other) { return reached[other.first]; });
            if (!depends)
                inner.push_back(result);
        }
        return inner.empty() ? all : inner;
    }
    ValueId argumentOf(ValueId placeholder) const { return placeholders_.at(placeholder); }
    bool any() const { return !placeholders_.empty(); }
    /// Arrays from which a value of the set is loaded.
    std::vector<bool> arraysOf(const std::vector<bool> &values) const {
        std::vector<bool> result(stored_.size());
        for (const auto &[value, array] : loads_)
            if (values[value])
                result[array] = true;
        return result;
    }

private:
    void read(const Region &region) {
        for (const Instruction &i : region.body) {
            if (isPlaceholder(i))
                placeholders_[i.results[0]] = i.operands[0];
            else if (i.op == Op::ArrayStore)
                stored_[size_t(i.immediate)].push_back(i.operands[1]);
            else if (i.op == Op::ArrayLoad)
                loads_[i.results[0]] = size_t(i.immediate);
            else if (i.op == Op::If)
                for (const Region &inner : i.regions)
                    for (size_t k = 0; k < i.results.size(); ++k)
                        sources_[i.results[k]].push_back(inner.yields[k]);
            else if (i.op == Op::Loop || i.op == Op::LightLoop)
                readLoop(i);
            else
                for (ValueId result : i.results)
                    sources_[result] = differentiableOperands(i);
            for (const Region &inner : i.regions)
                read(inner);
        }
    }
    void readLoop(const Instruction &i) {
        const Region &body = i.regions[0];
        for (size_t k = 0; k < i.results.size(); ++k) {
            const ValueId argument = body.arguments[body.arguments.size() - i.results.size() + k];
            const ValueId initial = i.operands[i.operands.size() - i.results.size() + k];
            sources_[argument] = {initial, body.yields[k]};
            sources_[i.results[k]] = {argument, initial, body.yields[k]};
        }
    }

    std::vector<std::vector<ValueId>> sources_;
    std::vector<std::vector<ValueId>> stored_;
    std::map<ValueId, size_t> loads_;
    std::map<ValueId, ValueId> placeholders_;
};

/// Writes the function anew with derivatives beside the values that need them.
class Expansion {
public:
    Expansion(Function &function, const Flow &flow)
        : old_(std::exchange(function.body, {})), b_(function) {
        std::vector<ValueId> arguments;
        for (ValueId placeholder : flow.innermost()) {
            expanded_.insert(placeholder);
            arguments.push_back(flow.argumentOf(placeholder));
        }
        needed_ = flow.closure(arguments);
        const std::vector<bool> arrays = flow.arraysOf(needed_);
        for (size_t a = 0; a < arrays.size(); ++a)
            if (arrays[a]) {
                const Array array = function.arrays[a];
                const int first = addArray(b_, array.type, array.size);
                shadows_[int(a)] = first;
                addArray(b_, array.type, array.size);
            }
    }

    void run() {
        rebuild(old_.body);
        b_.finish();
    }

private:
    bool needs(ValueId v) const { return v < needed_.size() && needed_[v]; }
    void substitute(std::vector<ValueId> &list) const {
        for (ValueId &v : list)
            if (const auto found = replaced_.find(v); found != replaced_.end())
                v = found->second;
    }
    ValueId orZero(std::optional<ValueId> v) { return v ? *v : number(b_, 0); }

    void rebuild(std::vector<Instruction> &body) {
        for (Instruction &i : body) {
            b_.setLine(i.line);
            b_.setFile(i.file);
            if (isPlaceholder(i) && expanded_.contains(i.results[0])) {
                const Slope &slope = slopes_[i.operands[0]];
                replaced_[i.results[0]] = orZero(slope[i.immediate == derivativeByU ? 0 : 1]);
                continue;
            }
            substitute(i.operands);
            if (i.op == Op::If)
                rebuildIf(i);
            else if (i.op == Op::Loop || i.op == Op::LightLoop)
                rebuildLoop(i);
            else
                rebuildPlain(i);
        }
    }

    Region rebuildRegion(Region &region) {
        return b_.region(region.arguments, [&] {
            rebuild(region.body);
            substitute(region.yields);
            return region.yields;
        });
    }

    void rebuildPlain(Instruction &i) {
        b_.append(i);
        if (isPlaceholder(i))
            return; // Its turn comes when its argument is rid of placeholders.
        const auto shadow = i.op == Op::ArrayLoad || i.op == Op::ArrayStore
                                ? shadows_.find(i.immediate)
                                : shadows_.end();
        for (int direction = 0; direction < 2; ++direction) {
            if (i.op == Op::ArrayStore && shadow != shadows_.end())
                arrayStore(b_, shadow->second + direction, i.operands[0],
                           orZero(slopes_[i.operands[1]][direction]));
            else if (i.op == Op::ArrayLoad && shadow != shadows_.end() && needs(i.results[0]))
                slopes_[i.results[0]][direction] =
                    arrayLoad(b_, shadow->second + direction, i.operands[0]);
        }
        const bool wanted =
            std::any_of(i.results.begin(), i.results.end(), [&](ValueId v) { return needs(v); });
        if (wanted && i.op != Op::ArrayLoad)
            differentiate(b_, i, slopes_);
    }

    void rebuildIf(Instruction &i) {
        Region yes = rebuildRegion(i.regions[0]), no = rebuildRegion(i.regions[1]);
        const size_t count = i.results.size();
        for (size_t k = 0; k < count; ++k)
            for (int direction = 0; direction < 2 && needs(i.results[k]); ++direction) {
                const auto a = slopes_[yes.yields[k]][direction];
                const auto o = slopes_[no.yields[k]][direction];
                if (!a && !o)
                    continue;
                yes.yields.push_back(orZero(a));
                no.yields.push_back(orZero(o));
                const ValueId result = b_.newValue(Type::Float, Rate::Varying);
                i.results.push_back(result);
                slopes_[i.results[k]][direction] = result;
            }
        i.regions[0] = std::move(yes);
        i.regions[1] = std::move(no);
        b_.append(std::move(i));
    }

    void rebuildLoop(Instruction &i) {
        Region &body = i.regions[0];
        const size_t count = i.results.size();
        const size_t firstArgument = body.arguments.size() - count;
        const size_t firstInitial = i.operands.size() - count;
        struct Carried {
            size_t index;
            int direction;
        };
        std::vector<Carried> carried;
        for (size_t k = 0; k < count; ++k) {
            if (!needs(i.results[k]) && !needs(body.arguments[firstArgument + k]))
                continue;
            for (int direction = 0; direction < 2; ++direction) {
                carried.push_back({k, direction});
                const ValueId argument = b_.newValue(Type::Float, Rate::Varying);
                const ValueId result = b_.newValue(Type::Float, Rate::Varying);
                i.operands.push_back(orZero(slopes_[i.operands[firstInitial + k]][direction]));
                body.arguments.push_back(argument);
                i.results.push_back(result);
                slopes_[body.arguments[firstArgument + k]][direction] = argument;
                slopes_[i.results[k]][direction] = result;
            }
        }
        Region rebuilt = rebuildRegion(body);
        for (const Carried &c : carried)
            rebuilt.yields.push_back(orZero(slopes_[rebuilt.yields[c.index]][c.direction]));
        i.regions[0] = std::move(rebuilt);
        b_.append(std::move(i));
    }

    Region old_;
    Builder b_;
    std::set<ValueId> expanded_;
    std::vector<bool> needed_;
    std::map<int, int> shadows_; ///< The first of two arrays that hold an array's derivatives.
    std::map<ValueId, ValueId> replaced_;
    Slopes slopes_;
};

} // namespace

void expandDerivatives(Function &function) {
    for (;;) {
        const Flow flow(function);
        if (!flow.any())
            return;
        Expansion(function, flow).run();
    }
}

} // namespace candela::ir

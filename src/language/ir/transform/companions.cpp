// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/companions.h"

#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"

#include <algorithm>

namespace candela::ir {

Values WrittenValues::valuesOf(const Values &old) const {
    Values result;
    for (ValueId v : old)
        result.push_back(value[v]);
    return result;
}

namespace {

class CompanionWalk {
public:
    CompanionWalk(const Function &old, Builder &b, CompanionRules &rules) : b_(b), rules_(rules) {
        written_.value.resize(old.values.size());
        written_.beside.resize(old.values.size());
        for (int a = 0; a < int(old.arrays.size()); ++a) {
            arrays_.emplace_back();
            for (int part : rules.wantedOfArray(a))
                arrays_[size_t(a)][part] = addArray(b_, Type::Float, old.arrays[size_t(a)].size);
        }
    }

    void walk(const Region &region) {
        for (const Instruction &i : region.body) {
            b_.setLine(i.line);
            b_.setFile(i.file);
            walk(i);
        }
    }

private:
    /// A value that flows through control, or one of its companions (part above 0).
    struct Item {
        size_t index; ///< Among the results.
        int part;
    };

    void walk(const Instruction &i) {
        switch (i.op) {
        case Op::If: return walkIf(i);
        case Op::Loop: return walkLoop(i);
        case Op::LightLoop: return walkLightLoop(i);
        case Op::ArrayLoad: return walkLoad(i);
        case Op::ArrayStore: return walkStore(i);
        default: rules_.write(b_, i, written_);
        }
    }

    ValueId besideOrZero(ValueId old, int part) {
        const Companions &known = written_.beside[old];
        const auto found = known.find(part);
        return found == known.end() ? number(b_, 0) : found->second;
    }
    void assign(ValueId old, int part, ValueId now) {
        if (part == 0)
            written_.value[old] = now;
        else if (const float *known = constantFloat(b_, now); !known || *known != 0)
            written_.beside[old][part] = now;
    }

    /// The values themselves first, then what is wanted beside them.
    std::vector<Item> itemsOf(const std::vector<ValueId> &values) const {
        std::vector<Item> items;
        for (size_t k = 0; k < values.size(); ++k)
            items.push_back({k, 0});
        for (size_t k = 0; k < values.size(); ++k)
            for (int part : rules_.wanted(values[k]))
                items.push_back({k, part});
        return items;
    }
    /// `old` are as many as the values that the items were made of.
    Values take(const std::vector<Item> &items, const ValueId *old) {
        Values result;
        for (const Item &item : items)
            result.push_back(item.part == 0 ? written_.value[old[item.index]]
                                            : besideOrZero(old[item.index], item.part));
        return result;
    }
    void give(const std::vector<Item> &items, const ValueId *old, const Values &now) {
        for (size_t n = 0; n < items.size(); ++n)
            assign(old[items[n].index], items[n].part, now[n]);
    }

    void walkIf(const Instruction &i) {
        const std::vector<Item> items = itemsOf(i.results);
        const auto side = [&](const Region &region) {
            return [&] {
                walk(region);
                return take(items, region.yields.data());
            };
        };
        give(items, i.results.data(),
             ifElse(b_, written_.value[i.operands[0]], side(i.regions[0]), side(i.regions[1])));
    }

    void walkLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        const std::vector<Item> items = itemsOf(region.arguments);
        const auto turn = [&](const Values &arguments) {
            give(items, region.arguments.data(), arguments);
            walk(region);
            return take(items, region.yields.data());
        };
        give(items, i.results.data(), loop(b_, take(items, i.operands.data()), turn));
    }

    void walkLightLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        const size_t carried = i.results.size(), fixed = fixedOperands(i);
        const ValueId *arguments = region.arguments.data() + givenArguments(i);
        const std::vector<Item> items = itemsOf({arguments, arguments + carried});
        const Values request =
            written_.valuesOf({i.operands.begin(), i.operands.begin() + std::ptrdiff_t(fixed)});
        const auto sample = [&](const LoopLight &light, const Values &now) {
            for (size_t c = 0; c < 3; ++c)
                written_.value[region.arguments[c]] = light.L[c];
            for (size_t c = 0; c < light.Cl.size(); ++c)
                written_.value[region.arguments[3 + c]] = light.Cl[c];
            written_.value[region.arguments[3 + light.Cl.size()]] = light.number;
            give(items, arguments, now);
            walk(region);
            return take(items, region.yields.data());
        };
        give(items, i.results.data(),
             lightLoop(b_, i.immediate, {request[0], request[1], request[2]},
                       {request.begin() + 3, request.end()}, take(items, i.operands.data() + fixed),
                       sample));
    }

    void walkLoad(const Instruction &i) {
        const ValueId index = written_.value[i.operands[0]];
        assign(i.results[0], 0, arrayLoad(b_, i.immediate, index));
        for (int part : rules_.wanted(i.results[0]))
            assign(i.results[0], part, arrayLoad(b_, arrays_[size_t(i.immediate)].at(part), index));
    }

    void walkStore(const Instruction &i) {
        const ValueId index = written_.value[i.operands[0]];
        arrayStore(b_, i.immediate, index, written_.value[i.operands[1]]);
        for (auto [part, array] : arrays_[size_t(i.immediate)])
            arrayStore(b_, array, index, besideOrZero(i.operands[1], part));
    }

    Builder &b_;
    CompanionRules &rules_;
    WrittenValues written_;
    std::vector<std::map<int, int>> arrays_; ///< By old array and part: what stands beside it.
};

} // namespace

void writeWithCompanions(const Function &old, Builder &b, CompanionRules &rules) {
    CompanionWalk(old, b, rules).walk(old.body);
}

} // namespace candela::ir

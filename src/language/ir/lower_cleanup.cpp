// SPDX-License-Identifier: Apache-2.0
// Dead code goes, values are numbered anew, and the tables keep only what is still named.
#include "language/ir/builder.h"
#include "language/ir/lower_internal.h"
#include "language/ir/op_info.h"
#include "language/ir/rates.h"

#include <algorithm>

namespace candela::ir {
namespace {

/// Marks what effects need, backwards; loops are gone through until nothing new is found.
class Liveness {
public:
    explicit Liveness(const Function &function)
        : live(function.values.size()), arraysRead(function.arrays.size()) {
        do {
            grown_ = false;
            mark(function.body);
        } while (grown_);
    }

    /// Whether the instruction has to stay.
    bool isNeeded(const Instruction &i) const {
        if (i.op == Op::ArrayStore)
            return arraysRead[i.immediate];
        if (hasEffect(i.op))
            return true;
        if (std::any_of(i.results.begin(), i.results.end(), [&](ValueId v) { return live[v]; }))
            return true;
        return std::any_of(i.regions.begin(), i.regions.end(), [&](const Region &region) {
            return std::any_of(region.body.begin(), region.body.end(),
                               [&](const Instruction &inner) { return isNeeded(inner); });
        });
    }

    std::vector<bool> live, arraysRead;

private:
    void mark(std::vector<bool> &set, size_t index) {
        if (!set[index]) {
            set[index] = true;
            grown_ = true;
        }
    }
    void mark(const Region &region) {
        for (auto i = region.body.rbegin(); i != region.body.rend(); ++i)
            if (isNeeded(*i))
                mark(*i);
    }
    void mark(const Instruction &i) {
        if (i.op == Op::ArrayLoad)
            mark(arraysRead, size_t(i.immediate));
        const size_t carried = i.op == Op::Loop || i.op == Op::LightLoop ? i.results.size() : 0;
        const size_t fixed = i.operands.size() - carried;
        for (size_t k = 0; k < fixed; ++k)
            mark(live, i.operands[k]);
        if (i.op == Op::Loop)
            mark(live, i.results[0]);
        for (const Region &region : i.regions) {
            markYields(i, region, carried, fixed);
            mark(region);
        }
    }
    void markYields(const Instruction &i, const Region &region, size_t carried, size_t fixed) {
        const size_t firstArgument = region.arguments.size() - carried;
        for (size_t k = 0; k < i.results.size(); ++k) {
            const bool needed =
                live[i.results[k]] || (carried && live[region.arguments[firstArgument + k]]);
            if (!needed)
                continue;
            mark(live, region.yields[k]);
            mark(live, i.results[k]);
            if (carried) {
                mark(live, region.arguments[firstArgument + k]);
                mark(live, i.operands[fixed + k]);
            }
        }
    }

    bool grown_ = false;
};

/// Drops what is not live. If and loops lose results, yields and arguments in step.
void sweep(Region &region, const Liveness &liveness) {
    std::erase_if(region.body, [&](const Instruction &i) { return !liveness.isNeeded(i); });
    for (Instruction &i : region.body) {
        if (i.regions.empty())
            continue;
        const size_t carried = i.op == Op::If ? 0 : i.results.size();
        const size_t fixed = i.operands.size() - carried;
        for (size_t k = i.results.size(); k-- > 0;) {
            if (liveness.live[i.results[k]])
                continue;
            i.results.erase(i.results.begin() + long(k));
            for (Region &inner : i.regions) {
                inner.yields.erase(inner.yields.begin() + long(k));
                if (carried)
                    inner.arguments.erase(inner.arguments.begin() +
                                          long(inner.arguments.size() - i.results.size() - 1 + k));
            }
            if (carried)
                i.operands.erase(i.operands.begin() + long(fixed + k));
        }
        for (Region &inner : i.regions)
            sweep(inner, liveness);
    }
}

/// Numbers things anew in the order of their first appearance.
class Renumbering {
public:
    int operator()(int old) {
        const auto [entry, isNew] = numbers_.try_emplace(old, int(order.size()));
        if (isNew)
            order.push_back(old);
        return entry->second;
    }
    /// The table's entries that are still named, in their new order.
    template <class T> std::vector<T> apply(const std::vector<T> &table) const {
        std::vector<T> result;
        for (int old : order)
            result.push_back(table[size_t(old)]);
        return result;
    }
    std::vector<int> order;

private:
    std::map<int, int> numbers_;
};

template <class Visitor> void forEachInstruction(Region &region, Visitor visit) {
    for (Instruction &i : region.body) {
        visit(i);
        for (Region &inner : i.regions)
            forEachInstruction(inner, visit);
    }
}

struct Tables {
    Renumbering values, arrays, strings, spaces, variables, requests, categories;

    void renumber(std::vector<ValueId> &list) {
        for (ValueId &v : list)
            v = ValueId(values(int(v)));
    }
    void renumber(Region &region) {
        renumber(region.arguments);
        for (Instruction &i : region.body) {
            renumber(i.operands);
            renumber(i.results);
            renumberImmediate(i);
            for (Region &inner : i.regions)
                renumber(inner);
        }
        renumber(region.yields);
    }
    void renumberImmediate(Instruction &i) {
        Renumbering *table = i.op == Op::ArrayLoad || i.op == Op::ArrayStore ? &arrays
                             : i.op == Op::ConstString                       ? &strings
                             : i.op == Op::Space || i.op == Op::SpaceInverse ? &spaces
                             : i.op == Op::Variable                          ? &variables
                             : i.op == Op::LightLoop || i.op == Op::Answer   ? &requests
                                                                             : nullptr;
        if (table)
            i.immediate = (*table)(i.immediate);
    }
};

/// A parameter of which any component is read keeps all of its slots.
void compactParameters(Function &function, std::vector<ShaderParameter> &parameters) {
    std::set<std::string> read;
    forEachInstruction(function.body, [&](Instruction &i) {
        if (i.op == Op::Parameter)
            read.insert(function.parameters[size_t(i.immediate)].name);
    });
    std::vector<int> slot(function.parameters.size(), -1);
    std::vector<ParameterSlot> kept;
    for (size_t k = 0; k < function.parameters.size(); ++k)
        if (read.contains(function.parameters[k].name)) {
            slot[k] = int(kept.size());
            kept.push_back(function.parameters[k]);
        }
    forEachInstruction(function.body, [&](Instruction &i) {
        if (i.op == Op::Parameter)
            i.immediate = slot[size_t(i.immediate)];
    });
    function.parameters = std::move(kept);
    for (ShaderParameter &parameter : parameters) {
        parameter.firstSlot = -1;
        for (size_t k = function.parameters.size(); k-- > 0;)
            if (function.parameters[k].name == parameter.name)
                parameter.firstSlot = int(k);
    }
}

} // namespace

void removeUnused(Function &function, std::vector<ShaderParameter> &parameters) {
    sweep(function.body, Liveness(function));
    compactParameters(function, parameters);
    Tables tables;
    tables.renumber(function.body);
    function.requests = tables.requests.apply(function.requests);
    for (LightRequest &request : function.requests)
        if (request.category >= 0)
            request.category = tables.categories(request.category);
    function.values = tables.values.apply(function.values);
    function.arrays = tables.arrays.apply(function.arrays);
    function.strings = tables.strings.apply(function.strings);
    function.spaces = tables.spaces.apply(function.spaces);
    function.variables = tables.variables.apply(function.variables);
    function.categories = tables.categories.apply(function.categories);
    Builder(function).finish(); // Rates and the inputs that are still read.
}

} // namespace candela::ir

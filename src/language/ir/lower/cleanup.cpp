// SPDX-License-Identifier: Apache-2.0
// Dead code goes, values are numbered anew, and the tables keep only what is still named.
#include "language/ir/lower/cleanup.h"

#include "language/ir/core/builder.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/dead_code.h"

#include <map>
#include <set>

namespace candela::ir {
namespace {

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

struct Tables {
    Renumbering values, arrays, images, services, strings, spaces, variables, requests, categories;

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
    /// The tables whose entries are renumbered; the rest of an instruction's immediates stay.
    Renumbering *tableOf(Immediate kind) {
        switch (kind) {
        case Immediate::Array: return &arrays;
        case Immediate::Image: return &images;
        case Immediate::Service: return &services;
        case Immediate::String: return &strings;
        case Immediate::Space: return &spaces;
        case Immediate::Variable: return &variables;
        case Immediate::Request: return &requests;
        default: return nullptr;
        }
    }
    void renumberImmediate(Instruction &i) {
        if (Renumbering *table = tableOf(info(i.op).immediate))
            i.immediate = (*table)(i.immediate);
    }
};

/// A parameter of which any component is read keeps all of its slots.
void compactParameters(Function &function, std::vector<ShaderParameter> &parameters) {
    std::set<std::string> read;
    std::map<std::string, int> first;
    forEachInstruction(function.body, [&](Instruction &i) {
        if (i.op == Op::Parameter)
            read.insert(function.parameters[size_t(i.immediate)].name);
    });
    std::vector<int> slot(function.parameters.size(), -1);
    std::vector<ParameterSlot> kept;
    for (size_t k = 0; k < function.parameters.size(); ++k)
        if (read.contains(function.parameters[k].name)) {
            slot[k] = int(kept.size());
            first.try_emplace(function.parameters[k].name, slot[k]);
            kept.push_back(function.parameters[k]);
        }
    forEachInstruction(function.body, [&](Instruction &i) {
        if (i.op == Op::Parameter)
            i.immediate = slot[size_t(i.immediate)];
    });
    function.parameters = std::move(kept);
    for (ShaderParameter &parameter : parameters) {
        const auto found = first.find(parameter.name);
        parameter.firstSlot = found == first.end() ? -1 : found->second;
    }
}

} // namespace

void removeUnused(Function &function, std::vector<ShaderParameter> &parameters) {
    removeDeadCode(function);
    compactParameters(function, parameters);
    Tables tables;
    tables.renumber(function.body);
    function.requests = tables.requests.apply(function.requests);
    for (LightRequest &request : function.requests)
        if (request.category >= 0)
            request.category = tables.categories(request.category);
    function.services = tables.services.apply(function.services);
    for (ServiceUse &use : function.services)
        for (int &text : use.texts)
            if (text != ServiceUse::atRunTime)
                text = tables.strings(text);
    function.values = tables.values.apply(function.values);
    function.arrays = tables.arrays.apply(function.arrays);
    function.images = tables.images.apply(function.images);
    function.strings = tables.strings.apply(function.strings);
    function.spaces = tables.spaces.apply(function.spaces);
    function.variables = tables.variables.apply(function.variables);
    function.categories = tables.categories.apply(function.categories);
    Builder(function).finish(); // Uniformity and the inputs that are still read.
}

} // namespace candela::ir

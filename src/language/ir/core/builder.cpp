// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder.h"

#include "language/ir/core/builder_fold.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/rates.h"
#include "language/runtime/runtime_functions.h"

#include <algorithm>
#include <bit>

namespace candela::ir {

int intern(std::vector<std::string> &table, const std::string &s) {
    const auto found = std::find(table.begin(), table.end(), s);
    const int index = int(found - table.begin());
    if (found == table.end())
        table.push_back(s);
    return index;
}

Builder::Builder(Function &function) : function_(function) {
    scopes_.push_back({&function.body, {}});
}

void Builder::finish() {
    constants_.moveTo(function_);
    inferRates(function_);
    markInputsRead(function_);
}

const Values *Builder::find(const Key &key) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
        if (auto it = scope->known.find(key); it != scope->known.end())
            return &it->second;
    return nullptr;
}

namespace {

Rate rateOfResults(const Function &function, Op op, const Values &operands) {
    Rate rate = info(op).uniformity == ResultUniformity::Varying ? Rate::Varying : Rate::Uniform;
    for (ValueId v : operands)
        if (function.values[v].rate == Rate::Varying)
            rate = Rate::Varying;
    return rate;
}

Values makeResults(Function &function, Op op, const Values &operands, int immediate) {
    const Rate rate = rateOfResults(function, op, operands);
    Values results;
    const auto make = [&](Type type, int count) {
        for (int k = 0; k < count; ++k)
            results.push_back(function.addValue(type, rate));
    };
    const Type same = isArrayAccess(op)  ? function.arrays[immediate].type
                      : operands.empty() ? Type::Float
                                         : function.values[operands.back()].type;
    for (char letter : info(op).results)
        if (letter == '*')
            make(Type::Float, runtime::info(runtime::RuntimeFunction(immediate)).outputs);
        else
            make(letter == '.' ? same : typeOf(letter), countOf(letter, function.colors.samples));
    return results;
}

} // namespace

Values Builder::emit(Op op, const Values &operands, int immediate, float number) {
    if (isConstant(op))
        return {constants_.intern(function_, op, immediate, number)};
    if (auto folded = foldOperation(*this, op, operands))
        return {*folded};
    Key key{op, operands, immediate, std::bit_cast<std::uint32_t>(number)};
    if (isPure(op))
        if (const Values *known = find(key))
            return *known;
    Values results = makeResults(function_, op, operands, immediate);
    append({op, operands, results, {}, immediate, number, line_, file_});
    if (isPure(op))
        scopes_.back().known[key] = results;
    return results;
}

void Builder::append(Instruction instruction) {
    scopes_.back().region->body.push_back(std::move(instruction));
}

Region Builder::region(const Values &arguments, const std::function<Values()> &body) {
    Region result;
    result.arguments = arguments;
    scopes_.push_back({&result, {}});
    result.yields = body();
    scopes_.pop_back();
    return result;
}

} // namespace candela::ir

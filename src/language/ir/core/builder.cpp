// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder.h"

#include "language/ir/core/builder_fold.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/uniformity.h"
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

Builder::Builder(Function &function, Budget budget) : function_(function), budget_(budget) {
    scopes_.push_back({&function.body, {}});
}

void Builder::finish() {
    constants_.moveTo(function_);
    inferUniformity(function_);
    markInputsRead(function_);
}

std::size_t Builder::KeyHash::operator()(const Key &key) const {
    std::uint64_t hash = std::uint64_t(key.op) << 32 ^ std::uint32_t(key.immediate);
    const auto add = [&](std::uint64_t word) { // Fowler, Noll and Vo's, word by word.
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 29;
    };
    add(key.number);
    for (ValueId v : key.operands)
        add(v);
    return std::size_t(hash);
}

namespace {

Uniformity uniformityOfResults(const Function &function, Op op, const Values &operands,
                               int immediate) {
    const ResultUniformity rule = info(op).uniformity;
    const bool varies = rule == ResultUniformity::Varying ||
                        (rule == ResultUniformity::Service &&
                         variesByItself(function.services[std::size_t(immediate)]));
    Uniformity uniformity = varies ? Uniformity::Varying : Uniformity::Uniform;
    for (ValueId v : operands)
        if (function.values[v].uniformity == Uniformity::Varying)
            uniformity = Uniformity::Varying;
    return uniformity;
}

/// Of an operation whose row says "*".
int resultCount(const Function &function, Op op, int immediate) {
    if (isService(op))
        return function.services[std::size_t(immediate)].results;
    return op == Op::ImageLoad ? function.images[std::size_t(immediate)].values
                               : runtime::info(runtime::RuntimeFunction(immediate)).outputs;
}

Values makeResults(Function &function, Op op, const Values &operands, int immediate) {
    const Uniformity uniformity = uniformityOfResults(function, op, operands, immediate);
    Values results;
    const auto make = [&](Type type, int count) {
        for (int k = 0; k < count; ++k)
            results.push_back(function.addValue(type, uniformity));
    };
    const Type same = isArrayAccess(op)  ? function.arrays[immediate].type
                      : operands.empty() ? Type::Float
                                         : function.values[operands.back()].type;
    for (char letter : info(op).results)
        if (letter == '*')
            make(Type::Float, resultCount(function, op, immediate));
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
    Key key{op, immediate, std::bit_cast<std::uint32_t>(number), operands};
    if (isPure(op))
        if (auto known = known_.find(key); known != known_.end())
            return known->second;
    Values results = makeResults(function_, op, operands, immediate);
    append({op, operands, results, {}, immediate, number, place_.line, place_.file});
    if (results.size() == 1)
        unitVectors.note(op, operands, results[0]);
    if (isPure(op)) {
        known_.emplace(key, results);
        scopes_.back().known.push_back(std::move(key));
    }
    return results;
}

void Builder::append(Instruction instruction) {
    if (budget_.spend(instruction.line))
        scopes_.back().region->body.push_back(std::move(instruction));
}

Region Builder::region(const Values &arguments, const std::function<Values()> &body) {
    Region result;
    result.arguments = arguments;
    scopes_.push_back({&result, {}});
    result.yields = body();
    for (const Key &key : scopes_.back().known)
        known_.erase(key);
    scopes_.pop_back();
    return result;
}

} // namespace candela::ir

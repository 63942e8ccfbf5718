// SPDX-License-Identifier: Apache-2.0
#include "language/ir/filter/pixel_loops.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/core/uniformity.h"
#include "language/ir/filter/pixel_nest.h"
#include "language/ir/transform/dead_code.h"
#include "language/ir/transform/short_loops.h"
#include "language/ir/transform/specialize.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

namespace candela::ir {

namespace {

Instruction constant(float number, ValueId result) {
    Instruction made;
    made.op = Op::ConstFloat;
    made.number = number;
    made.results = {result};
    return made;
}

Instruction plain(Op op, std::vector<ValueId> operands, ValueId result, int immediate = 0) {
    Instruction made;
    made.op = op;
    made.operands = std::move(operands);
    made.results = {result};
    made.immediate = immediate;
    return made;
}

/// Little is done with each pixel: what is done for all of a block is to be shared by many. (What
/// is called takes a register at a time.)
bool isLight(const Function &body) {
    constexpr std::size_t mostInstructions = 64;
    const auto calls = [](const Instruction &i) {
        const OpClass kind = info(i.op).kind;
        return kind == OpClass::Call || kind == OpClass::Transcendental ||
               kind == OpClass::Service || i.op == Op::Command;
    };
    return instructionCount(body.body) <= mostInstructions && !anyInstruction(body.body, calls);
}

/// Writes the function of a nest. Its values keep their numbers.
class BodyWriter {
public:
    BodyWriter(const Function &filter, const ValueFacts &facts, const PixelNest &nest)
        : filter_(filter), facts_(facts), nest_(nest) {}

    /// False if the nest wants from outside what cannot be handed in.
    bool write(int number);

    Function body;
    std::vector<ValueId> captured; ///< Of the filter's; floats and bools.

private:
    void takeArrays();
    void collectMade(const Region &);
    bool handIn(const Region &);
    bool handIn(const std::vector<ValueId> &values);
    bool handIn(ValueId);
    void capture(ValueId);
    void writeSums();

    const Function &filter_;
    const ValueFacts &facts_;
    const PixelNest &nest_;
    std::set<ValueId> made_; ///< What the body has, or is going to have.
};

/// The arrays that it has, its own and captured ones.
void BodyWriter::takeArrays() {
    std::map<int, int> numbers;
    forEachInstruction(body.body, [&](Instruction &i) {
        if (!isArrayAccess(i.op))
            return;
        const auto [known, isNew] = numbers.try_emplace(i.immediate, int(numbers.size()));
        if (isNew) {
            body.arrays.push_back(filter_.arrays[std::size_t(i.immediate)]);
            const auto at = std::ranges::find(nest_.arrays, i.immediate);
            body.arrays.back().captured =
                at == nest_.arrays.end() ? -1 : int(at - nest_.arrays.begin());
        }
        i.immediate = known->second;
    });
}

void BodyWriter::collectMade(const Region &region) {
    made_.insert(region.arguments.begin(), region.arguments.end());
    for (const Instruction &i : region.body) {
        made_.insert(i.results.begin(), i.results.end());
        for (const Region &inner : i.regions)
            collectMade(inner);
    }
}

void BodyWriter::capture(ValueId v) {
    const int number = 1 + int(captured.size());
    captured.push_back(v);
    made_.insert(v);
    if (filter_.values[v].type == Type::Float) {
        body.body.body.push_back(plain(Op::Captured, {}, v, number));
        return;
    }
    const ValueId given = body.addValue(Type::Float, Uniformity::Uniform);
    const ValueId zero = body.addValue(Type::Float, Uniformity::Uniform);
    body.body.body.push_back(plain(Op::Captured, {}, given, number));
    body.body.body.push_back(constant(0, zero));
    body.body.body.push_back(plain(Op::NotEqual, {given, zero}, v));
}

/// Constants and what comes from the picture are made again, and so are integers and strings, which
/// cannot be handed in.
bool BodyWriter::handIn(ValueId v) {
    if (made_.contains(v))
        return true;
    const Instruction *made = facts_.definition(v);
    const Type type = filter_.values[v].type;
    const bool again = made && isPure(made->op) && made->regions.empty() &&
                       (isConstant(made->op) || type == Type::Integer || type == Type::String);
    if (!again && (type == Type::Integer || type == Type::String))
        return false;
    if (!again) {
        capture(v);
        return true;
    }
    if (!handIn(made->operands))
        return false;
    body.body.body.push_back(*made);
    made_.insert(made->results.begin(), made->results.end());
    return true;
}

bool BodyWriter::handIn(const std::vector<ValueId> &values) {
    return std::ranges::all_of(values, [&](ValueId v) { return handIn(v); });
}

bool BodyWriter::handIn(const Region &region) {
    for (const Instruction &i : region.body) {
        if (!handIn(i.operands))
            return false;
        for (const Region &inner : i.regions)
            if (!handIn(inner))
                return false;
    }
    return handIn(region.yields);
}

void BodyWriter::writeSums() {
    for (std::size_t k = 0; k < nest_.reductions.size(); ++k) {
        body.outputs.push_back({OutputName("sum " + std::to_string(k)), 0, 0});
        Instruction output;
        output.op = Op::Output;
        output.operands = {nest_.reductions[k].next};
        output.immediate = int(k);
        body.body.body.push_back(output);
    }
}

bool BodyWriter::write(int number) {
    const Region &inner = nest_.inner->regions[0];
    Region content;
    for (const Instruction *i : nest_.before())
        content.body.push_back(*i);
    content.body.insert(content.body.end(), inner.body.begin(), inner.body.end());
    for (const NestReduction &each : nest_.reductions)
        content.yields.push_back(each.next);

    body = emptyLike(filter_);
    body.name += ".loop " + std::to_string(number);
    body.values = filter_.values;
    std::vector<Instruction> &head = body.body.body;
    head.push_back(plain(Op::Input, {}, nest_.columns.variable(), int(ShaderInput::column)));
    made_.insert(nest_.columns.variable());
    if (nest_.rows) {
        head.push_back(plain(Op::Captured, {}, nest_.rows->variable(), 0));
        made_.insert(nest_.rows->variable());
    }
    for (const NestReduction &each : nest_.reductions) {
        head.push_back(constant(neutralOf(each.kind), each.before));
        made_.insert(each.before);
    }
    collectMade(content);
    if (!handIn(content))
        return false;
    head.insert(head.end(), content.body.begin(), content.body.end());
    writeSums();
    takeArrays();
    removeDeadCode(body);
    inferUniformity(body);
    markShortLoops(body);
    body.registersTogether = isLight(body) ? 4 : 1;
    return true;
}

class Extraction {
public:
    explicit Extraction(Function filter)
        : original_(std::move(filter)), facts_(original_), result_(original_) {}

    Function run() {
        result_.body = rewritten(original_.body);
        removeDeadCode(result_);
        inferUniformity(result_);
        return std::move(result_);
    }

private:
    Region rewritten(const Region &);
    bool extract(const Instruction &, std::vector<Instruction> &to);
    ValueId newNumber(float, std::vector<Instruction> &to);

    const Function original_;
    const ValueFacts facts_;
    Function result_;
};

Region Extraction::rewritten(const Region &region) {
    Region result;
    result.arguments = region.arguments;
    result.yields = region.yields;
    for (const Instruction &i : region.body) {
        if (i.op == Op::Loop && extract(i, result.body))
            continue;
        result.body.push_back(i);
        for (Region &inner : result.body.back().regions)
            inner = rewritten(inner);
    }
    return result;
}

ValueId Extraction::newNumber(float number, std::vector<Instruction> &to) {
    const ValueId made = result_.addValue(Type::Float, Uniformity::Uniform);
    to.push_back(constant(number, made));
    return made;
}

bool Extraction::extract(const Instruction &loop, std::vector<Instruction> &to) {
    const auto nest = pixelNest(original_, facts_, loop);
    if (!nest)
        return false;
    BodyWriter writer(original_, facts_, *nest);
    const int number = int(result_.pixelLoops.size());
    if (!writer.write(number))
        return false;

    PixelLoop made;
    made.captured = int(writer.captured.size());
    made.closedColumns = nest->columns.isClosed;
    made.closedRows = nest->rows && nest->rows->isClosed;
    made.arrays = nest->arrays;
    made.mapsRead = nest->mapsRead;
    made.mapsReadAround = nest->mapsReadAround;
    made.mapsSet = nest->mapsSet;
    made.mapsCovered = nest->mapsCovered;

    Instruction call;
    call.op = Op::PixelLoop;
    call.immediate = number;
    call.line = loop.line;
    call.operands = {nest->columns.first, nest->columns.end};
    if (nest->rows)
        call.operands.insert(call.operands.end(), {nest->rows->first, nest->rows->end});
    else
        for (const float bound : {0.0f, 1.0f})
            call.operands.push_back(newNumber(bound, to));
    for (const ValueId v : writer.captured) {
        ValueId given = v;
        if (original_.values[v].type == Type::Bool) {
            given = result_.addValue(Type::Float, Uniformity::Uniform);
            to.push_back(plain(Op::FloatFromBool, {v}, given));
        }
        call.operands.push_back(given);
    }
    for (const NestReduction &each : nest->reductions) {
        made.sums.push_back(each.kind);
        call.operands.push_back(each.begin);
        call.results.push_back(each.result);
    }
    made.body = std::make_shared<const Function>(std::move(writer.body));
    result_.pixelLoops.push_back(std::move(made));
    to.push_back(std::move(call));
    return true;
}

} // namespace

float neutralOf(Reduction reduction) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    return reduction == Reduction::Sum ? 0 : reduction == Reduction::Least ? infinity : -infinity;
}

Function extractPixelLoops(Function filter) { return Extraction(std::move(filter)).run(); }

} // namespace candela::ir

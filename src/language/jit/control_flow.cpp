// SPDX-License-Identifier: Apache-2.0
#include "language/jit/control_flow.h"

#include "language/ir/core/op_info.h"

#include <algorithm>

namespace candela::codegen {

using ir::Instruction;
using ir::Op;
using ir::Region;
using ir::Uniformity;

ControlFlow::ControlFlow(CodeFunction &code, ValueTable &values, TurnLimit &limit,
                         EmitRegion emitRegion)
    : code_(code), builder_(code.builder), values_(values), limit_(limit),
      emitRegion_(std::move(emitRegion)) {}

void ControlFlow::emitIf(const Instruction &i) {
    if (values_.uniformity(i.operands[0]) == Uniformity::Uniform)
        emitUniformIf(i);
    else
        emitVaryingIf(i);
}

Values ControlFlow::yields(const Region &region, const Instruction &owner) const {
    Values result;
    for (std::size_t k = 0; k < owner.results.size(); ++k)
        result.push_back(values_.get(region.yields[k], values_.uniformity(owner.results[k])));
    return result;
}

void ControlFlow::emitUniformIf(const Instruction &i) {
    auto *condition = values_.get(i.operands[0], Uniformity::Uniform);
    llvm::BasicBlock *starts[2] = {code_.block("then"), code_.block("else")};
    auto *join = code_.block("endif");
    builder_.CreateCondBr(condition, starts[0], starts[1]);
    llvm::BasicBlock *ends[2];
    Values yielded[2];
    for (int branch = 0; branch < 2; ++branch) {
        builder_.SetInsertPoint(starts[branch]);
        emitRegion_(i.regions[branch]);
        yielded[branch] = yields(i.regions[branch], i);
        ends[branch] = builder_.GetInsertBlock();
        builder_.CreateBr(join);
    }
    builder_.SetInsertPoint(join);
    for (std::size_t k = 0; k < i.results.size(); ++k) {
        auto *phi = builder_.CreatePHI(yielded[0][k]->getType(), 2);
        for (int branch = 0; branch < 2; ++branch)
            phi->addIncoming(yielded[branch][k], ends[branch]);
        values_.set(i.results[k], phi);
    }
}

/// Few plain operations: cheaper to run than to branch about.
static bool isTrivial(const Region &region) {
    if (region.body.size() > 6)
        return false;
    return std::all_of(region.body.begin(), region.body.end(), [](const Instruction &i) {
        return ir::info(i.op).speculation == ir::Speculation::Always;
    });
}

Values ControlFlow::emitBranch(const Region &region, Value *taken, const Instruction &owner) {
    MaskStack::Scope scope(code_.masks, taken);
    const auto emit = [&] {
        emitRegion_(region);
        return yields(region, owner);
    };
    return isTrivial(region) ? emit() : code_.valuesIf(code_.lanes.any(taken), "lanes", emit);
}

void ControlFlow::emitVaryingIf(const Instruction &i) {
    auto *condition = values_.get(i.operands[0], Uniformity::Varying);
    const bool jumps = !isTrivial(i.regions[0]) || !isTrivial(i.regions[1]);
    auto *kept = jumps ? code_.lanes.kept(condition) : condition;
    const Values then = emitBranch(i.regions[0], code_.masks.currentAnd(condition), i);
    const Values otherwise = emitBranch(i.regions[1], code_.masks.currentAndNot(condition), i);
    condition = code_.lanes.asMask(kept);
    for (std::size_t k = 0; k < i.results.size(); ++k) {
        const bool isMask = values_.function().values[i.results[k]].type == ir::Type::Bool;
        const auto value = [&](Value *from) { return isMask ? code_.lanes.asMask(from) : from; };
        values_.set(i.results[k],
                    builder_.CreateSelect(condition, value(then[k]), value(otherwise[k])));
    }
}

void ControlFlow::emitLoop(const Instruction &i) {
    const Region &region = i.regions[0];
    const bool varying = values_.uniformity(region.arguments[0]) == Uniformity::Varying;
    // Masks are carried in the form that is kept.
    const auto isMask = [&](std::size_t k) {
        const ir::Value &value = values_.function().values[region.arguments[k]];
        return value.type == ir::Type::Bool && value.uniformity == Uniformity::Varying;
    };
    const auto kept = [&](std::size_t k, Value *value) {
        return isMask(k) ? code_.lanes.kept(value) : value;
    };
    const auto restored = [&](std::size_t k, Value *value) {
        return isMask(k) ? code_.lanes.asMask(value) : value;
    };
    Values initial;
    for (std::size_t k = 0; k < i.operands.size(); ++k)
        initial.push_back(
            kept(k, values_.get(i.operands[k], values_.uniformity(region.arguments[k]))));
    TurnLimit::Scope turns(limit_, i);
    auto *from = builder_.GetInsertBlock();
    auto *head = code_.block("loop"), *body = code_.block("loop_body"),
         *done = code_.block("loop_end");
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    std::vector<llvm::PHINode *> carried;
    for (std::size_t k = 0; k < initial.size(); ++k) {
        carried.push_back(builder_.CreatePHI(initial[k]->getType(), 2));
        carried[k]->addIncoming(initial[k], from);
    }
    for (std::size_t k = 0; k < initial.size(); ++k)
        values_.set(region.arguments[k], restored(k, carried[k]));
    auto *test = values_.get(region.arguments[0]);
    auto *all = code_.masks.current();
    auto *mask = turns.running(varying ? code_.masks.currentAnd(test) : all);
    Value *goesOn = varying ? code_.lanes.any(mask) : test;
    if (!varying && mask != all)
        goesOn = builder_.CreateAnd(goesOn, code_.lanes.any(mask));
    mask = code_.lanes.kept(mask);
    builder_.CreateCondBr(goesOn, body, done);

    builder_.SetInsertPoint(body);
    MaskStack::Scope scope(code_.masks, turns.take(code_.lanes.asMask(mask), done));
    emitRegion_(region);
    for (std::size_t k = 0; k < carried.size(); ++k) {
        const Uniformity uniformity = values_.uniformity(region.arguments[k]);
        auto *next = values_.get(region.yields[k], uniformity);
        if (varying && uniformity == Uniformity::Varying)
            next = builder_.CreateSelect(code_.masks.current(), next,
                                         values_.get(region.arguments[k]));
        carried[k]->addIncoming(kept(k, next), builder_.GetInsertBlock());
    }
    builder_.CreateBr(head);

    builder_.SetInsertPoint(done);
    for (std::size_t k = 0; k < carried.size(); ++k)
        values_.set(i.results[k], restored(k, carried[k]));
}

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/jit/turn_limit.h"

#include "language/ir/core/regions.h"

#include <llvm/IR/MDBuilder.h>

namespace candela::codegen {

namespace {

bool isCounted(const ir::Instruction &i) { return i.op == ir::Op::Loop && i.immediate == 0; }

bool holdsCounted(const ir::Region &region) { return ir::anyInstruction(region, isCounted); }

} // namespace

TurnLimit::TurnLimit(CodeFunction &code, ValueTable &values, RuntimeCalls &calls)
    : code_(code), builder_(code.builder), values_(values), calls_(calls) {
    if (!holdsCounted(values.function().body))
        return;
    all_ = code.entryMemory(code.integerType, 1, "turns");
    each_ = code.entryMemory(code.lanes.varying(code.integerType), 1, "lane_turns");
    ended_ = code.entryMemory(code.lanes.varying(builder_.getInt1Ty()), 1, "ended");
}

Values TurnLimit::exchangeMemory(const Values &memory) {
    Values until = this->memory();
    if (!memory.empty())
        all_ = memory[0], each_ = memory[1], ended_ = memory[2];
    return until;
}

void TurnLimit::begin() {
    if (ended_)
        builder_.CreateStore(
            llvm::Constant::getNullValue(code_.lanes.varying(builder_.getInt1Ty())), ended_);
}

Value *TurnLimit::running(Value *lanes) const {
    if (!ended_)
        return lanes;
    auto *ended = builder_.CreateLoad(lanes->getType(), ended_, "ended");
    return builder_.CreateAnd(lanes, builder_.CreateNot(ended), "running");
}

Value *TurnLimit::whereRunning(Value *value, float ended) const {
    if (!ended_)
        return value;
    auto *mask = builder_.CreateLoad(code_.lanes.varying(builder_.getInt1Ty()), ended_, "ended");
    return builder_.CreateSelect(mask, llvm::ConstantFP::get(value->getType(), ended), value);
}

Value *TurnLimit::countLanes(Value *lanes) {
    auto *type = code_.lanes.varying(code_.integerType);
    auto *turns = builder_.CreateSub(builder_.CreateLoad(type, each_),
                                     builder_.CreateSExt(lanes, type), "lane_turns");
    builder_.CreateStore(turns, each_);
    return turns;
}

TurnLimit::Scope::Scope(TurnLimit &limit, const ir::Instruction &loop)
    : limit_(limit), loop_(loop), counts_(isCounted(loop)),
      contains_(holdsCounted(loop.regions[0])) {
    if (!counts_)
        return;
    if (limit_.open_++ == 0) {
        auto &builder = limit_.builder_;
        auto *each = limit_.code_.lanes.varying(limit_.code_.integerType);
        builder.CreateStore(builder.getInt32(0), limit_.all_);
        builder.CreateStore(llvm::Constant::getNullValue(each), limit_.each_);
    }
    if (!contains_) // Until the loop ends no lane is ended.
        entered_ = limit_.running(limit_.code_.masks.current());
}

TurnLimit::Scope::~Scope() { limit_.open_ -= counts_ ? 1 : 0; }

Value *TurnLimit::Scope::running(Value *lanes) const {
    if (!counts_)
        return lanes;
    return entered_ ? limit_.builder_.CreateAnd(lanes, entered_, "running") : limit_.running(lanes);
}

Value *TurnLimit::Scope::take(Value *lanes, llvm::BasicBlock *done) {
    if (!counts_)
        return lanes;
    CodeFunction &code = limit_.code_;
    auto &builder = limit_.builder_;
    const bool isEndless = limit_.values_.function().isEndless;
    const bool nested = !isEndless && (contains_ || limit_.open_ > 1); // All lanes end at once.
    const int most = limit_.values_.function().mostTurns;
    auto *count = builder.CreateAdd(builder.CreateLoad(code.integerType, limit_.all_),
                                    builder.getInt32(1), "turns");
    builder.CreateStore(count, limit_.all_);
    auto *each = nested ? limit_.countLanes(lanes) : nullptr;
    auto *from = builder.GetInsertBlock();
    auto *many = code.block("many_turns"), *end = code.block("end_loop"), *go = code.block("turn");
    builder.CreateCondBr(builder.CreateICmpSGT(count, builder.getInt32(std::uint32_t(most))), many,
                         go,
                         llvm::MDBuilder(code.module.getContext()).createUnlikelyBranchWeights());
    builder.SetInsertPoint(many);
    auto *over = lanes;
    if (isEndless) {
        builder.CreateStore(builder.getInt32(0), limit_.all_);
        builder.CreateCondBr(limit_.calls_.goesOn(), go, end);
    } else if (nested) {
        auto *limit = llvm::ConstantInt::get(each->getType(), std::uint64_t(most));
        over = builder.CreateAnd(lanes, builder.CreateICmpSGT(each, limit));
        builder.CreateCondBr(code.lanes.any(over), end, go);
    } else {
        builder.CreateBr(end);
    }
    builder.SetInsertPoint(end);
    if (!isEndless)
        limit_.calls_.reportLoopEnded(loop_);
    auto *ended = builder.CreateLoad(lanes->getType(), limit_.ended_);
    builder.CreateStore(builder.CreateOr(ended, over), limit_.ended_);
    auto *rest = builder.CreateAnd(lanes, builder.CreateNot(over));
    nested ? builder.CreateCondBr(code.lanes.any(rest), go, done) : builder.CreateBr(done);
    builder.SetInsertPoint(go);
    if (!nested)
        return lanes;
    auto *taking = builder.CreatePHI(lanes->getType(), 3, "taking");
    taking->addIncoming(lanes, from);
    taking->addIncoming(lanes, many);
    taking->addIncoming(rest, end);
    return taking;
}

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/jit/array_memory.h"

#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/MDBuilder.h>

namespace candela::codegen {

/// Bools are kept as integers: vectors of bits have no addressable elements.
static llvm::Type *scalarOf(const CodeFunction &code, const ir::Array &array) {
    return array.type == ir::Type::Float ? code.floatType : code.integerType;
}

llvm::Type *ArrayMemory::rowOf(const ir::Array &array) const {
    auto *scalar = scalarOf(code_, array);
    return array.uniformity == ir::Uniformity::Varying ? code_.lanes.varying(scalar) : scalar;
}

ArrayMemory::ArrayMemory(CodeFunction &code, ValueTable &values, RuntimeCalls &calls,
                         const TurnLimit &limit, ShaderArguments &arguments)
    : code_(code), builder_(code.builder), values_(values), calls_(calls), limit_(limit) {
    for (const ir::Array &array : values.function().arrays) {
        if (array.captured >= 0) {
            memory_.push_back(
                arguments.planeStart({offsetof(ShaderArgs, capturedArrays), array.captured}));
            continue;
        }
        auto *memory = builder_.CreateAlloca(llvm::ArrayType::get(rowOf(array), array.size));
        memory->setAlignment(llvm::Align(64));
        memory_.push_back(memory);
    }
}

void ArrayMemory::clear() {
    for (std::size_t k = 0; k < memory_.size(); ++k) {
        const ir::Array &array = values_.function().arrays[k];
        if (array.captured >= 0)
            continue;
        const auto row = code_.module.getDataLayout().getTypeAllocSize(rowOf(array));
        builder_.CreateMemSet(memory_[k], builder_.getInt8(0),
                              row.getFixedValue() * std::uint64_t(array.size), llvm::Align(64));
    }
}

void ArrayMemory::checkIndex(const ir::Instruction &i, Value *raw, Value *clamped) {
    auto *outside = builder_.CreateICmpNE(raw, clamped);
    if (auto *known = llvm::dyn_cast<llvm::Constant>(outside); known && known->isZeroValue())
        return;
    auto *lanes = limit_.running(code_.masks.currentAnd(code_.lanes.splat(outside)));
    auto *report = code_.block("index_outside"), *go = code_.block("index_clamped");
    builder_.CreateCondBr(code_.lanes.any(lanes), report, go,
                          llvm::MDBuilder(code_.module.getContext()).createUnlikelyBranchWeights());
    builder_.SetInsertPoint(report);
    calls_.reportIndexOutside(i);
    builder_.CreateBr(go);
    builder_.SetInsertPoint(go);
}

Value *ArrayMemory::elementAddress(const ir::Instruction &i, Value *&index) {
    const ir::Array &array = values_.function().arrays[i.immediate];
    auto *memory = memory_[i.immediate];
    auto *raw = values_.get(i.operands[0]);
    const auto whole = [&](int k) { return llvm::ConstantInt::get(raw->getType(), k); };
    index = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::smax, raw, whole(0));
    index = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::smin, index, whole(array.size - 1));
    checkIndex(i, raw, index);
    if (!index->getType()->isVectorTy())
        return builder_.CreateGEP(rowOf(array), memory, index);
    if (array.uniformity == ir::Uniformity::Varying)
        index = builder_.CreateAdd(
            builder_.CreateMul(index, code_.lanes.splat(builder_.getInt32(code_.lanes.width()))),
            code_.lanes.laneNumbers());
    return memory;
}

Value *ArrayMemory::load(const ir::Instruction &i) {
    const ir::Array &array = values_.function().arrays[i.immediate];
    Value *index = nullptr;
    auto *address = elementAddress(i, index);
    auto *row = rowOf(array);
    // Every index is inside, so all lanes may load.
    Value *element = index->getType()->isVectorTy()
                         ? code_.lanes.gather(scalarOf(code_, array), address, index,
                                              llvm::Constant::getAllOnesValue(
                                                  code_.lanes.varying(builder_.getInt1Ty())))
                         : builder_.CreateLoad(row, address);
    return array.type == ir::Type::Bool ? builder_.CreateIsNotNull(element) : element;
}

void ArrayMemory::store(const ir::Instruction &i) {
    const ir::Array &array = values_.function().arrays[i.immediate];
    Value *index = nullptr;
    auto *address = elementAddress(i, index);
    auto *value = values_.get(i.operands[1], array.uniformity);
    if (array.type == ir::Type::Bool)
        value = builder_.CreateZExt(value, rowOf(array));
    if (index->getType()->isVectorTy())
        code_.lanes.scatter(value, address, index, code_.masks.current());
    else
        storeRow(value, address);
}

void ArrayMemory::storeRow(Value *value, Value *to) {
    if (value->getType()->isVectorTy())
        value = builder_.CreateSelect(code_.masks.current(), value,
                                      builder_.CreateLoad(value->getType(), to));
    builder_.CreateStore(value, to);
}

ArrayMemory::KnownStores ArrayMemory::knownStores(std::span<const ir::Instruction> all) const {
    KnownStores known;
    const ir::Array &array = values_.function().arrays[all[0].immediate];
    if (array.type != ir::Type::Float)
        return known;
    const SpillArea *spills = values_.spills();
    for (const ir::Instruction &i : all) {
        if (i.op == ir::Op::Parameter && spills && spills->rowOfParameter(i.results[0]) >= 0) {
            ++known.instructions;
            continue;
        }
        if (i.op != ir::Op::ArrayStore || i.immediate != all[0].immediate)
            break;
        const auto *index = llvm::dyn_cast_or_null<llvm::ConstantInt>(values_.made(i.operands[0]));
        if (!index || index->getSExtValue() < 0 || index->getSExtValue() >= array.size)
            break;
        const int row = spills ? spills->rowOfParameter(i.operands[1]) : -1;
        const auto *number = llvm::dyn_cast_or_null<llvm::ConstantFP>(values_.made(i.operands[1]));
        if (row >= 0 && known.numbers.empty())
            known.rows.push_back(std::uint32_t(row));
        else if (number && known.rows.empty())
            known.numbers.push_back(number->getValueAPF().convertToFloat());
        else
            break;
        known.to.push_back(std::uint32_t(index->getZExtValue()));
        ++known.instructions;
    }
    return known;
}

std::size_t ArrayMemory::storeKnown(std::span<const ir::Instruction> all) {
    constexpr std::size_t fewest = 32;
    const KnownStores known = knownStores(all);
    if (known.to.size() < fewest)
        return 0;
    llvm::LLVMContext &context = code_.module.getContext();
    const ir::Array &array = values_.function().arrays[all[0].immediate];
    auto *memory = memory_[all[0].immediate];
    auto *row = rowOf(array);
    code_.repeat(int(known.to.size()), "elements", [&](Value *turn) {
        auto *to = code_.constantAt(llvm::ConstantDataArray::get(context, known.to), turn);
        Value *value = nullptr;
        if (known.rows.empty()) {
            value = code_.constantAt(llvm::ConstantDataArray::get(context, known.numbers), turn);
        } else {
            auto *from = code_.constantAt(llvm::ConstantDataArray::get(context, known.rows), turn);
            auto *varying = code_.lanes.varying(code_.floatType);
            value = code_.lanes.load(code_.floatType,
                                     builder_.CreateGEP(varying, values_.spills()->base(), from));
        }
        storeRow(row->isVectorTy() ? code_.lanes.splat(value) : value,
                 builder_.CreateGEP(row, memory, to));
    });
    return known.instructions;
}

} // namespace candela::codegen

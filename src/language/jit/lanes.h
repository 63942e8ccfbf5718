// SPDX-License-Identifier: Apache-2.0
// LLVM values by uniformity: uniform values are scalars; varying ones vectors of W lanes (at W = 1
// scalars too). Everything that depends on the width is decided here.
//
// Masks are vectors of bits where they are used, and kept as words as wide as the data from one
// block of code to another: AVX2 compares and selects by such words, and LLVM would hold bits in
// half of their width and widen them at every use. AVX-512 has registers for bits.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/code_target.h"

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/InlineAsm.h>

namespace candela::codegen {

class Lanes {
public:
    Lanes(llvm::IRBuilder<> &builder, const CodeTarget &target)
        : builder_(builder), width_(target.lanes()),
          hasMaskRegisters_(target.level == runtime::IsaLevel::V4),
          isOneRegister_(width_ <= runtime::registerLanes(target.level)) {}

    int width() const { return width_; }

    llvm::Type *scalarType(ir::Type type) const {
        if (type == ir::Type::Float)
            return builder_.getFloatTy();
        return type == ir::Type::Bool ? builder_.getInt1Ty() : builder_.getInt32Ty();
    }
    llvm::Type *varying(llvm::Type *scalar) const {
        return width_ == 1 ? scalar : llvm::FixedVectorType::get(scalar, width_);
    }
    llvm::Type *type(ir::Type type, ir::Uniformity uniformity) const {
        return uniformity == ir::Uniformity::Varying ? varying(scalarType(type)) : scalarType(type);
    }

    llvm::Value *splat(llvm::Value *value) const {
        if (width_ == 1 || value->getType()->isVectorTy())
            return value;
        return builder_.CreateVectorSplat(width_, value);
    }
    /// 0, 1, ... W-1.
    llvm::Value *laneNumbers() const {
        if (width_ == 1)
            return builder_.getInt32(0);
        llvm::SmallVector<llvm::Constant *, 16> numbers;
        for (int k = 0; k < width_; ++k)
            numbers.push_back(builder_.getInt32(k));
        return llvm::ConstantVector::get(numbers);
    }
    /// Lane k's bit as bit k of a W-bit integer.
    llvm::Value *bits(llvm::Value *mask) const {
        return width_ == 1 ? mask : builder_.CreateBitCast(mask, builder_.getIntNTy(width_));
    }
    /// A mask for use in other blocks of code; asMask() makes it one again.
    llvm::Value *kept(llvm::Value *mask) const {
        auto *type = varying(builder_.getInt32Ty());
        if (width_ == 1 || hasMaskRegisters_ || mask->getType() == type)
            return mask;
        if (llvm::isa<llvm::Constant>(mask))
            return builder_.CreateSExt(mask, type);
        auto *words = wordsOf(mask);
        if (isKeptAsMask(mask) || !isOneRegister_)
            return words;
        // No code: LLVM just may not know where the words come from, or it would keep bits.
        auto *opaque =
            llvm::InlineAsm::get(llvm::FunctionType::get(type, {type}, false), "", "=x,0", false);
        auto *call = builder_.CreateCall(opaque, {words});
        call->setDoesNotAccessMemory();
        call->setDoesNotThrow();
        call->addFnAttr(llvm::Attribute::WillReturn);
        return call;
    }
    llvm::Value *asMask(llvm::Value *kept) const {
        if (kept->getType() != varying(builder_.getInt32Ty()))
            return kept;
        return builder_.CreateICmpSLT(kept, llvm::Constant::getNullValue(kept->getType()));
    }
    /// From bits(), in an integer of 32 bits.
    llvm::Value *maskOf(llvm::Value *bits) const {
        auto *own = builder_.CreateTrunc(bits, builder_.getIntNTy(width_));
        if (width_ == 1)
            return own;
        if (hasMaskRegisters_)
            return builder_.CreateBitCast(own, varying(builder_.getInt1Ty()));
        llvm::SmallVector<llvm::Constant *, 16> single;
        for (int k = 0; k < width_; ++k)
            single.push_back(builder_.getInt32(1u << k));
        auto *chosen = builder_.CreateAnd(splat(bits), llvm::ConstantVector::get(single));
        return builder_.CreateICmpNE(chosen, llvm::Constant::getNullValue(chosen->getType()));
    }
    llvm::Value *any(llvm::Value *mask) const {
        if (width_ == 1)
            return mask;
        return builder_.CreateICmpNE(bits(mask), builder_.getIntN(width_, 0), "any");
    }
    llvm::Value *all(llvm::Value *mask) const {
        if (width_ == 1)
            return mask;
        return builder_.CreateICmpEQ(
            bits(mask), llvm::ConstantInt::getAllOnesValue(builder_.getIntNTy(width_)));
    }

    // Memory. At W = 1 a region runs only if its lane is active, so the mask is true.

    /// A whole plane block: safe for all lanes, as planes are padded.
    llvm::Value *load(llvm::Type *scalar, llvm::Value *from) const {
        return builder_.CreateAlignedLoad(varying(scalar), from, llvm::Align(4));
    }
    llvm::Value *maskedLoad(llvm::Type *scalar, llvm::Value *from, llvm::Value *mask) const {
        if (width_ == 1)
            return load(scalar, from);
        return builder_.CreateMaskedLoad(varying(scalar), from, llvm::Align(4), mask,
                                         llvm::Constant::getNullValue(varying(scalar)));
    }
    /// To a whole plane block.
    void store(llvm::Value *value, llvm::Value *to) const {
        builder_.CreateAlignedStore(value, to, llvm::Align(4));
    }
    /// Does maskedStore() cost more than store()?
    bool maskingCosts() const { return width_ > 1 && !hasMaskRegisters_; }
    /// Without masked stores (AVX2's are microcode) inactive lanes are written back as they were,
    /// which nobody sees: see ShaderArgs.
    void maskedStore(llvm::Value *value, llvm::Value *to, llvm::Value *mask) const {
        if (width_ > 1 && hasMaskRegisters_) {
            builder_.CreateMaskedStore(value, to, llvm::Align(4), mask);
            return;
        }
        if (width_ > 1)
            value = builder_.CreateSelect(mask, value, load(value->getType()->getScalarType(), to));
        store(value, to);
    }
    /// Is there one instruction for gather()?
    bool hasGathers() const { return hasMaskRegisters_; }
    /// base[index] lane by lane; index in elements, 32 bits. Inactive lanes give 0.
    llvm::Value *gather(llvm::Type *scalar, llvm::Value *base, llvm::Value *index,
                        llvm::Value *mask) const {
        llvm::Value *pointers = builder_.CreateGEP(scalar, base, index);
        if (width_ == 1)
            return load(scalar, pointers);
        return builder_.CreateMaskedGather(varying(scalar), pointers, llvm::Align(4), mask,
                                           llvm::Constant::getNullValue(varying(scalar)));
    }
    void scatter(llvm::Value *value, llvm::Value *base, llvm::Value *index,
                 llvm::Value *mask) const {
        llvm::Value *pointers = builder_.CreateGEP(value->getType()->getScalarType(), base, index);
        if (width_ == 1)
            builder_.CreateAlignedStore(value, pointers, llvm::Align(4));
        else
            builder_.CreateMaskedScatter(value, pointers, llvm::Align(4), mask);
    }

private:
    /// Is it what asMask() has made of kept words?
    static bool isKeptAsMask(llvm::Value *mask) {
        const auto *test = llvm::dyn_cast<llvm::ICmpInst>(mask);
        if (!test || test->getPredicate() != llvm::CmpInst::ICMP_SLT)
            return false;
        const auto *zero = llvm::dyn_cast<llvm::Constant>(test->getOperand(1));
        return zero && zero->isNullValue();
    }
    /// All bits of a lane's word as its bit of the mask. What is joined of kept masks is joined as
    /// words: made bits and words again, each of them would cost an instruction.
    llvm::Value *wordsOf(llvm::Value *mask) const {
        auto *type = varying(builder_.getInt32Ty());
        if (isKeptAsMask(mask))
            return llvm::cast<llvm::ICmpInst>(mask)->getOperand(0);
        auto *joined = llvm::dyn_cast<llvm::BinaryOperator>(mask);
        if (!joined || joined->getOpcode() != llvm::Instruction::And)
            return builder_.CreateSExt(mask, type);
        return builder_.CreateAnd(wordsOf(joined->getOperand(0)), wordsOf(joined->getOperand(1)));
    }

    llvm::IRBuilder<> &builder_;
    int width_;
    bool hasMaskRegisters_;
    bool isOneRegister_;
};

} // namespace candela::codegen

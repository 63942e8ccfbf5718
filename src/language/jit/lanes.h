// SPDX-License-Identifier: Apache-2.0
// LLVM values by rate: uniform values are scalars; varying ones vectors of W lanes (at W = 1
// scalars too). Everything that depends on the width is decided here.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/code_target.h"

#include <llvm/IR/IRBuilder.h>

namespace candela::codegen {

class Lanes {
public:
    Lanes(llvm::IRBuilder<> &builder, const CodeTarget &target)
        : builder_(builder), width_(target.width),
          masksStores_(target.level != runtime::IsaLevel::V2) {}

    int width() const { return width_; }

    llvm::Type *scalarType(ir::Type type) const {
        if (type == ir::Type::Float)
            return builder_.getFloatTy();
        return type == ir::Type::Bool ? builder_.getInt1Ty() : builder_.getInt32Ty();
    }
    llvm::Type *varying(llvm::Type *scalar) const {
        return width_ == 1 ? scalar : llvm::FixedVectorType::get(scalar, width_);
    }
    llvm::Type *type(ir::Type type, ir::Rate rate) const {
        return rate == ir::Rate::Varying ? varying(scalarType(type)) : scalarType(type);
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
    /// To a whole plane block. Without masked stores its inactive lanes are written back as they
    /// were, which nobody sees: a batch belongs to one thread.
    void maskedStore(llvm::Value *value, llvm::Value *to, llvm::Value *mask) const {
        if (width_ > 1 && masksStores_) {
            builder_.CreateMaskedStore(value, to, llvm::Align(4), mask);
            return;
        }
        if (width_ > 1)
            value = builder_.CreateSelect(mask, value, load(value->getType()->getScalarType(), to));
        builder_.CreateAlignedStore(value, to, llvm::Align(4));
    }
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
    llvm::IRBuilder<> &builder_;
    int width_;
    bool masksStores_;
};

} // namespace candela::codegen

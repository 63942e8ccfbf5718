// SPDX-License-Identifier: Apache-2.0
// The one owner of lane masks while code is generated. A mask says which lanes run the region
// under construction; each control construct narrows it and gives it back.
#pragma once

#include "language/jit/lanes.h"

#include <utility>
#include <vector>

namespace candela::codegen {

class MaskStack {
public:
    MaskStack(llvm::IRBuilder<> &builder, const Lanes &lanes) : builder_(builder), lanes_(lanes) {}

    /// The lanes that run now.
    llvm::Value *current() const { return lanes_.asMask(masks_.back()); }
    /// As an integer of 32 bits, lane 0 the lowest.
    llvm::Value *currentBits() const {
        return builder_.CreateZExt(lanes_.bits(current()), builder_.getInt32Ty());
    }
    /// Are these the lanes with which the machine function began, no control construct having
    /// narrowed them?
    bool isWhole() const { return masks_.size() == 1; }

    using Masks = std::vector<llvm::Value *>; ///< As they are kept, the narrowest last.
    /// From here on code stands in another machine function; gives the masks until now.
    Masks exchange(Masks masks) { return std::exchange(masks_, std::move(masks)); }

    llvm::Value *currentAnd(llvm::Value *test) const {
        return builder_.CreateAnd(current(), test, "mask");
    }
    llvm::Value *currentAndNot(llvm::Value *test) const {
        return builder_.CreateAnd(current(), builder_.CreateNot(test), "mask");
    }

    /// Makes `mask` current for its own lifetime.
    class Scope {
    public:
        Scope(MaskStack &stack, llvm::Value *mask) : stack_(stack) {
            stack_.masks_.push_back(stack_.lanes_.kept(mask));
        }
        ~Scope() { stack_.masks_.pop_back(); }
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        MaskStack &stack_;
    };

private:
    llvm::IRBuilder<> &builder_;
    const Lanes &lanes_;
    Masks masks_;
};

} // namespace candela::codegen

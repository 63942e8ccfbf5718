// SPDX-License-Identifier: Apache-2.0
// The one owner of lane masks while code is generated. A mask says which lanes run the region
// under construction; each control construct narrows it and gives it back.
#pragma once

#include <llvm/IR/IRBuilder.h>

#include <vector>

namespace candela::codegen {

class MaskStack {
public:
    explicit MaskStack(llvm::IRBuilder<> &builder) : builder_(builder) {}

    /// The lanes that run now.
    llvm::Value *current() const { return masks_.back(); }

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
            stack_.masks_.push_back(mask);
        }
        ~Scope() { stack_.masks_.pop_back(); }
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

    private:
        MaskStack &stack_;
    };

private:
    llvm::IRBuilder<> &builder_;
    std::vector<llvm::Value *> masks_;
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
// Function::strings as code has them: each is an integer, its offset in one text that holds all of
// them; equal texts agree.
#pragma once

#include "language/jit/code_function.h"

#include <map>
#include <string>
#include <vector>

namespace candela::codegen {

class ConstantStrings {
public:
    ConstantStrings(CodeFunction &code, const ir::Function &function) : code_(code) {
        std::map<std::string, int> offsets;
        for (const std::string &text : function.strings) {
            auto [known, isNew] = offsets.try_emplace(text, int(all_.size()));
            if (isNew)
                all_.append(text.c_str(), text.size() + 1);
            offset_.push_back(known->second);
        }
    }

    Value *value(int index) const {
        return code_.builder.getInt32(std::uint32_t(offset_[std::size_t(index)]));
    }
    /// Where offset 0 is.
    llvm::Constant *all() { return global(all_); }
    /// The address of these bytes and a 0.
    llvm::Constant *global(const std::string &bytes) {
        llvm::Constant *&known = globals_[bytes];
        if (!known)
            known = code_.builder.CreateGlobalStringPtr(bytes, "text", 0, &code_.module);
        return known;
    }

private:
    CodeFunction &code_;
    std::vector<int> offset_; ///< Of Function::strings.
    std::string all_;
    std::map<std::string, llvm::Constant *> globals_;
};

} // namespace candela::codegen

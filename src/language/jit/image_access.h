// SPDX-License-Identifier: Apache-2.0
// Filters: maps looked up and set, pixel loops run. In a pixel loop most places are whole pixels of
// one row, side by side: plain loads and stores. All others are the runtime's.
#pragma once

#include "language/jit/array_memory.h"

#include <map>

namespace candela::codegen {

class ImageAccess {
public:
    ImageAccess(CodeFunction &, ShaderArguments &, ValueTable &, const TurnLimit &,
                const ArrayMemory &);

    void load(const ir::Instruction &);
    void store(const ir::Instruction &);
    void runLoop(const ir::Instruction &);

private:
    /// Pixels of a row side by side, from the one that the block's first lane stands for.
    struct Row {
        Value *isPlain; ///< They are whole pixels, and lie in memory.
        Value *index;   ///< Of the first one, from pixel (0, 0) on.
    };
    struct Memory {
        Value *operands = nullptr, *results = nullptr;
    };
    const ir::ImageUse &use(const ir::Instruction &i) const;
    /// What a place along x is beyond the column of the pixel loop, if that is the same in all
    /// lanes; else null.
    Value *beyondColumn(ir::ValueId);
    Value *beyondColumnOfRow(const ir::Instruction &);
    Row row(const ir::Instruction &, Value *beyondColumn);
    Value *planeOf(const ir::Instruction &, int channel);
    bool isFirstChannel(const ir::Instruction &) const;
    Value *hasChannels(const ir::Instruction &);
    Value *takesRows(const ir::Instruction &);
    Value *isColorMap(const ir::Instruction &);
    Value *mapField(const ir::Instruction &, std::size_t offset, llvm::Type *);
    /// Where the first lane's pixel of a component stands.
    Value *pixels(const ir::Instruction &, const Row &, int component);
    Values placesInRow(const ir::Instruction &, const Row &);
    void storeRow(const ir::Instruction &, const Row &);
    Value *goesPastCaches(const ir::Instruction &, const Row &, Value *mask);
    void setRow(const ir::Instruction &, const Row &, int first, int end);
    /// Where the values are then.
    Values lookUpAnywhere(const ir::Instruction &, ir::Uniformity);
    void storeAnywhere(const ir::Instruction &, ir::Uniformity);
    /// Operands in rows of the runtime's.
    Value *putOperands(const ir::Instruction &, ir::Uniformity);
    const Memory &memory();
    Value *lanes(ir::Uniformity) const;

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ShaderArguments &arguments_;
    ValueTable &values_;
    const TurnLimit &limit_;
    const ArrayMemory &arrays_;
    std::vector<const ir::Instruction *> definitions_; ///< By ValueId; of plain arithmetic.
    std::size_t mostOperands_ = 1, mostResults_ = 1;
    // Of machine functions.
    std::map<llvm::Function *, Memory> memory_;
    std::map<std::pair<llvm::Function *, std::size_t>, Value *> fields_;
    std::map<std::pair<llvm::Function *, std::pair<int, int>>, Value *> planes_;
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/jit/spill_area.h"

namespace candela::codegen {

SpillArea::SpillArea(CodeFunction &code, const FunctionPieces &pieces)
    : code_(code), builder_(code.builder), pieces_(pieces),
      base_(code.entryMemory(code.lanes.varying(code.floatType), pieces.slots, "spill")),
      loaded_(pieces.slot.size()) {}

/// Masks are kept as wide as numbers: bits would have to be packed and unpacked.
static llvm::Type *typeInMemory(const CodeFunction &code, llvm::Type *type) {
    return type->isIntOrIntVectorTy(1) ? type->getWithNewType(code.integerType) : type;
}

static llvm::Function *functionOf(Value *value) {
    if (auto *argument = llvm::dyn_cast<llvm::Argument>(value))
        return argument->getParent();
    return llvm::cast<llvm::Instruction>(value)->getFunction();
}

Value *SpillArea::slot(ir::ValueId id, Value *base) {
    return builder_.CreateConstGEP1_64(code_.lanes.varying(code_.floatType), base,
                                       std::uint64_t(pieces_.slot[id]));
}

Value *SpillArea::here(ir::ValueId id, Value *made) {
    if (made && (llvm::isa<llvm::Constant>(made) || functionOf(made) == code_.function))
        return made;
    Loaded &loaded = loaded_[id];
    if (loaded.in != builder_.GetInsertBlock()) {
        auto *wanted = made ? made->getType() : code_.lanes.varying(code_.floatType);
        auto *type = typeInMemory(code_, wanted);
        Value *value = builder_.CreateAlignedLoad(type, slot(id, base_), llvm::Align(4));
        if (type != wanted)
            value = builder_.CreateTrunc(value, wanted);
        loaded = {builder_.GetInsertBlock(), value};
    }
    return loaded.value;
}

void SpillArea::store(ir::ValueId id, Value *made, Value *base) {
    auto *type = typeInMemory(code_, made->getType());
    auto *kept = type == made->getType() ? made : builder_.CreateSExt(made, type);
    builder_.CreateAlignedStore(kept, slot(id, base), llvm::Align(4));
}

void SpillArea::save(ir::ValueId id, Value *made) {
    if (pieces_.slot[id] < 0 || llvm::isa<llvm::Constant>(made))
        return;
    auto *phi = llvm::dyn_cast<llvm::PHINode>(made);
    llvm::BasicBlock *block = builder_.GetInsertBlock();
    // More phis may follow, which stand before all else.
    if (phi && phi->getParent() == block && llvm::isa<llvm::PHINode>(block->back()))
        postponed_.push_back({id, phi, base_});
    else
        store(id, made, base_);
}

void SpillArea::finish() {
    llvm::IRBuilder<>::InsertPointGuard guard(builder_);
    for (const Postponed &each : postponed_) {
        llvm::BasicBlock *block = each.phi->getParent();
        builder_.SetInsertPoint(block, block->getFirstInsertionPt());
        store(each.id, each.phi, each.base);
    }
}

} // namespace candela::codegen

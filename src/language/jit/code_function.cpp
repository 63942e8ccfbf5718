// SPDX-License-Identifier: Apache-2.0
#include "language/jit/code_function.h"

#include "language/runtime/shader_abi.h"

namespace candela::codegen {

static void setAttributes(llvm::Function &function, const CodeTarget &target) {
    function.addFnAttr("target-cpu", target.cpu);
    if (!target.features.empty())
        function.addFnAttr("target-features", target.features);
    // Without these LLVM may pass a vector of 16 in two halves where SLEEF expects it whole, and
    // lanes 8 to 15 are silently wrong.
    const std::string bits = std::to_string(target.registerBits());
    function.addFnAttr("prefer-vector-width", bits);
    function.addFnAttr("min-legal-vector-width", bits);
    function.addFnAttr(llvm::Attribute::NoUnwind);
    // ShaderArgs come first.
    function.addParamAttr(0, llvm::Attribute::NoAlias);
    function.addParamAttr(0, llvm::Attribute::ReadOnly);
    function.addDereferenceableParamAttr(0, sizeof(ShaderArgs));
}

CodeFunction::CodeFunction(const CodeTarget &codeTarget, llvm::Module &codeModule,
                           const std::string &symbol)
    : target(codeTarget), module(codeModule), builder(codeModule.getContext()),
      lanes(builder, codeTarget), masks(builder, lanes), floatType(builder.getFloatTy()),
      integerType(builder.getInt32Ty()), pointerType(builder.getPtrTy()) {
    auto *type = llvm::FunctionType::get(builder.getVoidTy(), {pointerType}, false);
    function = llvm::Function::Create(type, llvm::Function::ExternalLinkage, symbol, module);
    setAttributes(*function, target);
    builder.SetInsertPoint(block("entry"));
}

llvm::Function *CodeFunction::addPiece(llvm::ArrayRef<llvm::Type *> arguments) {
    auto *type = llvm::FunctionType::get(builder.getVoidTy(), arguments, false);
    auto *piece = llvm::Function::Create(type, llvm::Function::InternalLinkage, "piece", module);
    setAttributes(*piece, target);
    piece->addFnAttr(llvm::Attribute::NoInline);
    return piece;
}

llvm::BasicBlock *CodeFunction::block(const char *name) {
    return llvm::BasicBlock::Create(module.getContext(), name, function);
}

Values CodeFunction::valuesIf(Value *condition, const char *name,
                              const std::function<Values()> &body, const Values &otherwise) {
    auto *from = builder.GetInsertBlock();
    auto *run = block(name), *join = block("join");
    builder.CreateCondBr(condition, run, join);
    builder.SetInsertPoint(run);
    Values made = body();
    for (Value *&value : made)
        if (value->getType() == lanes.varying(builder.getInt1Ty()))
            value = lanes.kept(value);
    auto *end = builder.GetInsertBlock();
    builder.CreateBr(join);
    builder.SetInsertPoint(join);
    Values merged;
    for (std::size_t k = 0; k < made.size(); ++k) {
        auto *type = made[k]->getType();
        auto *phi = builder.CreatePHI(type, 2);
        phi->addIncoming(otherwise.empty() ? llvm::Constant::getNullValue(type) : otherwise[k],
                         from);
        phi->addIncoming(made[k], end);
        merged.push_back(phi);
    }
    return merged;
}

void CodeFunction::repeat(int count, const char *name,
                          const std::function<void(Value *turn)> &body) {
    auto *from = builder.GetInsertBlock();
    auto *loop = block(name), *done = block("done");
    builder.CreateBr(loop);
    builder.SetInsertPoint(loop);
    auto *turn = builder.CreatePHI(integerType, 2);
    turn->addIncoming(builder.getInt32(0), from);
    body(turn);
    auto *next = builder.CreateAdd(turn, builder.getInt32(1));
    turn->addIncoming(next, builder.GetInsertBlock());
    builder.CreateCondBr(builder.CreateICmpSLT(next, builder.getInt32(std::uint32_t(count))), loop,
                         done);
    builder.SetInsertPoint(done);
}

Value *CodeFunction::constantAt(llvm::Constant *table, Value *index) {
    auto *global = new llvm::GlobalVariable(module, table->getType(), true,
                                            llvm::GlobalValue::PrivateLinkage, table, "table");
    global->setUnnamedAddr(llvm::GlobalValue::UnnamedAddr::Global);
    auto *element = table->getType()->getArrayElementType();
    return invariantLoad(element, builder.CreateGEP(element, global, index));
}

Value *CodeFunction::entryMemory(llvm::Type *type, int count, const char *name) {
    llvm::BasicBlock &entry = function->getEntryBlock();
    llvm::IRBuilder<> atEntry(&entry, entry.begin());
    auto *memory = atEntry.CreateAlloca(type, atEntry.getInt32(count), name);
    memory->setAlignment(llvm::Align(64));
    return memory;
}

Value *CodeFunction::invariantLoad(llvm::Type *type, Value *from) {
    auto *load = builder.CreateLoad(type, from);
    load->setMetadata(llvm::LLVMContext::MD_invariant_load,
                      llvm::MDNode::get(module.getContext(), {}));
    return load;
}

llvm::FunctionCallee CodeFunction::external(const std::string &name, llvm::FunctionType *type,
                                            bool pure) {
    auto callee = module.getOrInsertFunction(name, type);
    auto *declared = llvm::cast<llvm::Function>(callee.getCallee());
    declared->setDoesNotThrow();
    if (pure) {
        declared->setDoesNotAccessMemory();
        declared->addFnAttr(llvm::Attribute::WillReturn);
    }
    return callee;
}

} // namespace candela::codegen

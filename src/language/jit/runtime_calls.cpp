// SPDX-License-Identifier: Apache-2.0
#include "language/jit/runtime_calls.h"

#include "language/jit/runtime_symbols.h"

namespace candela::codegen {

using ir::Rate;

RuntimeCalls::RuntimeCalls(CodeFunction &code, const ShaderArguments &arguments, ValueTable &values)
    : code_(code), builder_(code.builder), arguments_(arguments), values_(values) {
    std::map<std::string, int> offsets;
    for (const std::string &text : values.function().strings) {
        auto [known, isNew] = offsets.try_emplace(text, int(strings_.size()));
        if (isNew)
            strings_.append(text.c_str(), text.size() + 1);
        stringOffset_.push_back(known->second);
    }
}

Value *RuntimeCalls::string(int index) const { return builder_.getInt32(stringOffset_[index]); }

Value *RuntimeCalls::text(const std::string &bytes) {
    return builder_.CreateGlobalStringPtr(bytes, "text", 0, &code_.module);
}

/// What LLVM may assume of a runtime function: it reads its inputs and writes its outputs.
static void setRuntimeAttributes(llvm::Function &function) {
    function.setOnlyAccessesArgMemory();
    function.addFnAttr(llvm::Attribute::WillReturn);
    for (unsigned k = 0; k < 2; ++k) {
        function.addParamAttr(k, llvm::Attribute::NoCapture);
        function.addParamAttr(k, llvm::Attribute::NoAlias);
    }
    function.addParamAttr(0, llvm::Attribute::ReadOnly);
    function.addParamAttr(1, llvm::Attribute::WriteOnly);
}

void RuntimeCalls::call(const ir::Instruction &i) {
    const Rate rate = values_.rate(i.results[0]);
    const int width = rate == Rate::Varying ? code_.lanes.width() : 1;
    auto *type = code_.lanes.type(ir::Type::Float, rate);
    auto &[inputs, outputs] = callMemory_[code_.function];
    if (!inputs) {
        auto *widest = code_.lanes.varying(code_.floatType);
        inputs = code_.entryMemory(widest, runtime::maxRuntimeInputs, "call_inputs");
        outputs = code_.entryMemory(widest, runtime::maxRuntimeOutputs, "call_outputs");
    }
    for (std::size_t k = 0; k < i.operands.size(); ++k)
        builder_.CreateStore(values_.get(i.operands[k], rate),
                             builder_.CreateConstGEP1_64(type, inputs, k));
    auto *pointer = code_.pointerType;
    auto *signature = llvm::FunctionType::get(builder_.getVoidTy(), {pointer, pointer}, false);
    auto callee = code_.external(runtimeSymbol(i.immediate, width), signature, false);
    setRuntimeAttributes(*llvm::cast<llvm::Function>(callee.getCallee()));
    builder_.CreateCall(callee, {inputs, outputs});
    for (std::size_t k = 0; k < i.results.size(); ++k)
        values_.set(i.results[k],
                    builder_.CreateLoad(type, builder_.CreateConstGEP1_64(type, outputs, k)));
}

/// candela_print(args, strings, types, operand count, cells, width, active lanes): all lanes'
/// operands in one block; the renderer's side formats them lane by lane.
void RuntimeCalls::print(const ir::Instruction &i) {
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    auto *row = code_.lanes.varying(integer);
    auto *cells = code_.entryMemory(row, int(i.operands.size()), "print_cells");
    std::string types;
    for (std::size_t k = 0; k < i.operands.size(); ++k) {
        const ir::Type type = values_.function().values[i.operands[k]].type;
        types += type == ir::Type::Float ? 'f' : type == ir::Type::String ? 's' : 'i';
        auto *value = values_.get(i.operands[k], Rate::Varying);
        value = type == ir::Type::Float  ? builder_.CreateBitCast(value, row)
                : type == ir::Type::Bool ? builder_.CreateZExt(value, row)
                                         : value;
        builder_.CreateStore(value, builder_.CreateConstGEP1_64(row, cells, k));
    }
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(), {pointer, pointer, pointer, integer, pointer, integer, integer},
        false);
    auto *active = builder_.CreateZExt(code_.lanes.bits(code_.masks.current()), integer);
    builder_.CreateCall(code_.external(printSymbol, signature, false),
                        {arguments_.pointer(), text(strings_), text(types),
                         builder_.getInt32(std::uint32_t(types.size())), cells,
                         builder_.getInt32(std::uint32_t(code_.lanes.width())), active});
}

void RuntimeCalls::reportIndexOutside(const ir::Instruction &i) { report(indexOutsideSymbol, i); }

void RuntimeCalls::reportLoopEnded(const ir::Instruction &i) { report(loopEndedSymbol, i); }

/// symbol(args, file, line).
void RuntimeCalls::report(const char *symbol, const ir::Instruction &i) {
    auto *pointer = code_.pointerType;
    auto *signature =
        llvm::FunctionType::get(builder_.getVoidTy(), {pointer, pointer, code_.integerType}, false);
    const std::vector<std::string> &files = values_.function().files;
    const std::string file = files.empty() ? "" : files[i.file];
    auto *call = builder_.CreateCall(
        code_.external(symbol, signature, false),
        {arguments_.pointer(), text(file), builder_.getInt32(std::uint32_t(i.line))});
    call->addFnAttr(llvm::Attribute::Cold);
}

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/jit/runtime_calls.h"

#include "language/jit/runtime_symbols.h"

namespace candela::codegen {

using ir::Uniformity;

RuntimeCalls::RuntimeCalls(CodeFunction &code, const ShaderArguments &arguments, ValueTable &values,
                           ConstantStrings &strings, const FunctionPieces &pieces)
    : code_(code), builder_(code.builder), arguments_(arguments), values_(values),
      strings_(strings) {
    pair(values.function().body, pieces);
}

void RuntimeCalls::pair(const ir::Region &region, const FunctionPieces &pieces) {
    const std::span<const ir::Instruction> body = region.body;
    if (const auto cut = pieces.cut.find(&region); cut == pieces.cut.end())
        pair(body);
    else
        for (const Piece &piece : cut->second)
            pair(body.subspan(piece.begin, piece.end - piece.begin));
    for (const ir::Instruction &i : body)
        for (const ir::Region &inner : i.regions)
            pair(inner, pieces);
}

void RuntimeCalls::pair(std::span<const ir::Instruction> together) {
    using Key = std::pair<int, std::vector<ir::ValueId>>;
    std::map<Key, const ir::Instruction *> calls;
    for (const ir::Instruction &i : together)
        if (i.op == ir::Op::Call)
            calls.emplace(Key(i.immediate, i.operands), &i);
    for (const auto &[key, plain] : calls)
        if (const auto slopes = runtime::withSlopes(runtime::RuntimeFunction(key.first)))
            if (auto found = calls.find({int(*slopes), key.second}); found != calls.end())
                withSlopes_[plain] = found->second;
}

/// A function of one output depends on its arguments alone; the others write to their last one.
llvm::FunctionCallee RuntimeCalls::runtimeFunction(const ir::Instruction &i, llvm::Type *type) {
    const bool several = i.results.size() > 1;
    std::vector<llvm::Type *> types(i.operands.size(), type);
    if (several)
        types.push_back(code_.pointerType);
    const int width = type->isVectorTy() ? code_.lanes.width() : 1;
    auto callee = code_.external(runtimeSymbol(i.immediate, width),
                                 llvm::FunctionType::get(type, types, false), !several);
    if (several) {
        auto &declared = *llvm::cast<llvm::Function>(callee.getCallee());
        const unsigned last = unsigned(types.size()) - 1;
        declared.setOnlyAccessesArgMemory();
        declared.addFnAttr(llvm::Attribute::WillReturn);
        declared.addParamAttr(last, llvm::Attribute::NoCapture);
        declared.addParamAttr(last, llvm::Attribute::NoAlias);
        declared.addParamAttr(last, llvm::Attribute::WriteOnly);
    }
    return callee;
}

/// Results are set where their own instruction stands, never sooner: only from there on their spill
/// slots are theirs.
void RuntimeCalls::call(const ir::Instruction &i) {
    const auto paired = withSlopes_.find(&i);
    const ir::Instruction &asked = paired == withSlopes_.end() ? i : *paired->second;
    Values &given = evaluated_[&asked];
    if (given.empty())
        given = evaluate(asked);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        values_.set(i.results[k], given[k]);
}

Values RuntimeCalls::evaluate(const ir::Instruction &i) {
    const Uniformity uniformity = values_.uniformity(i.results[0]);
    auto *type = code_.lanes.type(ir::Type::Float, uniformity);
    Values arguments = values_.get(i.operands, uniformity);
    if (i.results.size() == 1)
        return {builder_.CreateCall(runtimeFunction(i, type), arguments)};
    Value *&others = callMemory_[code_.function];
    if (!others)
        others = code_.entryMemory(code_.lanes.varying(code_.floatType),
                                   runtime::maxRuntimeOutputs - 1, "call_outputs");
    arguments.push_back(others);
    Values given{builder_.CreateCall(runtimeFunction(i, type), arguments)};
    for (std::size_t k = 1; k < i.results.size(); ++k)
        given.push_back(
            builder_.CreateLoad(type, builder_.CreateConstGEP1_64(type, others, k - 1)));
    return given;
}

Value *RuntimeCalls::goesOn() {
    auto *signature = llvm::FunctionType::get(builder_.getInt1Ty(), {code_.pointerType}, false);
    return builder_.CreateCall(code_.external(goesOnSymbol, signature, false),
                               {arguments_.pointer()});
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
        {arguments_.pointer(), strings_.global(file), builder_.getInt32(std::uint32_t(i.line))});
    call->addFnAttr(llvm::Attribute::Cold);
}

} // namespace candela::codegen

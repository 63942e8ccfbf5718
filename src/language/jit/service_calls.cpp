// SPDX-License-Identifier: Apache-2.0
#include "language/jit/service_calls.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/jit/runtime_symbols.h"

#include <algorithm>

namespace candela::codegen {

using ir::Uniformity;

ServiceCalls::ServiceCalls(CodeFunction &code, const ShaderArguments &arguments, ValueTable &values,
                           ConstantStrings &strings)
    : code_(code), builder_(code.builder), arguments_(arguments), values_(values),
      strings_(strings) {
    ir::forEachInstruction(values.function().body, [&](const ir::Instruction &i) {
        if (!ir::isService(i.op))
            return;
        mostOperands_ = std::max(mostOperands_, i.operands.size());
        mostResults_ = std::max(mostResults_, i.results.size());
    });
}

const ServiceCalls::Memory &ServiceCalls::memory() {
    Memory &own = memory_[code_.function];
    if (!own.operands) {
        own.operands = code_.entryMemory(code_.lanes.varying(code_.integerType),
                                         std::max(1, int(mostOperands_)), "service_operands");
        own.results = code_.entryMemory(code_.lanes.varying(code_.floatType),
                                        std::max(1, int(mostResults_)), "service_results");
    }
    return own;
}

std::string ServiceCalls::typesOf(const ir::Instruction &i) const {
    std::string types;
    for (ir::ValueId v : i.operands) {
        const ir::Type type = values_.function().values[v].type;
        types += type == ir::Type::Float ? 'f' : type == ir::Type::String ? 's' : 'i';
    }
    return types;
}

llvm::Constant *ServiceCalls::texts(const ir::ServiceUse &use) {
    std::vector<llvm::Constant *> all;
    for (int text : use.texts)
        all.push_back(text == ir::ServiceUse::atRunTime
                          ? llvm::Constant::getNullValue(code_.pointerType)
                          : strings_.global(values_.function().strings[std::size_t(text)]));
    auto *type = llvm::ArrayType::get(code_.pointerType, all.size());
    return new llvm::GlobalVariable(code_.module, type, true, llvm::GlobalValue::PrivateLinkage,
                                    llvm::ConstantArray::get(type, all), "texts");
}

static_assert(offsetof(ServiceSite, name) == 0 && offsetof(ServiceSite, service) == 8 &&
              offsetof(ServiceSite, operandCount) == 12 &&
              offsetof(ServiceSite, resultCount) == 16 && offsetof(ServiceSite, line) == 20 &&
              offsetof(ServiceSite, file) == 24 && offsetof(ServiceSite, texts) == 32 &&
              offsetof(ServiceSite, types) == 40 && offsetof(ServiceSite, strings) == 48 &&
              sizeof(ServiceSite) == 56);

Value *ServiceCalls::site(const ir::Instruction &i) {
    const ir::Function &function = values_.function();
    const ir::ServiceUse &use = serviceOf(function, i);
    const std::string types = typesOf(i);
    const auto number = [&](auto n) { return builder_.getInt32(std::uint32_t(n)); };
    const std::string file = function.files.empty() ? "" : function.files[std::size_t(i.file)];
    llvm::Constant *fields[] = {strings_.global(use.info->name),
                                number(use.info->service),
                                number(i.operands.size()),
                                number(use.results),
                                number(i.line),
                                strings_.global(file),
                                texts(use),
                                strings_.global(types),
                                types.find('s') == std::string::npos ? strings_.global("")
                                                                     : strings_.all()};
    auto *value = llvm::ConstantStruct::getAnon(fields);
    return new llvm::GlobalVariable(code_.module, value->getType(), true,
                                    llvm::GlobalValue::PrivateLinkage, value, "site");
}

void ServiceCalls::storeOperands(const ir::Instruction &i, Uniformity uniformity, Value *to) {
    auto *row = code_.lanes.type(ir::Type::Integer, uniformity);
    for (std::size_t k = 0; k < i.operands.size(); ++k) {
        const ir::Type type = values_.function().values[i.operands[k]].type;
        auto *value = values_.get(i.operands[k], uniformity);
        value = type == ir::Type::Float  ? builder_.CreateBitCast(value, row)
                : type == ir::Type::Bool ? builder_.CreateZExt(value, row)
                                         : value;
        code_.lanes.store(value, builder_.CreateConstGEP1_64(row, to, k));
    }
}

void ServiceCalls::ask(const ir::Instruction &i) {
    // A command is for each lane, though all give it the same.
    const Uniformity uniformity =
        i.op == ir::Op::Query ? values_.uniformity(i.results[0]) : Uniformity::Varying;
    const Memory &own = memory();
    storeOperands(i, uniformity, own.operands);
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(), {pointer, pointer, pointer, pointer, integer, integer, integer},
        false);
    const int lanes = uniformity == Uniformity::Varying ? code_.lanes.width() : 1;
    builder_.CreateCall(code_.external(serviceSymbol, signature, false),
                        {arguments_.pointer(), site(i), own.operands, own.results,
                         arguments_.firstPoint(), builder_.getInt32(std::uint32_t(lanes)),
                         code_.masks.currentBits()});
    auto *row = code_.lanes.type(ir::Type::Float, uniformity);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        values_.set(i.results[k],
                    builder_.CreateAlignedLoad(
                        row, builder_.CreateConstGEP1_64(row, own.results, k), llvm::Align(4)));
}

} // namespace candela::codegen

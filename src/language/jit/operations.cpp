// SPDX-License-Identifier: Apache-2.0
// FunctionGenerator: operations without regions.
#include "language/jit/function_generator.h"

#include "foundation/units/color.h"
#include "language/runtime/runtime_functions.h"

#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/MDBuilder.h>

#include <cstddef>

namespace candela {

using ir::Instruction;
using ir::Op;
using ir::Rate;
using runtime::MathFunction;

std::string runtimeSymbol(int runtimeFunction, int width) {
    const auto facts = runtime::info(runtime::RuntimeFunction(runtimeFunction));
    return std::string("candela_") + facts.name + "_w" + std::to_string(width);
}

// Small tools.

FunctionGenerator::Value *FunctionGenerator::get(ir::ValueId id, Rate wanted) {
    return wanted == Rate::Varying ? lanes_.splat(values_[id]) : values_[id];
}

FunctionGenerator::Values FunctionGenerator::get(const std::vector<ir::ValueId> &ids, Rate wanted) {
    Values result;
    for (ir::ValueId id : ids)
        result.push_back(get(id, wanted));
    return result;
}

void FunctionGenerator::set(ir::ValueId id, Value *value) {
    values_[id] = rate(id) == Rate::Varying ? lanes_.splat(value) : value;
}

FunctionGenerator::Value *FunctionGenerator::constantLoad(llvm::Type *type, Value *from) {
    auto *load = builder_.CreateLoad(type, from);
    load->setMetadata(llvm::LLVMContext::MD_invariant_load,
                      llvm::MDNode::get(module_.getContext(), {}));
    return load;
}

FunctionGenerator::Value *FunctionGenerator::field(std::size_t offset, llvm::Type *type) {
    return constantLoad(type, builder_.CreateConstGEP1_64(builder_.getInt8Ty(), args_, offset));
}

FunctionGenerator::Value *FunctionGenerator::fieldPointer(std::size_t offset) {
    return field(offset, pointer_);
}

FunctionGenerator::Value *FunctionGenerator::planeBlock(std::size_t tableField, int index) {
    Value *&plane = planes_[{tableField, index}];
    if (!plane) {
        llvm::IRBuilder<>::InsertPointGuard guard(builder_);
        builder_.SetInsertPoint(prepare_->getTerminator());
        auto *entry =
            builder_.CreateConstGEP1_64(pointer_, fieldPointer(tableField), std::uint64_t(index));
        plane = constantLoad(pointer_, entry);
    }
    return builder_.CreateGEP(float_, plane, base_);
}

FunctionGenerator::Value *FunctionGenerator::planeBlockHere(std::size_t tableField, int index) {
    auto *entry =
        builder_.CreateConstGEP1_64(pointer_, fieldPointer(tableField), std::uint64_t(index));
    return builder_.CreateGEP(float_, constantLoad(pointer_, entry), base_);
}

FunctionGenerator::Value *FunctionGenerator::entryAlloca(llvm::Type *type, int count,
                                                         const char *name) {
    llvm::BasicBlock &entry = code_->getEntryBlock();
    llvm::IRBuilder<> atEntry(&entry, entry.begin());
    auto *memory = atEntry.CreateAlloca(type, atEntry.getInt32(count), name);
    memory->setAlignment(llvm::Align(64));
    return memory;
}

llvm::BasicBlock *FunctionGenerator::block(const char *name) {
    return llvm::BasicBlock::Create(module_.getContext(), name, code_);
}

llvm::FunctionCallee FunctionGenerator::external(const std::string &name, llvm::FunctionType *type,
                                                 bool pure) {
    auto callee = module_.getOrInsertFunction(name, type);
    auto *function = llvm::cast<llvm::Function>(callee.getCallee());
    function->setDoesNotThrow();
    if (pure) {
        function->setDoesNotAccessMemory();
        function->addFnAttr(llvm::Attribute::WillReturn);
    }
    return callee;
}

FunctionGenerator::Value *FunctionGenerator::globalText(const std::string &bytes) {
    return builder_.CreateGlobalStringPtr(bytes, "text", 0, &module_);
}

FunctionGenerator::Value *FunctionGenerator::like(Value *model, float number) {
    return llvm::ConstantFP::get(model->getType(), double(number));
}

FunctionGenerator::Value *FunctionGenerator::intrinsic(unsigned id, Value *a) {
    return builder_.CreateUnaryIntrinsic(llvm::Intrinsic::ID(id), a);
}

// Dispatch.

void FunctionGenerator::emit(const Instruction &i) {
    if (i.op >= Op::Add && i.op <= Op::Pow)
        set(i.results[0], emitFloat(i));
    else if (i.op >= Op::If && i.op <= Op::LightLoop)
        emitControl(i);
    else if (!emitSource(i) && !emitLogic(i))
        emitRest(i);
}

bool FunctionGenerator::emitSource(const Instruction &i) {
    const auto give = [&](Value *value) {
        set(i.results[0], value);
        return true;
    };
    switch (i.op) {
    case Op::ConstFloat:
        return give(llvm::ConstantFP::get(module_.getContext(), llvm::APFloat(i.number)));
    case Op::ConstBool: return give(builder_.getInt1(i.immediate != 0));
    case Op::ConstInteger: return give(builder_.getInt32(i.immediate));
    case Op::ConstString: return give(builder_.getInt32(stringOffset_[i.immediate]));
    case Op::Input:
        return give(lanes_.load(float_, planeBlock(offsetof(ShaderArgs, inputs), i.immediate)));
    case Op::Variable:
        return give(lanes_.load(float_, planeBlock(offsetof(ShaderArgs, variables), i.immediate)));
    case Op::Parameter: return give(parameters_.at(i.immediate));
    case Op::Space:
    case Op::SpaceInverse: loadMatrix(i, i.op == Op::SpaceInverse); return true;
    case Op::Object:
    case Op::ObjectInverse:
        for (int k = 0; k < 16; ++k)
            set(i.results[k], objectElements_.at(k + (i.op == Op::ObjectInverse ? 16 : 0)));
        return true;
    case Op::Random: return give(randomNumber(i.immediate));
    case Op::FrameLoad: return give(lanes_.load(float_, frameAddress(i.immediate)));
    case Op::AnsweredRequest: {
        auto *plane = builder_.CreateGEP(
            integer_, fieldPointer(offsetof(ShaderArgs, answeredRequest)), base_);
        auto *answered = lanes_.maskedLoad(integer_, plane, masks_.current());
        return give(builder_.CreateICmpEQ(answered, lanes_.splat(builder_.getInt32(i.immediate))));
    }
    case Op::CategoryAccepts: return give(acceptedByCategory(i.immediate, base_));
    default: return false;
    }
}

void FunctionGenerator::loadMatrix(const Instruction &i, bool inverse) {
    auto *table = fieldPointer(offsetof(ShaderArgs, spaces));
    auto *matrix =
        constantLoad(pointer_, builder_.CreateConstGEP1_64(pointer_, table, i.immediate));
    for (int k = 0; k < 16; ++k)
        set(i.results[k], constantLoad(float_, builder_.CreateConstGEP1_64(
                                                   float_, matrix, k + (inverse ? 16 : 0))));
}

/// As ir::randomNumber().
FunctionGenerator::Value *FunctionGenerator::randomNumber(int immediate) {
    auto *h =
        lanes_.load(integer_, planeBlock(offsetof(ShaderArgs, inputs), int(ShaderInput::seed)));
    const auto number = [&](std::uint32_t k) { return lanes_.splat(builder_.getInt32(k)); };
    const auto shifted = [&](int by) { return builder_.CreateXor(h, builder_.CreateLShr(h, by)); };
    h = builder_.CreateAdd(h, number(std::uint32_t(immediate) * 0x9e3779b9u));
    h = builder_.CreateMul(shifted(16), number(0x7feb352du));
    h = builder_.CreateMul(shifted(15), number(0x846ca68bu));
    h = builder_.CreateLShr(shifted(16), 8);
    auto *whole = builder_.CreateSIToFP(h, lanes_.varying(float_));
    return builder_.CreateFMul(whole, like(whole, 0x1p-24f));
}

// Arithmetic.

FunctionGenerator::Value *FunctionGenerator::emitFloat(const Instruction &i) {
    const Rate rate = resultRate(i);
    auto *a = get(i.operands[0], rate), *b = get(i.operands.back(), rate);
    auto &make = builder_;
    switch (i.op) {
    case Op::Add: return make.CreateFAdd(a, b);
    case Op::Sub: return make.CreateFSub(a, b);
    case Op::Mul: return make.CreateFMul(a, b);
    case Op::Div: return make.CreateFDiv(a, b);
    case Op::Neg: return make.CreateFNeg(a);
    case Op::Abs: return intrinsic(llvm::Intrinsic::fabs, a);
    case Op::Min: return make.CreateSelect(make.CreateFCmpOLT(a, b), a, b);
    case Op::Max: return make.CreateSelect(make.CreateFCmpOGT(a, b), a, b);
    case Op::Floor: return intrinsic(llvm::Intrinsic::floor, a);
    case Op::Ceil: return intrinsic(llvm::Intrinsic::ceil, a);
    case Op::Round: return intrinsic(llvm::Intrinsic::floor, make.CreateFAdd(a, like(a, 0.5f)));
    case Op::Sqrt:
        return make.CreateSelect(make.CreateFCmpOLT(a, like(a, 0)), like(a, 0),
                                 intrinsic(llvm::Intrinsic::sqrt, a));
    default: return emitTranscendental(i.op, a, b);
    }
}

FunctionGenerator::Value *FunctionGenerator::emitTranscendental(Op op, Value *a, Value *b) {
    switch (op) {
    case Op::Asin: return callMath(MathFunction::asin, {clampToUnit(a)});
    case Op::Acos: return callMath(MathFunction::acos, {clampToUnit(a)});
    case Op::Atan2: return callMath(MathFunction::atan2, {a, b});
    case Op::Pow: return power(a, b);
    case Op::Sin: return callMath(MathFunction::sin, {a});
    case Op::Cos: return callMath(MathFunction::cos, {a});
    case Op::Tan: return callMath(MathFunction::tan, {a});
    case Op::Atan: return callMath(MathFunction::atan, {a});
    case Op::Exp: return callMath(MathFunction::exp, {a});
    default: return callMath(MathFunction::log, {a});
    }
}

FunctionGenerator::Value *FunctionGenerator::clampToUnit(Value *x) {
    auto *least = builder_.CreateSelect(builder_.CreateFCmpOGT(x, like(x, -1)), x, like(x, -1));
    return builder_.CreateSelect(builder_.CreateFCmpOLT(least, like(x, 1)), least, like(x, 1));
}

/// As runtime::pow(): 0 for a negative base and an exponent that is no integer.
FunctionGenerator::Value *FunctionGenerator::power(Value *base, Value *exponent) {
    auto *negative = builder_.CreateFCmpOLT(base, like(base, 0));
    auto *whole = intrinsic(llvm::Intrinsic::floor, exponent);
    auto *fractional = builder_.CreateFCmpUNE(exponent, whole);
    return builder_.CreateSelect(builder_.CreateAnd(negative, fractional), like(base, 0),
                                 callMath(MathFunction::pow, {base, exponent}));
}

/// A uniform argument calls the scalar code; a varying one the vector code, as often as the
/// level's registers need.
FunctionGenerator::Value *FunctionGenerator::callMath(MathFunction function,
                                                      const Values &arguments) {
    const bool isVector = arguments[0]->getType()->isVectorTy();
    const auto code = isVector ? runtime::vectorMath(function, target_.level)
                               : runtime::scalarMath(function, target_.level);
    llvm::Type *type = isVector ? llvm::FixedVectorType::get(float_, code.width) : float_;
    const std::vector<llvm::Type *> types(arguments.size(), type);
    auto callee = external(code.name, llvm::FunctionType::get(type, types, false), true);
    if (!isVector || code.width == lanes_.width())
        return builder_.CreateCall(callee, arguments);
    Values parts;
    for (int first = 0; first < lanes_.width(); first += code.width) {
        llvm::SmallVector<int, 16> piece;
        for (int k = 0; k < code.width; ++k)
            piece.push_back(first + k);
        Values pieces;
        for (Value *argument : arguments)
            pieces.push_back(builder_.CreateShuffleVector(argument, piece));
        parts.push_back(builder_.CreateCall(callee, pieces));
    }
    while (parts.size() > 1) {
        llvm::SmallVector<int, 16> joined;
        const int size =
            int(llvm::cast<llvm::FixedVectorType>(parts[0]->getType())->getNumElements());
        for (int k = 0; k < 2 * size; ++k)
            joined.push_back(k);
        Values wider;
        for (std::size_t k = 0; k < parts.size(); k += 2)
            wider.push_back(builder_.CreateShuffleVector(parts[k], parts[k + 1], joined));
        parts = wider;
    }
    return parts[0];
}

bool FunctionGenerator::emitLogic(const Instruction &i) {
    const auto operand = [&](int k) { return get(i.operands[k], resultRate(i)); };
    const auto give = [&](Value *value) {
        set(i.results[0], value);
        return true;
    };
    auto &make = builder_;
    switch (i.op) {
    case Op::Less: return give(make.CreateFCmpOLT(operand(0), operand(1)));
    case Op::LessEqual: return give(make.CreateFCmpOLE(operand(0), operand(1)));
    case Op::Equal: return give(make.CreateFCmpOEQ(operand(0), operand(1)));
    case Op::NotEqual: return give(make.CreateFCmpUNE(operand(0), operand(1)));
    case Op::StringEqual: return give(make.CreateICmpEQ(operand(0), operand(1)));
    case Op::And: return give(make.CreateAnd(operand(0), operand(1)));
    case Op::Or: return give(make.CreateOr(operand(0), operand(1)));
    case Op::Not: return give(make.CreateNot(operand(0)));
    case Op::Select: return give(make.CreateSelect(operand(0), operand(1), operand(2)));
    case Op::FloatFromBool:
        return give(make.CreateUIToFP(operand(0), lanes_.type(ir::Type::Float, resultRate(i))));
    case Op::IntegerFromFloat:
        return give(make.CreateIntrinsic(
            llvm::Intrinsic::fptosi_sat,
            {lanes_.type(ir::Type::Integer, resultRate(i)), operand(0)->getType()}, {operand(0)}));
    default: return false;
    }
}

// Memory, calls, effects.

void FunctionGenerator::emitRest(const Instruction &i) {
    const auto giveColor = [&](const Values &color) {
        for (std::size_t k = 0; k < i.results.size(); ++k)
            set(i.results[k], color[k]);
    };
    switch (i.op) {
    case Op::ArrayLoad: return set(i.results[0], loadElement(i));
    case Op::ArrayStore: return storeElement(i);
    case Op::Call: return emitCall(i);
    case Op::Answer:
        return giveColor(loadColor(offsetof(ShaderArgs, answers), i.immediate * colorSamples));
    case Op::Ambient: return giveColor(loadColor(offsetof(ShaderArgs, ambient), 0));
    case Op::Irradiance: return giveColor(loadColor(offsetof(ShaderArgs, irradiance), 0));
    case Op::Output:
        return lanes_.maskedStore(get(i.operands[0], Rate::Varying),
                                  planeBlock(offsetof(ShaderArgs, outputs), i.immediate),
                                  masks_.current());
    case Op::FrameStore: {
        auto *value = get(i.operands[0], Rate::Varying);
        if (value->getType()->isIntOrIntVectorTy())
            value = builder_.CreateUIToFP(value, lanes_.varying(float_));
        return lanes_.maskedStore(value, frameAddress(i.immediate), masks_.current());
    }
    case Op::Print: return emitPrint(i);
    default: return;
    }
}

FunctionGenerator::Value *FunctionGenerator::frameAddress(int slot) {
    auto *group = builder_.CreateSExt(builder_.CreateLShr(base_, 4), builder_.getInt64Ty());
    auto *lane = builder_.CreateSExt(builder_.CreateAnd(base_, 15), builder_.getInt64Ty());
    auto *row =
        builder_.CreateAdd(builder_.CreateMul(group, builder_.getInt64(function_.frameSlots)),
                           builder_.getInt64(slot));
    auto *index = builder_.CreateAdd(builder_.CreateMul(row, builder_.getInt64(16)), lane);
    return builder_.CreateGEP(float_, fieldPointer(offsetof(ShaderArgs, frame)), index);
}

FunctionGenerator::Values FunctionGenerator::loadColor(std::size_t tableField, int first) {
    auto *table = fieldPointer(tableField);
    auto *from = builder_.GetInsertBlock();
    auto *load = block("load_color"), *join = block("color");
    builder_.CreateCondBr(builder_.CreateIsNull(table), join, load);
    builder_.SetInsertPoint(load);
    Values loaded, color;
    for (int k = 0; k < colorSamples; ++k)
        loaded.push_back(lanes_.load(float_, planeBlockHere(tableField, first + k)));
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    for (Value *channel : loaded) {
        auto *phi = builder_.CreatePHI(channel->getType(), 2);
        phi->addIncoming(llvm::Constant::getNullValue(channel->getType()), from);
        phi->addIncoming(channel, load);
        color.push_back(phi);
    }
    return color;
}

void FunctionGenerator::emitCall(const Instruction &i) {
    const Rate rate = resultRate(i);
    const int width = rate == Rate::Varying ? lanes_.width() : 1;
    auto *type = rate == Rate::Varying ? lanes_.varying(float_) : float_;
    if (!callInputs_) {
        auto *widest = lanes_.varying(float_);
        callInputs_ = entryAlloca(widest, runtime::maxRuntimeInputs, "call_inputs");
        callOutputs_ = entryAlloca(widest, runtime::maxRuntimeOutputs, "call_outputs");
    }
    for (std::size_t k = 0; k < i.operands.size(); ++k)
        builder_.CreateStore(get(i.operands[k], rate),
                             builder_.CreateConstGEP1_64(type, callInputs_, k));
    auto *signature = llvm::FunctionType::get(builder_.getVoidTy(), {pointer_, pointer_}, false);
    auto callee = external(runtimeSymbol(i.immediate, width), signature, false);
    auto *function = llvm::cast<llvm::Function>(callee.getCallee());
    function->setOnlyAccessesArgMemory();
    function->addFnAttr(llvm::Attribute::WillReturn);
    for (unsigned k = 0; k < 2; ++k) {
        function->addParamAttr(k, llvm::Attribute::NoCapture);
        function->addParamAttr(k, llvm::Attribute::NoAlias);
    }
    function->addParamAttr(0, llvm::Attribute::ReadOnly);
    function->addParamAttr(1, llvm::Attribute::WriteOnly);
    builder_.CreateCall(callee, {callInputs_, callOutputs_});
    for (std::size_t k = 0; k < i.results.size(); ++k)
        set(i.results[k],
            builder_.CreateLoad(type, builder_.CreateConstGEP1_64(type, callOutputs_, k)));
}

/// candela_print(args, strings, types, operand count, cells, width, active lanes): all lanes'
/// operands in one block; the renderer's side formats them lane by lane.
void FunctionGenerator::emitPrint(const Instruction &i) {
    auto *row = lanes_.varying(integer_);
    auto *cells = entryAlloca(row, int(i.operands.size()), "print_cells");
    std::string types;
    for (std::size_t k = 0; k < i.operands.size(); ++k) {
        const ir::Type type = function_.values[i.operands[k]].type;
        types += type == ir::Type::Float ? 'f' : type == ir::Type::String ? 's' : 'i';
        auto *value = get(i.operands[k], Rate::Varying);
        value = type == ir::Type::Float  ? builder_.CreateBitCast(value, row)
                : type == ir::Type::Bool ? builder_.CreateZExt(value, row)
                                         : value;
        builder_.CreateStore(value, builder_.CreateConstGEP1_64(row, cells, k));
    }
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(),
        {pointer_, pointer_, pointer_, integer_, pointer_, integer_, integer_}, false);
    auto *active = builder_.CreateZExt(lanes_.bits(masks_.current()), integer_);
    builder_.CreateCall(external(printSymbol, signature, false),
                        {args_, globalText(stringBlob_), globalText(types),
                         builder_.getInt32(std::uint32_t(types.size())), cells,
                         builder_.getInt32(std::uint32_t(lanes_.width())), active});
}

/// candela_index_outside(args, file, line) if an active lane's index had to be clamped.
void FunctionGenerator::emitIndexCheck(const Instruction &i, Value *raw, Value *clamped) {
    auto *outside = builder_.CreateICmpNE(raw, clamped);
    if (auto *known = llvm::dyn_cast<llvm::Constant>(outside); known && known->isZeroValue())
        return;
    auto *lanes = masks_.currentAnd(lanes_.splat(outside));
    auto *report = block("index_outside"), *go = block("index_clamped");
    builder_.CreateCondBr(lanes_.any(lanes), report, go,
                          llvm::MDBuilder(module_.getContext()).createUnlikelyBranchWeights());
    builder_.SetInsertPoint(report);
    auto *signature =
        llvm::FunctionType::get(builder_.getVoidTy(), {pointer_, pointer_, integer_}, false);
    const std::string file = function_.files.empty() ? "" : function_.files[i.file];
    auto *call =
        builder_.CreateCall(external(indexOutsideSymbol, signature, false),
                            {args_, globalText(file), builder_.getInt32(std::uint32_t(i.line))});
    call->addFnAttr(llvm::Attribute::Cold);
    builder_.CreateBr(go);
    builder_.SetInsertPoint(go);
}

/// For an index that varies: the array's start, and `index` becomes each lane's element. For a
/// uniform one: the row of all lanes.
FunctionGenerator::Value *FunctionGenerator::elementAddress(const Instruction &i, Value *&index) {
    const ir::Array &array = function_.arrays[i.immediate];
    auto *raw = values_[i.operands[0]];
    const auto whole = [&](int k) { return llvm::ConstantInt::get(raw->getType(), k); };
    index = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::smax, raw, whole(0));
    index = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::smin, index, whole(array.size - 1));
    emitIndexCheck(i, raw, index);
    if (!index->getType()->isVectorTy()) {
        auto *rows = arrays_[i.immediate]->getAllocatedType()->getArrayElementType();
        return builder_.CreateGEP(rows, arrays_[i.immediate], index);
    }
    if (array.rate == Rate::Varying)
        index = builder_.CreateAdd(
            builder_.CreateMul(index, lanes_.splat(builder_.getInt32(lanes_.width()))),
            lanes_.laneNumbers());
    return arrays_[i.immediate];
}

FunctionGenerator::Value *FunctionGenerator::loadElement(const Instruction &i) {
    const ir::Array &array = function_.arrays[i.immediate];
    Value *index = nullptr;
    auto *address = elementAddress(i, index);
    auto *scalar = array.type == ir::Type::Float ? float_ : integer_;
    auto *row = arrays_[i.immediate]->getAllocatedType()->getArrayElementType();
    // Every index is inside, so all lanes may load.
    Value *element =
        index->getType()->isVectorTy()
            ? lanes_.gather(scalar, address, index,
                            llvm::Constant::getAllOnesValue(lanes_.varying(builder_.getInt1Ty())))
            : builder_.CreateLoad(row, address);
    return array.type == ir::Type::Bool ? builder_.CreateIsNotNull(element) : element;
}

void FunctionGenerator::storeElement(const Instruction &i) {
    const ir::Array &array = function_.arrays[i.immediate];
    Value *index = nullptr;
    auto *address = elementAddress(i, index);
    auto *value = get(i.operands[1], array.rate);
    auto *row = arrays_[i.immediate]->getAllocatedType()->getArrayElementType();
    if (array.type == ir::Type::Bool)
        value = builder_.CreateZExt(value, row);
    if (index->getType()->isVectorTy())
        lanes_.scatter(value, address, index, masks_.current());
    else if (!value->getType()->isVectorTy())
        builder_.CreateStore(value, address);
    else
        builder_.CreateStore(
            builder_.CreateSelect(masks_.current(), value, builder_.CreateLoad(row, address)),
            address);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The frame about a shader's body, and control flow.
#include "language/jit/function_generator.h"

#include "foundation/units/color.h"

#include <llvm/IR/Intrinsics.h>

#include <cstddef>

namespace candela {

using ir::Instruction;
using ir::Op;
using ir::Rate;
using ir::Region;

FunctionGenerator::FunctionGenerator(const ir::Function &function, const CodeTarget &target,
                                     llvm::Module &module)
    : function_(function), target_(target), module_(module), builder_(module.getContext()),
      lanes_(builder_, target), masks_(builder_), values_(function.values.size()),
      float_(builder_.getFloatTy()), integer_(builder_.getInt32Ty()),
      pointer_(builder_.getPtrTy()) {
    std::map<std::string, int> offsets;
    for (const std::string &text : function.strings) {
        auto [known, isNew] = offsets.try_emplace(text, int(stringBlob_.size()));
        if (isNew)
            stringBlob_.append(text.c_str(), text.size() + 1);
        stringOffset_.push_back(known->second);
    }
}

void FunctionGenerator::generate(const std::string &symbol) {
    declare(symbol);
    collectGathers(function_.body);
    makeArrays();
    generateBlocks();
}

void FunctionGenerator::declare(const std::string &symbol) {
    auto *type = llvm::FunctionType::get(builder_.getVoidTy(), {pointer_}, false);
    code_ = llvm::Function::Create(type, llvm::Function::ExternalLinkage, symbol, module_);
    code_->addFnAttr("target-cpu", target_.cpu);
    if (!target_.features.empty())
        code_->addFnAttr("target-features", target_.features);
    // Without these LLVM may pass a vector of 16 in two halves where SLEEF expects it whole, and
    // lanes 8 to 15 are silently wrong.
    const std::string bits = std::to_string(target_.registerBits());
    code_->addFnAttr("prefer-vector-width", bits);
    code_->addFnAttr("min-legal-vector-width", bits);
    code_->addFnAttr(llvm::Attribute::NoUnwind);
    args_ = code_->getArg(0);
    code_->addParamAttr(0, llvm::Attribute::NoAlias);
    code_->addParamAttr(0, llvm::Attribute::ReadOnly);
    code_->addDereferenceableParamAttr(0, sizeof(ShaderArgs));
    builder_.SetInsertPoint(block("entry"));
}

void FunctionGenerator::makeArrays() {
    for (const ir::Array &array : function_.arrays) {
        // Bools are kept as integers: vectors of bits have no addressable elements.
        auto *scalar = array.type == ir::Type::Float ? float_ : integer_;
        auto *element = array.rate == Rate::Varying ? lanes_.varying(scalar) : scalar;
        auto *memory = builder_.CreateAlloca(llvm::ArrayType::get(element, array.size));
        memory->setAlignment(llvm::Align(64));
        arrays_.push_back(memory);
    }
}

void FunctionGenerator::clearArrays() {
    for (llvm::AllocaInst *array : arrays_) {
        const auto size = module_.getDataLayout().getTypeAllocSize(array->getAllocatedType());
        builder_.CreateMemSet(array, builder_.getInt8(0), size.getFixedValue(), llvm::Align(64));
    }
}

void FunctionGenerator::generateBlocks() {
    auto *count = field(offsetof(ShaderArgs, count), integer_);
    prepare_ = block("prepare");
    auto *head = block("block"), *body = block("body"), *next = block("next"),
         *done = block("done");
    builder_.CreateCondBr(builder_.CreateICmpSGT(count, builder_.getInt32(0)), prepare_, done);
    builder_.SetInsertPoint(prepare_);
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    auto *base = builder_.CreatePHI(integer_, 2, "base");
    base->addIncoming(builder_.getInt32(0), prepare_);
    base_ = base;
    auto *number = builder_.CreateAdd(lanes_.splat(base), lanes_.laneNumbers());
    auto *inside = builder_.CreateICmpSLT(number, lanes_.splat(count));
    auto *mask = builder_.CreateAnd(inside, blockMask(), "full_mask");
    builder_.CreateCondBr(lanes_.any(mask), body, next);

    builder_.SetInsertPoint(body);
    {
        MaskStack::Scope scope(masks_, mask);
        clearArrays();
        preloadGathers();
        emitRegion(function_.body);
    }
    builder_.CreateBr(next);

    builder_.SetInsertPoint(next);
    auto *nextBase = builder_.CreateAdd(base, builder_.getInt32(lanes_.width()));
    base->addIncoming(nextBase, next);
    builder_.CreateCondBr(builder_.CreateICmpSLT(nextBase, count), head, done);

    builder_.SetInsertPoint(done);
    builder_.CreateRetVoid();
}

/// The caller's mask for the lanes of this block; all lanes if there is none.
FunctionGenerator::Value *FunctionGenerator::blockMask() {
    auto *word = builder_.getInt16Ty();
    auto *given = fieldPointer(offsetof(ShaderArgs, active));
    auto *from = builder_.GetInsertBlock();
    auto *load = block("load_mask"), *join = block("join_mask");
    builder_.CreateCondBr(builder_.CreateIsNull(given), join, load);
    builder_.SetInsertPoint(load);
    auto *index = builder_.CreateLShr(base_, 4);
    auto *loaded = constantLoad(word, builder_.CreateGEP(word, given, index));
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    auto *bits = builder_.CreatePHI(word, 2);
    bits->addIncoming(llvm::ConstantInt::getAllOnesValue(word), from);
    bits->addIncoming(loaded, load);
    if (lanes_.width() == 16)
        return builder_.CreateBitCast(bits, lanes_.varying(builder_.getInt1Ty()));
    auto *lane = builder_.CreateTrunc(builder_.CreateAnd(base_, 15), word);
    return builder_.CreateTrunc(builder_.CreateLShr(bits, lane), builder_.getInt1Ty());
}

void FunctionGenerator::collectGathers(const Region &region) {
    for (const Instruction &i : region.body) {
        if (i.op == Op::Parameter)
            parametersUsed_.insert(i.immediate);
        for (int k = 0; k < 16 && (i.op == Op::Object || i.op == Op::ObjectInverse); ++k)
            objectElementsUsed_.insert(k + (i.op == Op::ObjectInverse ? 16 : 0));
        for (const Region &inner : i.regions)
            collectGathers(inner);
    }
}

void FunctionGenerator::preloadGathers() {
    preload(parametersUsed_, parameters_, offsetof(ShaderArgs, parameters),
            offsetof(ShaderArgs, parameterOffset), 1);
    preload(objectElementsUsed_, objectElements_, offsetof(ShaderArgs, objectMatrices),
            offsetof(ShaderArgs, objectIndex), 32);
}

/// Parameters and object matrices stand at a per-lane index, but mostly all lanes of a block share
/// one: then they are loaded once and broadcast.
void FunctionGenerator::preload(const std::set<int> &used, std::map<int, Value *> &loaded,
                                std::size_t baseField, std::size_t indexField, int scale) {
    if (used.empty())
        return;
    auto *mask = masks_.current();
    auto *base = fieldPointer(baseField);
    auto *indexPlane = builder_.CreateGEP(integer_, fieldPointer(indexField), base_);
    auto *raw = lanes_.maskedLoad(integer_, indexPlane, mask);
    auto *index = builder_.CreateMul(raw, lanes_.splat(builder_.getInt32(scale)));
    const auto shared = [&](Value *origin, int k) {
        auto *element = builder_.CreateGEP(float_, origin, builder_.getInt32(k));
        return lanes_.splat(constantLoad(float_, element));
    };
    if (lanes_.width() == 1) {
        for (int k : used)
            loaded[k] = shared(builder_.CreateGEP(float_, base, index), k);
        return;
    }
    auto *firstLane = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::cttz, lanes_.bits(mask),
                                                     builder_.getTrue());
    auto *first = builder_.CreateExtractElement(index, firstLane);
    auto *same = builder_.CreateICmpEQ(index, lanes_.splat(first));
    auto *together = block("together"), *apart = block("apart"), *join = block("gathered");
    builder_.CreateCondBr(lanes_.all(builder_.CreateOr(same, builder_.CreateNot(mask))), together,
                          apart);
    Values broadcast, gathered;
    builder_.SetInsertPoint(together);
    auto *origin = builder_.CreateGEP(float_, base, first);
    for (int k : used)
        broadcast.push_back(shared(origin, k));
    builder_.CreateBr(join);
    builder_.SetInsertPoint(apart);
    for (int k : used)
        gathered.push_back(lanes_.gather(
            float_, builder_.CreateGEP(float_, base, builder_.getInt32(k)), index, mask));
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    std::size_t next = 0;
    for (int k : used) {
        auto *phi = builder_.CreatePHI(lanes_.varying(float_), 2);
        phi->addIncoming(broadcast[next], together);
        phi->addIncoming(gathered[next++], apart);
        loaded[k] = phi;
    }
}

void FunctionGenerator::emitRegion(const Region &region) {
    for (const Instruction &i : region.body)
        emit(i);
}

void FunctionGenerator::emitControl(const Instruction &i) {
    if (i.op == Op::LightLoop)
        emitLightLoop(i);
    else if (i.op == Op::Loop)
        emitLoop(i);
    else if (rate(i.operands[0]) == Rate::Uniform)
        emitUniformIf(i);
    else
        emitIf(i);
}

/// Few plain operations: cheaper to run than to branch about.
static bool isTrivial(const Region &region) {
    if (region.body.size() > 6)
        return false;
    for (const Instruction &i : region.body) {
        const bool plain = i.op <= Op::ConstString || (i.op >= Op::Add && i.op <= Op::Round) ||
                           (i.op >= Op::Less && i.op <= Op::FloatFromBool);
        if (!plain)
            return false;
    }
    return true;
}

/// Runs a branch of a varying If in the `taken` lanes, skipping it if there is none. Returns what
/// it yields, meaningless in other lanes.
FunctionGenerator::Values FunctionGenerator::emitBranch(const Region &region, Value *taken,
                                                        const Instruction &owner) {
    MaskStack::Scope scope(masks_, taken);
    const auto yields = [&] {
        Values result;
        for (std::size_t k = 0; k < region.yields.size(); ++k)
            result.push_back(get(region.yields[k], rate(owner.results[k])));
        return result;
    };
    if (isTrivial(region)) {
        emitRegion(region);
        return yields();
    }
    auto *from = builder_.GetInsertBlock();
    auto *run = block("lanes"), *join = block("join_lanes");
    builder_.CreateCondBr(lanes_.any(taken), run, join);
    builder_.SetInsertPoint(run);
    emitRegion(region);
    const Values yielded = yields();
    auto *end = builder_.GetInsertBlock();
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    Values merged;
    for (Value *value : yielded) {
        auto *phi = builder_.CreatePHI(value->getType(), 2);
        phi->addIncoming(llvm::Constant::getNullValue(value->getType()), from);
        phi->addIncoming(value, end);
        merged.push_back(phi);
    }
    return merged;
}

void FunctionGenerator::emitIf(const Instruction &i) {
    auto *condition = get(i.operands[0], Rate::Varying);
    const Values then = emitBranch(i.regions[0], masks_.currentAnd(condition), i);
    const Values otherwise = emitBranch(i.regions[1], masks_.currentAndNot(condition), i);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        set(i.results[k], builder_.CreateSelect(condition, then[k], otherwise[k]));
}

void FunctionGenerator::emitUniformIf(const Instruction &i) {
    auto *condition = get(i.operands[0], Rate::Uniform);
    llvm::BasicBlock *starts[2] = {block("then"), block("else")};
    auto *join = block("endif");
    builder_.CreateCondBr(condition, starts[0], starts[1]);
    llvm::BasicBlock *ends[2];
    Values yields[2];
    for (int branch = 0; branch < 2; ++branch) {
        builder_.SetInsertPoint(starts[branch]);
        emitRegion(i.regions[branch]);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            yields[branch].push_back(get(i.regions[branch].yields[k], rate(i.results[k])));
        ends[branch] = builder_.GetInsertBlock();
        builder_.CreateBr(join);
    }
    builder_.SetInsertPoint(join);
    for (std::size_t k = 0; k < i.results.size(); ++k) {
        auto *phi = builder_.CreatePHI(yields[0][k]->getType(), 2);
        for (int branch = 0; branch < 2; ++branch)
            phi->addIncoming(yields[branch][k], ends[branch]);
        set(i.results[k], phi);
    }
}

/// A varying loop goes on until no lane is active; a lane that has finished keeps its values. A
/// uniform one is a plain loop.
void FunctionGenerator::emitLoop(const Instruction &i) {
    const Region &region = i.regions[0];
    const bool varying = rate(region.arguments[0]) == Rate::Varying;
    Values initial;
    for (std::size_t k = 0; k < i.operands.size(); ++k)
        initial.push_back(get(i.operands[k], rate(region.arguments[k])));
    auto *from = builder_.GetInsertBlock();
    auto *head = block("loop"), *body = block("loop_body"), *done = block("loop_end");
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    std::vector<llvm::PHINode *> carried;
    for (std::size_t k = 0; k < initial.size(); ++k) {
        carried.push_back(builder_.CreatePHI(initial[k]->getType(), 2));
        carried[k]->addIncoming(initial[k], from);
        set(region.arguments[k], carried[k]);
    }
    auto *mask = varying ? masks_.currentAnd(carried[0]) : masks_.current();
    auto *goesOn = varying ? lanes_.any(mask) : carried[0];
    builder_.CreateCondBr(goesOn, body, done);

    builder_.SetInsertPoint(body);
    MaskStack::Scope scope(masks_, mask);
    emitRegion(region);
    for (std::size_t k = 0; k < carried.size(); ++k) {
        auto *next = get(region.yields[k], rate(region.arguments[k]));
        if (varying && rate(region.arguments[k]) == Rate::Varying)
            next = builder_.CreateSelect(mask, next, carried[k]);
        carried[k]->addIncoming(next, builder_.GetInsertBlock());
    }
    builder_.CreateBr(head);

    builder_.SetInsertPoint(done);
    for (std::size_t k = 0; k < carried.size(); ++k)
        set(i.results[k], carried[k]);
}

FunctionGenerator::Value *FunctionGenerator::dot(const Values &a, const Values &b) {
    auto *two =
        builder_.CreateFAdd(builder_.CreateFMul(a[0], b[0]), builder_.CreateFMul(a[1], b[1]));
    return builder_.CreateFAdd(two, builder_.CreateFMul(a[2], b[2]));
}

/// As ir::normalize: a zero vector stays zero.
FunctionGenerator::Values FunctionGenerator::normalized(const Values &a) {
    auto *size = intrinsic(llvm::Intrinsic::sqrt, dot(a, a));
    auto *isZero = builder_.CreateFCmpOEQ(size, like(size, 0));
    auto *divisor = builder_.CreateSelect(isZero, like(size, 1), size);
    auto *inverse = builder_.CreateFDiv(like(size, 1), divisor);
    Values result;
    for (Value *component : a)
        result.push_back(builder_.CreateFMul(component, inverse));
    return result;
}

FunctionGenerator::Value *FunctionGenerator::anyNonZero(const Values &color) {
    Value *any = nullptr;
    for (Value *channel : color) {
        auto *nonZero = builder_.CreateFCmpUNE(channel, like(channel, 0));
        any = any ? builder_.CreateOr(any, nonZero) : nonZero;
    }
    return any;
}

FunctionGenerator::LightLoopPlan FunctionGenerator::planLightLoop(const Instruction &i) {
    LightLoopPlan plan{&function_.requests[i.immediate], nullptr, {}, nullptr};
    if (plan.request->form == ir::ConeForm::Everywhere || plan.request->coneCount == 0)
        return plan;
    auto *angle = get(i.operands[6], Rate::Varying);
    if (plan.request->form == ir::ConeForm::Extended) {
        plan.delta = builder_.CreateFCmpOLE(angle, like(angle, 0));
        if (auto *known = llvm::dyn_cast<llvm::Constant>(plan.delta); known && known->isZeroValue())
            plan.delta = nullptr;
        return plan;
    }
    plan.coneAxis = normalized(get({i.operands[3], i.operands[4], i.operands[5]}, Rate::Varying));
    plan.coneCosine = callMath(runtime::MathFunction::cos, {angle});
    return plan;
}

/// Delta requests see their own traced answer, along their first axis.
FunctionGenerator::LightSample FunctionGenerator::deltaSample(const Instruction &i,
                                                              const LightLoopPlan &plan) {
    LightSample sample;
    sample.L = get({i.operands[3], i.operands[4], i.operands[5]}, Rate::Varying);
    sample.Cl = loadColor(offsetof(ShaderArgs, answers), i.immediate * colorSamples);
    sample.lanes = builder_.CreateAnd(masks_.currentAnd(plan.delta), anyNonZero(sample.Cl));
    return sample;
}

FunctionGenerator::LightSample FunctionGenerator::finiteSample(const LightLoopPlan &plan,
                                                               Value *sampleNumber) {
    auto *stride = builder_.CreateSExt(field(offsetof(ShaderArgs, sampleStride), integer_),
                                       builder_.getInt64Ty());
    auto *row = builder_.CreateAdd(
        builder_.CreateMul(builder_.CreateSExt(sampleNumber, builder_.getInt64Ty()), stride),
        builder_.CreateSExt(base_, builder_.getInt64Ty()));
    auto *mask = masks_.current();
    const auto loadRow = [&](std::size_t table, int k) {
        auto *plane = constantLoad(
            pointer_, builder_.CreateGEP(pointer_, fieldPointer(table), builder_.getInt32(k)));
        return lanes_.maskedLoad(float_, builder_.CreateGEP(float_, plane, row), mask);
    };
    LightSample sample;
    for (int k = 0; k < 3; ++k)
        sample.L.push_back(loadRow(offsetof(ShaderArgs, sampleL), k));
    for (int k = 0; k < colorSamples; ++k)
        sample.Cl.push_back(loadRow(offsetof(ShaderArgs, sampleCl), k));
    sample.lanes = builder_.CreateAnd(mask, anyNonZero(sample.Cl));
    if (plan.delta)
        sample.lanes = builder_.CreateAnd(sample.lanes, builder_.CreateNot(plan.delta));
    if (plan.coneCosine) {
        auto *cosine = dot(normalized(sample.L), plan.coneAxis);
        sample.lanes =
            builder_.CreateAnd(sample.lanes, builder_.CreateFCmpOGE(cosine, plan.coneCosine));
    }
    if (plan.request->category >= 0)
        sample.lanes =
            builder_.CreateAnd(sample.lanes, acceptedByCategory(plan.request->category, row));
    return sample;
}

/// categoryAccepts[category * (lightCount + 1) + light] != 0, lane by lane.
FunctionGenerator::Value *FunctionGenerator::acceptedByCategory(int category, Value *row) {
    auto *maskType = lanes_.varying(builder_.getInt1Ty());
    auto *accepts = fieldPointer(offsetof(ShaderArgs, categoryAccepts));
    auto *start = builder_.GetInsertBlock();
    auto *test = block("category"), *load = block("lights"), *look = block("accepts"),
         *join = block("accepted");
    builder_.CreateCondBr(builder_.CreateIsNull(accepts), join, test);

    builder_.SetInsertPoint(test);
    auto *lights = fieldPointer(offsetof(ShaderArgs, sampleLight));
    auto *noLights = llvm::Constant::getNullValue(lanes_.varying(integer_));
    builder_.CreateCondBr(builder_.CreateIsNull(lights), look, load);
    builder_.SetInsertPoint(load);
    auto *loaded =
        lanes_.maskedLoad(integer_, builder_.CreateGEP(integer_, lights, row), masks_.current());
    builder_.CreateBr(look);

    builder_.SetInsertPoint(look);
    auto *light = builder_.CreatePHI(lanes_.varying(integer_), 2);
    light->addIncoming(noLights, test);
    light->addIncoming(loaded, load);
    auto *lightCount = field(offsetof(ShaderArgs, lightCount), integer_);
    auto *firstOfCategory = builder_.CreateMul(builder_.CreateAdd(lightCount, builder_.getInt32(1)),
                                               builder_.getInt32(category));
    auto *bytes = builder_.CreateGEP(builder_.getInt8Ty(), accepts, firstOfCategory);
    // Inactive lanes look at light 0, so a byte a lane may be read without branches.
    const auto byteOf = [&](Value *index) -> Value * {
        auto *address = builder_.CreateGEP(builder_.getInt8Ty(), bytes, index);
        return builder_.CreateIsNotNull(constantLoad(builder_.getInt8Ty(), address));
    };
    Value *result = llvm::PoisonValue::get(maskType);
    for (int k = 0; k < lanes_.width(); ++k)
        result = lanes_.width() == 1
                     ? byteOf(light)
                     : builder_.CreateInsertElement(
                           result, byteOf(builder_.CreateExtractElement(light, k)), k);
    auto *end = builder_.GetInsertBlock();
    builder_.CreateBr(join);

    builder_.SetInsertPoint(join);
    auto *accepted = builder_.CreatePHI(maskType, 2);
    accepted->addIncoming(llvm::Constant::getAllOnesValue(maskType), start);
    accepted->addIncoming(result, end);
    return accepted;
}

/// The loop's sample number `sample`; number -1 is the delta request's.
FunctionGenerator::LightSample
FunctionGenerator::nextSample(const Instruction &i, const LightLoopPlan &plan, Value *sample) {
    if (!plan.delta)
        return finiteSample(plan, sample);
    auto *delta = block("delta"), *finite = block("finite"), *join = block("sample");
    builder_.CreateCondBr(builder_.CreateICmpSLT(sample, builder_.getInt32(0)), delta, finite);
    builder_.SetInsertPoint(delta);
    const LightSample fromDelta = deltaSample(i, plan);
    delta = builder_.GetInsertBlock();
    builder_.CreateBr(join);
    builder_.SetInsertPoint(finite);
    const LightSample fromFinite = finiteSample(plan, sample);
    finite = builder_.GetInsertBlock();
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    const auto merge = [&](Value *a, Value *b) {
        auto *phi = builder_.CreatePHI(a->getType(), 2);
        phi->addIncoming(a, delta);
        phi->addIncoming(b, finite);
        return phi;
    };
    LightSample merged;
    for (int k = 0; k < 3; ++k)
        merged.L.push_back(merge(fromDelta.L[k], fromFinite.L[k]));
    for (int k = 0; k < colorSamples; ++k)
        merged.Cl.push_back(merge(fromDelta.Cl[k], fromFinite.Cl[k]));
    merged.lanes = merge(fromDelta.lanes, fromFinite.lanes);
    return merged;
}

void FunctionGenerator::emitLightLoop(const Instruction &i) {
    const Region &region = i.regions[0];
    const std::size_t carriedCount = i.results.size();
    const LightLoopPlan plan = planLightLoop(i);
    Values initial;
    for (std::size_t k = 0; k < carriedCount; ++k)
        initial.push_back(get(i.operands[i.operands.size() - carriedCount + k], Rate::Varying));
    Value *firstSample = builder_.getInt32(0);
    if (plan.delta)
        firstSample = builder_.CreateSelect(lanes_.any(masks_.currentAnd(plan.delta)),
                                            builder_.getInt32(-1), firstSample);
    auto *sampleCount = field(offsetof(ShaderArgs, sampleCount), integer_);
    auto *from = builder_.GetInsertBlock();
    auto *head = block("lights"), *take = block("light"), *run = block("lit"),
         *next = block("next_light"), *done = block("lights_end");
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    auto *sample = builder_.CreatePHI(integer_, 2, "sample");
    sample->addIncoming(firstSample, from);
    std::vector<llvm::PHINode *> carried;
    for (std::size_t k = 0; k < carriedCount; ++k) {
        carried.push_back(builder_.CreatePHI(initial[k]->getType(), 2));
        carried[k]->addIncoming(initial[k], from);
        set(region.arguments[3 + colorSamples + k], carried[k]);
        set(i.results[k], carried[k]);
    }
    builder_.CreateCondBr(builder_.CreateICmpSLT(sample, sampleCount), take, done);

    builder_.SetInsertPoint(take);
    const LightSample light = nextSample(i, plan, sample);
    auto *unlit = builder_.GetInsertBlock();
    builder_.CreateCondBr(lanes_.any(light.lanes), run, next);

    builder_.SetInsertPoint(run);
    for (int k = 0; k < 3; ++k)
        set(region.arguments[k], light.L[k]);
    for (int k = 0; k < colorSamples; ++k)
        set(region.arguments[3 + k], light.Cl[k]);
    Values after;
    {
        MaskStack::Scope scope(masks_, light.lanes);
        emitRegion(region);
        for (std::size_t k = 0; k < carriedCount; ++k)
            after.push_back(builder_.CreateSelect(light.lanes, get(region.yields[k], Rate::Varying),
                                                  carried[k]));
    }
    auto *lit = builder_.GetInsertBlock();
    builder_.CreateBr(next);

    builder_.SetInsertPoint(next);
    for (std::size_t k = 0; k < carriedCount; ++k) {
        auto *merged = builder_.CreatePHI(initial[k]->getType(), 2);
        merged->addIncoming(carried[k], unlit);
        merged->addIncoming(after[k], lit);
        carried[k]->addIncoming(merged, next);
    }
    sample->addIncoming(builder_.CreateAdd(sample, builder_.getInt32(1)), next);
    builder_.CreateBr(head);
    builder_.SetInsertPoint(done);
}

} // namespace candela

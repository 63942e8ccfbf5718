// SPDX-License-Identifier: Apache-2.0
#include "language/jit/light_loop.h"

#include "foundation/units/color.h"
#include "language/ir/core/regions.h"
#include "language/jit/arithmetic.h"
#include "language/runtime/shader_abi.h"

#include <algorithm>
#include <cstddef>

namespace candela::codegen {

using ir::Uniformity;

/// Lane by lane through memory, since it is rarely run: keeps of the lanes `among` those with
/// bytes[light] != 0. Inactive lanes look at light 0, so a byte a lane may be read.
static Value *whereByteIsNotZero(CodeFunction &code, Value *bytes, Value *light, Value *among) {
    auto &builder = code.builder;
    auto *byte = builder.getInt8Ty();
    const auto ofLight = [&](Value *index) {
        return code.invariantLoad(byte, builder.CreateGEP(byte, bytes, index));
    };
    const int width = code.lanes.width();
    if (width == 1)
        return builder.CreateAnd(among, builder.CreateIsNotNull(ofLight(light)));
    auto *lights = code.entryMemory(light->getType(), 1, "lights");
    auto *found = code.entryMemory(llvm::FixedVectorType::get(byte, width), 1, "found");
    builder.CreateStore(light, lights);
    code.repeat(width, "light_of_lane", [&](Value *lane) {
        auto *own =
            builder.CreateLoad(code.integerType, builder.CreateGEP(code.integerType, lights, lane));
        builder.CreateStore(ofLight(own), builder.CreateGEP(byte, found, lane));
    });
    auto *all = builder.CreateLoad(llvm::FixedVectorType::get(byte, width), found);
    return builder.CreateAnd(among, builder.CreateIsNotNull(all));
}

Value *acceptedByCategory(CodeFunction &code, ShaderArguments &arguments, int category, Value *row,
                          Value *among) {
    auto &builder = code.builder;
    const Lanes &lanes = code.lanes;
    among = lanes.kept(among);
    auto *accepts = arguments.fieldPointer(offsetof(ShaderArgs, categoryAccepts));
    auto *start = builder.GetInsertBlock();
    auto *test = code.block("category"), *load = code.block("lights"),
         *look = code.block("accepts"), *join = code.block("accepted");
    builder.CreateCondBr(builder.CreateIsNull(accepts), join, test);

    builder.SetInsertPoint(test);
    auto *lights = arguments.fieldPointer(offsetof(ShaderArgs, sampleLight));
    auto *noLights = llvm::Constant::getNullValue(lanes.varying(code.integerType));
    builder.CreateCondBr(builder.CreateIsNull(lights), look, load);
    builder.SetInsertPoint(load);
    auto *loaded = lanes.maskedLoad(
        code.integerType, builder.CreateGEP(code.integerType, lights, row), code.masks.current());
    builder.CreateBr(look);

    builder.SetInsertPoint(look);
    auto *light = builder.CreatePHI(lanes.varying(code.integerType), 2);
    light->addIncoming(noLights, test);
    light->addIncoming(loaded, load);
    auto *lightCount = arguments.field(offsetof(ShaderArgs, lightCount), code.integerType);
    auto *firstOfCategory = builder.CreateMul(builder.CreateAdd(lightCount, builder.getInt32(1)),
                                              builder.getInt32(category));
    auto *bytes = builder.CreateGEP(builder.getInt8Ty(), accepts, firstOfCategory);
    auto *result = lanes.kept(whereByteIsNotZero(code, bytes, light, lanes.asMask(among)));
    auto *end = builder.GetInsertBlock();
    builder.CreateBr(join);

    builder.SetInsertPoint(join);
    auto *accepted = builder.CreatePHI(result->getType(), 2);
    accepted->addIncoming(among, start);
    accepted->addIncoming(result, end);
    return accepted;
}

Value *lightNumber(CodeFunction &code, ShaderArguments &arguments, Value *row) {
    auto &builder = code.builder;
    auto *lights = arguments.fieldPointer(offsetof(ShaderArgs, sampleLight));
    return code.valuesIf(builder.CreateIsNotNull(lights), "light_number", [&] {
        auto *number =
            code.lanes.load(code.integerType, builder.CreateGEP(code.integerType, lights, row));
        return Values{builder.CreateSIToFP(number, code.lanes.varying(code.floatType))};
    })[0];
}

/// The region uses the value, by an instruction or by a yield.
static bool uses(const ir::Region &region, ir::ValueId value) {
    const auto among = [&](const std::vector<ir::ValueId> &values) {
        return std::ranges::find(values, value) != values.end();
    };
    return among(region.yields) || std::ranges::any_of(region.body, [&](const auto &i) {
               return among(i.operands) || std::ranges::any_of(i.regions, [&](const auto &inner) {
                          return uses(inner, value);
                      });
           });
}

LightLoop::LightLoop(CodeFunction &code, ShaderArguments &arguments, ValueTable &values,
                     const ir::Instruction &instruction)
    : code_(code), builder_(code.builder), arguments_(arguments), values_(values),
      instruction_(instruction), request_(values.function().requests[instruction.immediate]) {
    const ir::Region &region = instruction.regions[0];
    readsNumber_ = uses(region, region.arguments[std::size_t(3 + code.colorSamples)]);
    if (request_.form != ir::ConeForm::Everywhere && request_.coneCount > 0)
        findCones();
}

void LightLoop::findCones() {
    const ir::Instruction &i = instruction_;
    auto *angle = values_.get(i.operands[6], Uniformity::Varying);
    if (request_.form == ir::ConeForm::Extended) {
        delta_ = builder_.CreateFCmpOLE(angle, like(angle, 0));
        if (auto *known = llvm::dyn_cast<llvm::Constant>(delta_); known && known->isZeroValue())
            delta_ = nullptr;
        else
            delta_ = code_.lanes.kept(delta_);
        return;
    }
    coneAxis_ = values_.get({i.operands[3], i.operands[4], i.operands[5]}, Uniformity::Varying);
    coneCosine_ = callMath(code_, runtime::MathFunction::cos, {angle});
}

LightLoop::Sample LightLoop::deltaSample() {
    const ir::Instruction &i = instruction_;
    Sample sample;
    sample.L = values_.get({i.operands[3], i.operands[4], i.operands[5]}, Uniformity::Varying);
    sample.Cl = arguments_.color(offsetof(ShaderArgs, answers), i.immediate * code_.colorSamples);
    sample.number = like(sample.L[0], 0);
    auto *speaks = code_.masks.currentAnd(code_.lanes.asMask(delta_));
    sample.lanes = code_.lanes.kept(builder_.CreateAnd(speaks, anyNonZero(code_, sample.Cl)));
    return sample;
}

/// The tables may be null if there are no samples.
void LightLoop::findPlanes(Value *count) {
    samplePlanes_ =
        code_.valuesIf(builder_.CreateICmpSGT(count, builder_.getInt32(0)), "sample_planes", [&] {
            Values planes;
            const auto find = [&](std::size_t table, int number) {
                auto *entry = builder_.CreateConstGEP1_32(
                    code_.pointerType, arguments_.fieldPointer(table), unsigned(number));
                planes.push_back(code_.invariantLoad(code_.pointerType, entry));
            };
            for (int k = 0; k < 3; ++k)
                find(offsetof(ShaderArgs, sampleL), k);
            for (int k = 0; k < code_.colorSamples; ++k)
                find(offsetof(ShaderArgs, sampleCl), k);
            return planes;
        });
}

LightLoop::Sample LightLoop::finiteSample(Value *number) {
    auto *wide = builder_.getInt64Ty();
    auto *stride = builder_.CreateSExt(
        arguments_.field(offsetof(ShaderArgs, sampleStride), code_.integerType), wide);
    auto *row = builder_.CreateAdd(builder_.CreateMul(builder_.CreateSExt(number, wide), stride),
                                   builder_.CreateSExt(arguments_.firstPoint(), wide));
    const auto loadRow = [&](Value *plane) {
        return code_.lanes.load(code_.floatType, builder_.CreateGEP(code_.floatType, plane, row));
    };
    Sample sample;
    for (int k = 0; k < 3; ++k)
        sample.L.push_back(loadRow(samplePlanes_[k]));
    for (int k = 0; k < code_.colorSamples; ++k)
        sample.Cl.push_back(loadRow(samplePlanes_[3 + k]));
    sample.number = readsNumber_ ? lightNumber(code_, arguments_, row) : like(sample.L[0], 0);
    auto *lanes = code_.masks.currentAnd(anyNonZero(code_, sample.Cl));
    const auto narrow = [&](Value *test) { lanes = builder_.CreateAnd(lanes, test); };
    if (delta_)
        narrow(builder_.CreateNot(code_.lanes.asMask(delta_)));
    if (coneCosine_)
        narrow(builder_.CreateFCmpOGE(dot(code_, normalized(code_, sample.L), coneAxis_),
                                      coneCosine_));
    sample.lanes = code_.lanes.kept(lanes);
    if (request_.category >= 0)
        sample.lanes = acceptedByCategory(code_, arguments_, request_.category, row, sample.lanes);
    return sample;
}

LightLoop::Sample LightLoop::sample(Value *number) {
    if (!delta_)
        return finiteSample(number);
    auto *delta = code_.block("delta"), *finite = code_.block("finite"),
         *join = code_.block("sample");
    builder_.CreateCondBr(builder_.CreateICmpSLT(number, builder_.getInt32(0)), delta, finite);
    builder_.SetInsertPoint(delta);
    const Sample fromDelta = deltaSample();
    delta = builder_.GetInsertBlock();
    builder_.CreateBr(join);
    builder_.SetInsertPoint(finite);
    const Sample fromFinite = finiteSample(number);
    finite = builder_.GetInsertBlock();
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    const auto merge = [&](Value *a, Value *b) {
        auto *phi = builder_.CreatePHI(a->getType(), 2);
        phi->addIncoming(a, delta);
        phi->addIncoming(b, finite);
        return phi;
    };
    Sample merged;
    for (int k = 0; k < 3; ++k)
        merged.L.push_back(merge(fromDelta.L[k], fromFinite.L[k]));
    for (int k = 0; k < code_.colorSamples; ++k)
        merged.Cl.push_back(merge(fromDelta.Cl[k], fromFinite.Cl[k]));
    merged.number = merge(fromDelta.number, fromFinite.number);
    merged.lanes = merge(fromDelta.lanes, fromFinite.lanes);
    return merged;
}

Value *LightLoop::firstNumber() {
    Value *first = builder_.getInt32(0);
    if (!delta_)
        return first;
    auto *speaks = code_.masks.currentAnd(code_.lanes.asMask(delta_));
    return builder_.CreateSelect(code_.lanes.any(speaks), builder_.getInt32(-1), first);
}

std::vector<llvm::PHINode *> LightLoop::carry(const Values &initial, llvm::BasicBlock *from) {
    const ir::Instruction &i = instruction_;
    std::vector<llvm::PHINode *> phis;
    for (std::size_t k = 0; k < initial.size(); ++k) {
        phis.push_back(builder_.CreatePHI(initial[k]->getType(), 2));
        phis[k]->addIncoming(initial[k], from);
        values_.set(ir::argumentOf(i, k), phis[k]);
        values_.set(i.results[k], phis[k]);
    }
    return phis;
}

Values LightLoop::run(const Sample &light, const Values &carried, const EmitRegion &emitRegion) {
    const ir::Region &region = instruction_.regions[0];
    for (int k = 0; k < 3; ++k)
        values_.set(region.arguments[k], light.L[k]);
    for (int k = 0; k < code_.colorSamples; ++k)
        values_.set(region.arguments[3 + k], light.Cl[k]);
    values_.set(region.arguments[std::size_t(3 + code_.colorSamples)], light.number);
    MaskStack::Scope scope(code_.masks, light.lanes);
    emitRegion(region);
    Values after;
    for (std::size_t k = 0; k < carried.size(); ++k)
        after.push_back(builder_.CreateSelect(code_.lanes.asMask(light.lanes),
                                              values_.get(region.yields[k], Uniformity::Varying),
                                              carried[k]));
    return after;
}

void LightLoop::emit(const EmitRegion &emitRegion) {
    const ir::Instruction &i = instruction_;
    const std::size_t carriedCount = i.results.size();
    Values initial;
    for (std::size_t k = 0; k < carriedCount; ++k)
        initial.push_back(
            values_.get(i.operands[i.operands.size() - carriedCount + k], Uniformity::Varying));
    auto *first = firstNumber();
    auto *count = arguments_.field(offsetof(ShaderArgs, sampleCount), code_.integerType);
    findPlanes(count);
    auto *from = builder_.GetInsertBlock();
    auto *head = code_.block("lights"), *take = code_.block("light"), *lit = code_.block("lit"),
         *next = code_.block("next_light"), *done = code_.block("lights_end");
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    auto *number = builder_.CreatePHI(code_.integerType, 2, "sample");
    number->addIncoming(first, from);
    const std::vector<llvm::PHINode *> phis = carry(initial, from);
    const Values carried(phis.begin(), phis.end());
    builder_.CreateCondBr(builder_.CreateICmpSLT(number, count), take, done);

    builder_.SetInsertPoint(take);
    const Sample light = sample(number);
    auto *unlit = builder_.GetInsertBlock();
    builder_.CreateCondBr(code_.lanes.any(code_.lanes.asMask(light.lanes)), lit, next);

    builder_.SetInsertPoint(lit);
    const Values after = run(light, carried, emitRegion);
    lit = builder_.GetInsertBlock();
    builder_.CreateBr(next);

    builder_.SetInsertPoint(next);
    for (std::size_t k = 0; k < carriedCount; ++k) {
        auto *merged = builder_.CreatePHI(carried[k]->getType(), 2);
        merged->addIncoming(carried[k], unlit);
        merged->addIncoming(after[k], lit);
        phis[k]->addIncoming(merged, next);
    }
    number->addIncoming(builder_.CreateAdd(number, builder_.getInt32(1)), next);
    builder_.CreateBr(head);
    builder_.SetInsertPoint(done);
}

} // namespace candela::codegen

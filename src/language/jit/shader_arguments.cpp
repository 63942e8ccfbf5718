// SPDX-License-Identifier: Apache-2.0
#include "language/jit/shader_arguments.h"

#include "foundation/units/color.h"
#include "language/runtime/shader_abi.h"

#include <llvm/IR/Intrinsics.h>

#include <cstddef>

namespace candela::codegen {

std::size_t frameField(BindingTime frame) {
    return frame == BindingTime::View ? offsetof(ShaderArgs, viewFrame)
                                      : offsetof(ShaderArgs, surfaceFrame);
}

ShaderArguments::ShaderArguments(CodeFunction &code) : code_(code), builder_(code.builder) {
    place_.pointer = code.function->getArg(0);
}

void ShaderArguments::enterBlock(llvm::BasicBlock *prepare, Value *firstPoint) {
    place_.prepare = prepare;
    place_.firstPoint = firstPoint;
}

Value *ShaderArguments::blockBits(Value *count) {
    auto *word = builder_.getInt16Ty();
    auto *integer = code_.integerType;
    const int width = code_.lanes.width();
    auto *given = fieldPointer(offsetof(ShaderArgs, active));
    auto *from = builder_.GetInsertBlock();
    auto *load = code_.block("load_mask"), *join = code_.block("join_mask");
    builder_.CreateCondBr(builder_.CreateIsNull(given), join, load);
    builder_.SetInsertPoint(load);
    auto *index = builder_.CreateLShr(place_.firstPoint, 4);
    auto *loaded = code_.invariantLoad(word, builder_.CreateGEP(word, given, index));
    auto *shifted = builder_.CreateLShr(builder_.CreateZExt(loaded, integer),
                                        builder_.CreateAnd(place_.firstPoint, 15));
    builder_.CreateBr(join);
    builder_.SetInsertPoint(join);
    auto *bits = builder_.CreatePHI(integer, 2);
    bits->addIncoming(builder_.getInt32(~0u), from);
    bits->addIncoming(shifted, load);
    auto *left = builder_.CreateBinaryIntrinsic(llvm::Intrinsic::umin,
                                                builder_.CreateSub(count, place_.firstPoint),
                                                builder_.getInt32(width));
    auto *inside = builder_.CreateLShr(builder_.getInt32(~0u >> (32 - width)),
                                       builder_.CreateSub(builder_.getInt32(width), left));
    return builder_.CreateAnd(bits, inside);
}

Value *ShaderArguments::field(std::size_t offset, llvm::Type *type) {
    return code_.invariantLoad(
        type, builder_.CreateConstGEP1_64(builder_.getInt8Ty(), place_.pointer, offset));
}

Value *ShaderArguments::fieldPointer(std::size_t offset) {
    return field(offset, code_.pointerType);
}

Value *ShaderArguments::planeStart(PlaneName name) {
    if (name.index < 0)
        return fieldPointer(name.field);
    auto *entry = builder_.CreateConstGEP1_64(code_.pointerType, fieldPointer(name.field),
                                              std::uint64_t(name.index));
    return code_.invariantLoad(code_.pointerType, entry);
}

Value *ShaderArguments::row(int number) {
    return builder_.CreateConstGEP1_64(code_.floatType, place_.rows,
                                       std::uint64_t(number) * laneBlock);
}

/// More planes than this would be alive through all of a machine function.
constexpr std::size_t mostPlanesAlive = 64;

Value *ShaderArguments::plane(PlaneName name) {
    const auto found = rows_.find(name);
    const auto lookUp = [&] {
        auto *start = planeStart(name);
        return found == rows_.end()
                   ? start
                   : builder_.CreateSelect(areRowsRead(), row(found->second), start);
    };
    Value *start = nullptr;
    if (const auto known = place_.planes.find(name); known != place_.planes.end()) {
        start = known->second;
    } else if (place_.planes.size() < mostPlanesAlive) {
        llvm::IRBuilder<>::InsertPointGuard guard(builder_);
        builder_.SetInsertPoint(place_.prepare->getTerminator());
        start = place_.planes[name] = lookUp();
    } else {
        start = lookUp();
    }
    auto *first = place_.firstPoint;
    if (found != rows_.end())
        first = builder_.CreateSelect(areRowsRead(), builder_.getInt32(0), first);
    return builder_.CreateGEP(code_.floatType, start, first);
}

Value *ShaderArguments::planeHere(PlaneName name) {
    return builder_.CreateGEP(code_.floatType, planeStart(name), place_.firstPoint);
}

Values ShaderArguments::color(std::size_t tableField, int first) {
    return code_.valuesIf(builder_.CreateIsNotNull(fieldPointer(tableField)), "load_color", [&] {
        Values loaded;
        for (int k = 0; k < code_.colorSamples; ++k)
            loaded.push_back(code_.lanes.load(code_.floatType, planeHere({tableField, first + k})));
        return loaded;
    });
}

Value *ShaderArguments::slotToSave(const ir::SpillSlot &at) {
    auto *group =
        builder_.CreateSExt(builder_.CreateLShr(place_.firstPoint, 4), builder_.getInt64Ty());
    auto *lane =
        builder_.CreateSExt(builder_.CreateAnd(place_.firstPoint, 15), builder_.getInt64Ty());
    auto *row = builder_.CreateAdd(builder_.CreateMul(group, builder_.getInt64(at.slots)),
                                   builder_.getInt64(at.slot));
    auto *index = builder_.CreateAdd(builder_.CreateMul(row, builder_.getInt64(laneBlock)), lane);
    return builder_.CreateGEP(code_.floatType, fieldPointer(frameField(at.frame)), index);
}

Value *ShaderArguments::slotToLoad(const ir::SpillSlot &at) {
    const auto found = rows_.find({frameField(at.frame)});
    if (found == rows_.end())
        return slotToSave(at);
    auto *first = builder_.CreateSelect(areRowsRead(), row(found->second),
                                        slotToSave({at.frame, 0, at.slots}));
    return builder_.CreateConstGEP1_64(code_.floatType, first, std::uint64_t(at.slot) * laneBlock);
}

Values ShaderArguments::spaceMatrix(int space, bool inverse) {
    auto *table = fieldPointer(offsetof(ShaderArgs, spaces));
    auto *matrix = code_.invariantLoad(
        code_.pointerType, builder_.CreateConstGEP1_64(code_.pointerType, table, space));
    Values elements;
    for (int k = 0; k < 16; ++k)
        elements.push_back(code_.invariantLoad(
            code_.floatType,
            builder_.CreateConstGEP1_64(code_.floatType, matrix, k + (inverse ? 16 : 0))));
    return elements;
}

} // namespace candela::codegen

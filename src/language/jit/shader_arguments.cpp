// SPDX-License-Identifier: Apache-2.0
#include "language/jit/shader_arguments.h"

#include "foundation/units/color.h"
#include "language/runtime/shader_abi.h"

#include <llvm/IR/Intrinsics.h>

#include <cstddef>

namespace candela::codegen {

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
    auto *inside = builder_.CreateLShr(builder_.getInt32((1u << width) - 1),
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

/// More planes than this would be alive through all of a machine function.
constexpr std::size_t mostPlanesAlive = 64;

Value *ShaderArguments::plane(std::size_t tableField, int index) {
    const std::pair key(tableField, index);
    if (place_.planes.size() >= mostPlanesAlive && !place_.planes.contains(key))
        return planeHere(tableField, index);
    Value *&plane = place_.planes[key];
    if (!plane) {
        llvm::IRBuilder<>::InsertPointGuard guard(builder_);
        builder_.SetInsertPoint(place_.prepare->getTerminator());
        auto *entry = builder_.CreateConstGEP1_64(code_.pointerType, fieldPointer(tableField),
                                                  std::uint64_t(index));
        plane = code_.invariantLoad(code_.pointerType, entry);
    }
    return builder_.CreateGEP(code_.floatType, plane, place_.firstPoint);
}

Value *ShaderArguments::planeHere(std::size_t tableField, int index) {
    auto *entry = builder_.CreateConstGEP1_64(code_.pointerType, fieldPointer(tableField),
                                              std::uint64_t(index));
    return builder_.CreateGEP(code_.floatType, code_.invariantLoad(code_.pointerType, entry),
                              place_.firstPoint);
}

Values ShaderArguments::color(std::size_t tableField, int first) {
    return code_.valuesIf(builder_.CreateIsNotNull(fieldPointer(tableField)), "load_color", [&] {
        Values loaded;
        for (int k = 0; k < code_.colorSamples; ++k)
            loaded.push_back(code_.lanes.load(code_.floatType, planeHere(tableField, first + k)));
        return loaded;
    });
}

Value *ShaderArguments::spillSlot(int slot, int slots) {
    auto *group =
        builder_.CreateSExt(builder_.CreateLShr(place_.firstPoint, 4), builder_.getInt64Ty());
    auto *lane =
        builder_.CreateSExt(builder_.CreateAnd(place_.firstPoint, 15), builder_.getInt64Ty());
    auto *row = builder_.CreateAdd(builder_.CreateMul(group, builder_.getInt64(slots)),
                                   builder_.getInt64(slot));
    auto *index = builder_.CreateAdd(builder_.CreateMul(row, builder_.getInt64(16)), lane);
    return builder_.CreateGEP(code_.floatType, fieldPointer(offsetof(ShaderArgs, frame)), index);
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

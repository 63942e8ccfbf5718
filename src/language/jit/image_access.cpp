// SPDX-License-Identifier: Apache-2.0
#include "language/jit/image_access.h"

#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/jit/runtime_symbols.h"

#include <llvm/IR/Intrinsics.h>
#include <llvm/IR/MDBuilder.h>

#include <algorithm>
#include <cstddef>

namespace candela::codegen {

using ir::Instruction;
using ir::Op;
using ir::Uniformity;
using runtime::LookupOperand;

ImageAccess::ImageAccess(CodeFunction &code, ShaderArguments &arguments, ValueTable &values,
                         const TurnLimit &limit, const ArrayMemory &arrays)
    : code_(code), builder_(code.builder), arguments_(arguments), values_(values), limit_(limit),
      arrays_(arrays), definitions_(values.function().values.size()) {
    ir::forEachInstruction(values.function().body, [&](const Instruction &i) {
        if (i.op == Op::Input || i.op == Op::Add || i.op == Op::Sub)
            definitions_[i.results[0]] = &i;
        if (i.op != Op::ImageLoad && i.op != Op::ImageStore && i.op != Op::PixelLoop)
            return;
        mostOperands_ = std::max(mostOperands_, i.operands.size());
        mostResults_ = std::max(mostResults_, i.results.size());
    });
}

const ir::ImageUse &ImageAccess::use(const Instruction &i) const {
    return values_.function().images[std::size_t(i.immediate)];
}

const ImageAccess::Memory &ImageAccess::memory() {
    Memory &own = memory_[code_.function];
    if (!own.operands) {
        auto *row = code_.lanes.varying(code_.floatType);
        own.operands = code_.entryMemory(row, int(mostOperands_), "image_operands");
        own.results = code_.entryMemory(row, int(mostResults_), "image_results");
    }
    return own;
}

Value *ImageAccess::lanes(Uniformity uniformity) const {
    const int count = uniformity == Uniformity::Varying ? code_.lanes.width() : 1;
    return builder_.getInt32(std::uint32_t(count));
}

Value *ImageAccess::putOperands(const Instruction &i, Uniformity uniformity) {
    Value *to = memory().operands;
    auto *row = code_.lanes.type(ir::Type::Float, uniformity);
    for (std::size_t k = 0; k < i.operands.size(); ++k)
        code_.lanes.store(values_.get(i.operands[k], uniformity),
                          builder_.CreateConstGEP1_64(row, to, k));
    return to;
}

// --- Anywhere ------------------------------------------------------------------------------------

Values ImageAccess::lookUpAnywhere(const Instruction &i, Uniformity uniformity) {
    Value *operands = putOperands(i, uniformity), *results = memory().results;
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(),
        {pointer, integer, integer, integer, integer, integer, pointer, pointer}, false);
    const auto number = [&](auto n) { return builder_.getInt32(std::uint32_t(n)); };
    Value *bits = uniformity == Uniformity::Varying ? code_.masks.currentBits() : number(1);
    builder_.CreateCall(code_.external(lookUpSymbol, signature, false),
                        {arguments_.pointer(), number(use(i).map), number(use(i).filter),
                         number(use(i).values), lanes(uniformity), bits, operands, results});
    auto *row = code_.lanes.type(ir::Type::Float, uniformity);
    Values places;
    for (std::size_t k = 0; k < i.results.size(); ++k)
        places.push_back(builder_.CreateConstGEP1_64(row, results, k));
    return places;
}

void ImageAccess::storeAnywhere(const Instruction &i, Uniformity uniformity) {
    Value *operands = putOperands(i, uniformity);
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(), {pointer, integer, integer, integer, integer, pointer}, false);
    const auto number = [&](auto n) { return builder_.getInt32(std::uint32_t(n)); };
    builder_.CreateCall(code_.external(setImageSymbol, signature, false),
                        {arguments_.pointer(), number(use(i).map), number(use(i).values),
                         lanes(uniformity), code_.masks.currentBits(), operands});
}

// --- Rows of pixels ------------------------------------------------------------------------------

/// Runs `plain` where the condition holds, else `other`.
static std::pair<llvm::BasicBlock *, llvm::BasicBlock *>
branchOn(CodeFunction &code, Value *condition, const std::function<void()> &plain,
         const std::function<void()> &other) {
    auto &builder = code.builder;
    auto *row = code.block("row"), *anywhere = code.block("anywhere"), *join = code.block("looked");
    builder.CreateCondBr(condition, row, anywhere,
                         llvm::MDBuilder(code.module.getContext()).createLikelyBranchWeights());
    builder.SetInsertPoint(row);
    plain();
    auto *rowEnd = builder.GetInsertBlock();
    builder.CreateBr(join);
    builder.SetInsertPoint(anywhere);
    other();
    auto *anywhereEnd = builder.GetInsertBlock();
    builder.CreateBr(join);
    builder.SetInsertPoint(join);
    return {rowEnd, anywhereEnd};
}

Value *ImageAccess::beyondColumn(ir::ValueId id) {
    const Instruction *made = definitions_[id];
    if (!made)
        return nullptr;
    if (made->op == Op::Input)
        return made->immediate == int(ShaderInput::column)
                   ? llvm::ConstantFP::get(code_.floatType, 0)
                   : nullptr;
    const auto isUniform = [&](int k) {
        return values_.uniformity(made->operands[std::size_t(k)]) == Uniformity::Uniform;
    };
    const int column = isUniform(1) ? 0 : made->op == Op::Add && isUniform(0) ? 1 : -1;
    Value *rest = column < 0 ? nullptr : beyondColumn(made->operands[std::size_t(column)]);
    if (!rest)
        return nullptr;
    Value *more = values_.get(made->operands[std::size_t(1 - column)]);
    return made->op == Op::Add ? builder_.CreateFAdd(rest, more) : builder_.CreateFSub(rest, more);
}

/// As beyondColumn(), where the text says that the lanes' pixels stand side by side; else null.
Value *ImageAccess::beyondColumnOfRow(const Instruction &i) {
    const auto isUniform = [&](LookupOperand k) {
        return values_.uniformity(i.operands[std::size_t(k)]) == Uniformity::Uniform;
    };
    if (code_.lanes.width() == 1 || !isUniform(LookupOperand::Y))
        return nullptr;
    if (i.op == Op::ImageLoad &&
        (use(i).filter > runtime::ImageFilter::Bilinear || !isUniform(LookupOperand::Channel)))
        return nullptr;
    return beyondColumn(i.operands[0]);
}

/// Maps do not change their sizes while a pixel loop runs.
Value *ImageAccess::mapField(const Instruction &i, std::size_t offset, llvm::Type *type) {
    const std::size_t at = std::size_t(use(i).map) * sizeof(ImageMap) + offset;
    Value *&known = fields_[{code_.function, at}];
    if (!known)
        known = arguments_.atHead([&] {
            auto *maps = arguments_.fieldPointer(offsetof(ShaderArgs, maps));
            return code_.invariantLoad(type,
                                       builder_.CreateConstGEP1_64(builder_.getInt8Ty(), maps, at));
        });
    return known;
}

/// Where pixel (0, 0) of a channel of the map stands.
Value *ImageAccess::planeOf(const Instruction &i, int channel) {
    Value *&known = planes_[{code_.function, {use(i).map, channel}}];
    if (!known) {
        Value *planes = mapField(i, offsetof(ImageMap, planes), code_.pointerType);
        known = arguments_.atHead([&] {
            return code_.invariantLoad(
                code_.pointerType,
                builder_.CreateConstGEP1_64(code_.pointerType, planes, std::uint64_t(channel)));
        });
    }
    return known;
}

bool ImageAccess::isFirstChannel(const Instruction &i) const {
    const auto *known = llvm::dyn_cast<llvm::ConstantFP>(
        values_.get(i.operands[std::size_t(LookupOperand::Channel)]));
    return known && known->isZero();
}

/// Every map has planes for a color from channel 0 on.
Value *ImageAccess::hasChannels(const Instruction &i) {
    if (isFirstChannel(i))
        return builder_.getTrue();
    Value *channel = values_.get(i.operands[std::size_t(LookupOperand::Channel)]);
    const auto number = [&](float x) { return llvm::ConstantFP::get(code_.floatType, x); };
    Value *count = mapField(i, offsetof(ImageMap, channels), code_.integerType);
    Value *end = builder_.CreateFAdd(channel, number(float(use(i).values)));
    Value *whole = builder_.CreateFCmpOEQ(
        builder_.CreateUnaryIntrinsic(llvm::Intrinsic::floor, channel), channel);
    return builder_.CreateAnd(
        builder_.CreateAnd(whole, builder_.CreateFCmpOGE(channel, number(0))),
        builder_.CreateFCmpOLE(end, builder_.CreateSIToFP(count, code_.floatType)));
}

/// A color goes to a color's channels, a single value to one or to those.
Value *ImageAccess::takesRows(const Instruction &i) {
    Value *count = mapField(i, offsetof(ImageMap, channels), code_.integerType);
    const auto is = [&](int n) {
        return builder_.CreateICmpEQ(count, builder_.getInt32(std::uint32_t(n)));
    };
    const int values = int(i.operands.size()) - 2;
    return values > 1 ? is(values) : builder_.CreateOr(is(1), is(3));
}

ImageAccess::Row ImageAccess::row(const Instruction &i, Value *beyond) {
    auto *integer = code_.integerType;
    const auto number = [&](int n) { return builder_.getInt32(std::uint32_t(n)); };
    const auto whole = [&](Value *x) {
        return builder_.CreateFCmpOEQ(builder_.CreateUnaryIntrinsic(llvm::Intrinsic::floor, x), x);
    };
    constexpr float farthest = 1 << 20;
    const auto limited = [&](Value *x, float most) {
        auto *least = builder_.CreateMaxNum(x, llvm::ConstantFP::get(code_.floatType, -most));
        return builder_.CreateMinNum(least, llvm::ConstantFP::get(code_.floatType, most));
    };
    Value *width = mapField(i, offsetof(ImageMap, width), integer);
    Value *height = mapField(i, offsetof(ImageMap, height), integer);
    Value *y = values_.get(i.operands[1]);
    Value *plain = builder_.CreateAnd(whole(beyond), whole(y), "whole");

    Value *last = builder_.CreateSub(height, number(1));
    Value *line = builder_.CreateFPToSI(limited(y, farthest), integer);
    Value *inside = builder_.CreateBinaryIntrinsic(
        llvm::Intrinsic::smin,
        builder_.CreateBinaryIntrinsic(llvm::Intrinsic::smax, line, number(0)), last);
    if (i.op == Op::ImageStore)
        plain = builder_.CreateAnd(plain, builder_.CreateICmpEQ(line, inside));

    Value *column = builder_.CreateAdd(
        builder_.CreateAdd(arguments_.field(offsetof(ShaderArgs, firstColumn), integer),
                           arguments_.firstPoint()),
        builder_.CreateFPToSI(limited(beyond, farthest), integer));
    // From the left halo to the end of the right one, in one test.
    Value *most = builder_.CreateAdd(width, number(2 * imageHalo - code_.lanes.width()));
    plain = builder_.CreateAnd(
        plain, builder_.CreateICmpULE(builder_.CreateAdd(column, number(imageHalo)), most));

    plain = builder_.CreateAnd(plain, i.op == Op::ImageLoad ? hasChannels(i) : takesRows(i));

    auto *wide = builder_.getInt64Ty();
    Value *stride = mapField(i, offsetof(ImageMap, rowStride), integer);
    Value *index = builder_.CreateAdd(
        builder_.CreateMul(builder_.CreateSExt(inside, wide), builder_.CreateSExt(stride, wide)),
        builder_.CreateSExt(column, wide), "pixel");
    return {plain, index};
}

Value *ImageAccess::pixels(const Instruction &i, const Row &row, int component) {
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    Value *start = nullptr;
    if (i.op == Op::ImageStore || isFirstChannel(i)) {
        start = planeOf(i, component);
    } else {
        Value *channel = values_.get(i.operands[std::size_t(LookupOperand::Channel)]);
        Value *plane = builder_.CreateAdd(builder_.getInt32(std::uint32_t(component)),
                                          builder_.CreateFPToSI(channel, integer));
        Value *planes = mapField(i, offsetof(ImageMap, planes), pointer);
        start = code_.invariantLoad(pointer, builder_.CreateGEP(pointer, planes, plane));
    }
    return builder_.CreateGEP(code_.floatType, start, row.index);
}

Values ImageAccess::placesInRow(const Instruction &i, const Row &row) {
    Values places;
    for (int c = 0; c < int(i.results.size()); ++c)
        places.push_back(pixels(i, row, c));
    return places;
}

/// Whether a single value goes to the channels of a color too, not to one alone.
Value *ImageAccess::isColorMap(const Instruction &i) {
    return builder_.CreateICmpNE(mapField(i, offsetof(ImageMap, channels), code_.integerType),
                                 builder_.getInt32(1));
}

void ImageAccess::storeRow(const Instruction &i, const Row &row) {
    constexpr int ofColor = 3;
    const int values = int(i.operands.size()) - 2;
    setRow(i, row, 0, values);
    if (values == 1)
        code_.valuesIf(isColorMap(i), "all_channels", [&] {
            setRow(i, row, 1, ofColor);
            return Values{};
        });
}

/// A row of a map that no cache would keep goes past the caches, where all lanes run: what is to be
/// set need not be read first. (Whoever runs pixel loops makes it visible to others.)
Value *ImageAccess::goesPastCaches(const Instruction &i, const Row &row, Value *mask) {
    constexpr int floatsOfLargePlane = 1 << 22;
    auto *integer = code_.integerType;
    Value *height = mapField(i, offsetof(ImageMap, height), integer);
    Value *stride = mapField(i, offsetof(ImageMap, rowStride), integer);
    Value *isLarge = arguments_.atHead([&] {
        return builder_.CreateICmpUGE(builder_.CreateMul(height, stride),
                                      builder_.getInt32(floatsOfLargePlane));
    });
    const auto line = std::uint64_t(16); // Floats.
    Value *isAligned =
        builder_.CreateIsNull(builder_.CreateAnd(row.index, builder_.getInt64(line - 1)));
    return builder_.CreateAnd(builder_.CreateAnd(isLarge, isAligned), code_.lanes.all(mask));
}

/// Components [first, end) of a row.
void ImageAccess::setRow(const Instruction &i, const Row &row, int first, int end) {
    const bool isColor = i.operands.size() > 3;
    Value *mask = code_.masks.current();
    const auto each = [&](const auto &store) {
        for (int c = first; c < end; ++c)
            store(values_.get(i.operands[std::size_t(2 + (isColor ? c : 0))], Uniformity::Varying),
                  pixels(i, row, c));
    };
    const auto pastCaches = [&](Value *value, Value *to) {
        llvm::LLVMContext &context = code_.module.getContext();
        auto *one = llvm::ConstantAsMetadata::get(builder_.getInt32(1));
        auto *store = builder_.CreateAlignedStore(value, to, llvm::Align(64));
        store->setMetadata(llvm::LLVMContext::MD_nontemporal, llvm::MDNode::get(context, one));
    };
    const auto masked = [&] {
        each([&](Value *value, Value *to) { code_.lanes.maskedStore(value, to, mask); });
    };
    const auto whole = [&] {
        each([&](Value *value, Value *to) { code_.lanes.store(value, to); });
    };
    const auto throughCaches = [&] {
        code_.lanes.maskingCosts() ? void(branchOn(code_, code_.lanes.all(mask), whole, masked))
                                   : masked();
    };
    branchOn(
        code_, goesPastCaches(i, row, mask), [&] { each(pastCaches); }, throughCaches);
}

// --- Either --------------------------------------------------------------------------------------

/// Where the values are is chosen, not the values: registers are few.
void ImageAccess::load(const Instruction &i) {
    if (i.results.empty())
        return;
    const Uniformity uniformity = values_.uniformity(i.results[0]);
    Values places;
    Value *beyond = uniformity == Uniformity::Varying ? beyondColumnOfRow(i) : nullptr;
    if (!beyond) {
        places = lookUpAnywhere(i, uniformity);
    } else {
        const Row at = row(i, beyond);
        Values near, anywhere;
        const auto ends = branchOn(
            code_, at.isPlain, [&] { near = placesInRow(i, at); },
            [&] { anywhere = lookUpAnywhere(i, uniformity); });
        for (std::size_t k = 0; k < near.size(); ++k) {
            auto *phi = builder_.CreatePHI(code_.pointerType, 2);
            phi->addIncoming(near[k], ends.first);
            phi->addIncoming(anywhere[k], ends.second);
            places.push_back(phi);
        }
    }
    auto *type = code_.lanes.type(ir::Type::Float, uniformity);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        values_.set(i.results[k], builder_.CreateAlignedLoad(type, places[k], llvm::Align(4)));
}

void ImageAccess::store(const Instruction &i) {
    const bool varies = std::ranges::any_of(
        i.operands, [&](ir::ValueId v) { return values_.uniformity(v) == Uniformity::Varying; });
    MaskStack::Scope scope(code_.masks, limit_.running(code_.masks.current()));
    Value *beyond = varies ? beyondColumnOfRow(i) : nullptr;
    if (!beyond) {
        storeAnywhere(i, varies ? Uniformity::Varying : Uniformity::Uniform);
        return;
    }
    const Row at = row(i, beyond);
    branchOn(
        code_, at.isPlain, [&] { storeRow(i, at); },
        [&] { storeAnywhere(i, Uniformity::Varying); });
}

void ImageAccess::runLoop(const Instruction &i) {
    const ir::PixelLoop &loop = values_.function().pixelLoops[std::size_t(i.immediate)];
    Value *given = putOperands(i, Uniformity::Uniform), *results = memory().results;
    auto *integer = code_.integerType, *pointer = code_.pointerType;
    const int count = std::max<int>(1, int(loop.arrays.size()));
    Value *arrays = code_.entryMemory(pointer, count, "captured_arrays");
    for (std::size_t k = 0; k < loop.arrays.size(); ++k)
        builder_.CreateStore(arrays_.memory()[std::size_t(loop.arrays[k])],
                             builder_.CreateConstGEP1_64(pointer, arrays, k));
    auto *signature = llvm::FunctionType::get(
        builder_.getVoidTy(), {pointer, integer, integer, pointer, pointer, pointer}, false);
    builder_.CreateCall(code_.external(pixelLoopSymbol, signature, false),
                        {arguments_.pointer(), builder_.getInt32(std::uint32_t(i.immediate)),
                         builder_.getInt32(std::uint32_t(i.results.size())), given, arrays,
                         results});
    for (std::size_t k = 0; k < i.results.size(); ++k)
        values_.set(i.results[k],
                    builder_.CreateLoad(code_.floatType,
                                        builder_.CreateConstGEP1_64(code_.floatType, results, k)));
}

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
#include "language/jit/earlier_lanes.h"

#include <algorithm>
#include <cstddef>

namespace candela::codegen {

using ir::Op;

EarlierLanes::EarlierLanes(CodeFunction &code, ShaderArguments &arguments,
                           const ir::Function &function)
    : code_(code), builder_(code.builder), arguments_(arguments), lanes_(function.lanes) {
    if (lanes_ == BindingTime::Surface)
        return;
    collect(function.body, function);
    addFrames(function);
}

void EarlierLanes::collect(const ir::Region &region, const ir::Function &function) {
    constexpr auto inputs = offsetof(ShaderArgs, inputs);
    for (const ir::Instruction &i : region.body) {
        const auto slot = ir::spillSlot(function, i.immediate);
        switch (i.op) {
        case Op::Input:
            addPlane({inputs, i.immediate}, bindingTimeOf(ShaderInput(i.immediate)));
            break;
        case Op::Random: addPlane({inputs, int(ShaderInput::seed)}, BindingTime::Surface); break;
        case Op::Variable:
            addPlane({offsetof(ShaderArgs, variables), i.immediate}, BindingTime::Surface);
            break;
        case Op::Parameter:
            addPlane({offsetof(ShaderArgs, parameterOffset)}, BindingTime::Surface);
            break;
        case Op::Object:
        case Op::ObjectInverse:
            addPlane({offsetof(ShaderArgs, objectIndex)}, BindingTime::Surface);
            break;
        case Op::FrameLoad:
            if (slot.frame < lanes_)
                rows_.push_back({{frameField(slot.frame)}, slot.frame, slot.slot, slot});
            break;
        default: break;
        }
        for (const ir::Region &inner : i.regions)
            collect(inner, function);
    }
}

void EarlierLanes::addPlane(ShaderArguments::PlaneName plane, BindingTime time) {
    if (time < lanes_ && known_.of.try_emplace(plane, known_.count).second)
        rows_.push_back({plane, time, known_.count++, {}});
}

/// A frame's rows stand as its slots do, those that are not read among them.
void EarlierLanes::addFrames(const ir::Function &function) {
    const auto add = [&](BindingTime frame, int slots) {
        const bool isRead = std::any_of(rows_.begin(), rows_.end(), [&](const Row &row) {
            return row.slot.slots > 0 && row.time == frame;
        });
        if (!isRead)
            return;
        known_.of[{frameField(frame)}] = known_.count;
        for (Row &row : rows_)
            if (row.slot.slots > 0 && row.time == frame)
                row.row = known_.count + row.slot.slot;
        known_.count += slots;
    };
    add(BindingTime::Surface, function.surfaceSlots);
    add(BindingTime::View, function.viewSlots);
}

void EarlierLanes::begin() {
    if (rows_.empty())
        return;
    auto *memory = code_.entryMemory(code_.floatType, known_.count * laneBlock, "rows");
    auto *named =
        builder_.CreateIsNotNull(arguments_.fieldPointer(offsetof(ShaderArgs, surfaceLane)));
    if (lanes_ == BindingTime::Response)
        named = builder_.CreateOr(named, builder_.CreateIsNotNull(arguments_.fieldPointer(
                                             offsetof(ShaderArgs, viewLane))));
    auto *none = llvm::ConstantPointerNull::get(builder_.getPtrTy());
    known_.memory = builder_.CreateSelect(named, memory, none);
    arguments_.readRows(known_);
}

void EarlierLanes::load() {
    if (rows_.empty())
        return;
    auto *lookUp = code_.block("look_up"), *done = code_.block("looked_up");
    builder_.CreateCondBr(builder_.CreateIsNull(known_.memory), done, lookUp);
    builder_.SetInsertPoint(lookUp);
    auto *view = viewLanes();
    code_.lanes.hasGathers() && code_.lanes.width() > 1 ? gather(view) : gatherInLoop(view);
    builder_.CreateBr(done);
    builder_.SetInsertPoint(done);
}

/// What the plane names, which `read` reads; `own` if there is no plane.
static Value *named(CodeFunction &code, Value *plane, Value *own,
                    const std::function<Value *(Value *plane)> &read) {
    return code.valuesIf(code.builder.CreateIsNotNull(plane), "named",
                         [&] { return Values{read(plane)}; }, {own})[0];
}

/// Inactive lanes look at lane 0, where something stands.
Value *EarlierLanes::viewLanes() {
    const Lanes &lanes = code_.lanes;
    auto *mask = code_.masks.current();
    auto *own = builder_.CreateAdd(lanes.splat(arguments_.firstPoint()), lanes.laneNumbers());
    own = builder_.CreateSelect(mask, own, llvm::Constant::getNullValue(own->getType()));
    if (lanes_ != BindingTime::Response)
        return own;
    return named(
        code_, arguments_.fieldPointer(offsetof(ShaderArgs, viewLane)), own, [&](Value *plane) {
            return lanes.maskedLoad(
                code_.integerType,
                builder_.CreateGEP(code_.integerType, plane, arguments_.firstPoint()), mask);
        });
}

Value *EarlierLanes::base(const Row &row) {
    if (row.slot.slots == 0)
        return arguments_.planeStart(row.plane);
    return builder_.CreateConstGEP1_64(code_.floatType, arguments_.fieldPointer(row.plane.field),
                                       std::uint64_t(row.slot.slot) * laneBlock);
}

Value *EarlierLanes::index(const Row &row, const Places &places) {
    auto *lane = places.at(row.time);
    if (row.slot.slots == 0)
        return lane;
    auto *like = lane->getType();
    const auto number = [&](int n) { return llvm::ConstantInt::get(like, std::uint64_t(n)); };
    return builder_.CreateAdd(builder_.CreateMul(builder_.CreateLShr(lane, number(4)),
                                                 number(row.slot.slots * laneBlock)),
                              builder_.CreateAnd(lane, number(laneBlock - 1)));
}

void EarlierLanes::gather(Value *view) {
    const Lanes &lanes = code_.lanes;
    auto *mask = code_.masks.current();
    auto *surface =
        named(code_, arguments_.fieldPointer(offsetof(ShaderArgs, surfaceLane)), view,
              [&](Value *plane) { return lanes.gather(code_.integerType, plane, view, mask); });
    for (const Row &row : rows_)
        lanes.store(lanes.gather(code_.floatType, base(row), index(row, {view, surface}), mask),
                    builder_.CreateConstGEP1_32(code_.floatType, known_.memory,
                                                unsigned(row.row * laneBlock)));
}

/// Lane by lane where an instruction that gathers would be taken apart.
void EarlierLanes::gatherInLoop(Value *view) {
    const Lanes &lanes = code_.lanes;
    auto *views = code_.entryMemory(view->getType(), 1, "views");
    lanes.store(view, views);
    code_.repeat(lanes.width(), "lane", [&](Value *lane) {
        auto *own = builder_.CreateLoad(code_.integerType,
                                        builder_.CreateGEP(code_.integerType, views, lane));
        auto *surface =
            named(code_, arguments_.fieldPointer(offsetof(ShaderArgs, surfaceLane)), own,
                  [&](Value *plane) {
                      return builder_.CreateLoad(code_.integerType,
                                                 builder_.CreateGEP(code_.integerType, plane, own));
                  });
        for (const Row &row : rows_) {
            auto *element =
                builder_.CreateGEP(code_.floatType, base(row), index(row, {own, surface}));
            auto *to = builder_.CreateAdd(lane, builder_.getInt32(unsigned(row.row * laneBlock)));
            builder_.CreateStore(builder_.CreateLoad(code_.floatType, element),
                                 builder_.CreateGEP(code_.floatType, known_.memory, to));
        }
    });
}

} // namespace candela::codegen

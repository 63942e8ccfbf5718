// SPDX-License-Identifier: Apache-2.0
#include "language/jit/gathers.h"

#include "language/runtime/shader_abi.h"

#include <llvm/IR/Intrinsics.h>

#include <cstddef>
#include <functional>
#include <vector>

namespace candela::codegen {

Gathers::Gathers(CodeFunction &code, ShaderArguments &arguments, const ir::Region &body)
    : code_(code), builder_(code.builder), arguments_(arguments),
      parameters_{offsetof(ShaderArgs, parameters), offsetof(ShaderArgs, parameterOffset), 1, {}},
      objectMatrices_{
          offsetof(ShaderArgs, objectMatrices), offsetof(ShaderArgs, objectIndex), 32, {}} {
    collect(body);
}

void Gathers::collect(const ir::Region &region) {
    for (const ir::Instruction &i : region.body) {
        if (i.op == ir::Op::Parameter)
            parameters_.loaded[i.immediate] = nullptr;
        for (int k = 0; k < 16 && (i.op == ir::Op::Object || i.op == ir::Op::ObjectInverse); ++k)
            objectMatrices_.loaded[k + (i.op == ir::Op::ObjectInverse ? 16 : 0)] = nullptr;
        for (const ir::Region &inner : i.regions)
            collect(inner);
    }
}

void Gathers::load(Value *rows) {
    if (rows)
        loadIntoRows(parameters_, rows);
    else
        load(parameters_);
    load(objectMatrices_);
}

Values Gathers::objectMatrix(bool inverse) const {
    Values elements;
    for (int k = 0; k < 16; ++k)
        elements.push_back(objectMatrices_.loaded.at(k + (inverse ? 16 : 0)));
    return elements;
}

Values Gathers::broadcast(const Table &table, Value *origin) {
    Values values;
    for (const auto &[place, value] : table.loaded) {
        auto *element = builder_.CreateGEP(code_.floatType, origin, builder_.getInt32(place));
        values.push_back(code_.lanes.splat(code_.invariantLoad(code_.floatType, element)));
    }
    return values;
}

/// Lane by lane through memory where an instruction that gathers would be taken apart: rarely run,
/// and a fraction of the code. An inactive lane's index is 0, where something stands.
Values Gathers::gatherInLoop(const Table &table, Value *base, Value *index) {
    const Lanes &lanes = code_.lanes;
    auto *indices = code_.entryMemory(index->getType(), 1, "indices");
    auto *rows =
        code_.entryMemory(lanes.varying(code_.floatType), int(table.loaded.size()), "rows");
    builder_.CreateStore(index, indices);
    code_.repeat(lanes.width(), "lane", [&](Value *lane) {
        auto *own = builder_.CreateLoad(code_.integerType,
                                        builder_.CreateGEP(code_.integerType, indices, lane));
        auto *origin = builder_.CreateGEP(code_.floatType, base, own);
        int row = 0;
        for (const auto &[place, value] : table.loaded) {
            auto *element = builder_.CreateConstGEP1_32(code_.floatType, origin, unsigned(place));
            auto *to = builder_.CreateAdd(lane, builder_.getInt32(row++ * lanes.width()));
            builder_.CreateStore(code_.invariantLoad(code_.floatType, element),
                                 builder_.CreateGEP(code_.floatType, rows, to));
        }
    });
    Values values;
    for (int row = 0; row < int(table.loaded.size()); ++row)
        values.push_back(lanes.load(
            code_.floatType,
            builder_.CreateConstGEP1_32(code_.floatType, rows, unsigned(row * lanes.width()))));
    return values;
}

Values Gathers::gather(const Table &table, Value *base, Value *index) {
    if (!code_.lanes.hasGathers())
        return gatherInLoop(table, base, index);
    Values values;
    for (const auto &[place, value] : table.loaded)
        values.push_back(code_.lanes.gather(
            code_.floatType, builder_.CreateGEP(code_.floatType, base, builder_.getInt32(place)),
            index, code_.masks.current()));
    return values;
}

Gathers::Indices Gathers::indices(const Table &table, Value *indexPlane) {
    const Lanes &lanes = code_.lanes;
    auto *mask = code_.masks.current();
    auto *firstLane =
        builder_.CreateBinaryIntrinsic(llvm::Intrinsic::cttz, lanes.bits(mask), builder_.getTrue());
    auto *stride = builder_.getInt32(table.stride);
    auto *index = builder_.CreateMul(lanes.maskedLoad(code_.integerType, indexPlane, mask),
                                     lanes.splat(stride));
    auto *first = builder_.CreateMul(
        builder_.CreateLoad(code_.integerType,
                            builder_.CreateGEP(code_.integerType, indexPlane, firstLane)),
        stride);
    auto *same = builder_.CreateICmpEQ(index, lanes.splat(first));
    auto *together = code_.block("together"), *apart = code_.block("apart"),
         *join = code_.block("gathered");
    builder_.CreateCondBr(lanes.all(builder_.CreateOr(same, builder_.CreateNot(mask))), together,
                          apart);
    return {index, first, together, apart, join};
}

Values Gathers::broadcastOrGather(const Table &table, Value *base, Value *indexPlane) {
    Indices at = indices(table, indexPlane);
    builder_.SetInsertPoint(at.together);
    const Values shared = broadcast(table, builder_.CreateGEP(code_.floatType, base, at.first));
    builder_.CreateBr(at.join);
    builder_.SetInsertPoint(at.apart);
    const Values gathered = gather(table, base, at.each);
    at.apart = builder_.GetInsertBlock();
    builder_.CreateBr(at.join);
    builder_.SetInsertPoint(at.join);
    Values values;
    for (std::size_t k = 0; k < shared.size(); ++k) {
        auto *phi = builder_.CreatePHI(code_.lanes.varying(code_.floatType), 2);
        phi->addIncoming(shared[k], at.together);
        phi->addIncoming(gathered[k], at.apart);
        values.push_back(phi);
    }
    return values;
}

Value *Gathers::gatherOneByOne(Value *base, Value *index, Value *place) {
    auto *from = builder_.CreateGEP(code_.floatType, base, place);
    Value *elements = llvm::PoisonValue::get(code_.lanes.varying(code_.floatType));
    for (int k = 0; k < code_.lanes.width(); ++k) {
        auto *own = builder_.CreateExtractElement(index, std::uint64_t(k));
        auto *element =
            code_.invariantLoad(code_.floatType, builder_.CreateGEP(code_.floatType, from, own));
        elements = builder_.CreateInsertElement(elements, element, std::uint64_t(k));
    }
    return elements;
}

/// The code is as short for thousands of parameters as for one.
void Gathers::loadIntoRows(const Table &table, Value *rows) {
    const Lanes &lanes = code_.lanes;
    std::vector<std::uint32_t> places;
    for (const auto &[place, value] : table.loaded)
        places.push_back(std::uint32_t(place));
    auto *all = llvm::ConstantDataArray::get(code_.module.getContext(), places);
    const auto eachRow = [&](const std::function<Value *(Value * place)> &elements) {
        code_.repeat(int(places.size()), "row", [&](Value *row) {
            lanes.store(lanes.splat(elements(code_.constantAt(all, row))),
                        builder_.CreateGEP(lanes.varying(code_.floatType), rows, row));
        });
    };
    auto *base = arguments_.fieldPointer(table.baseField);
    auto *indexPlane = arguments_.plane({table.indexField});
    const auto share = [&](Value *index) {
        auto *origin = builder_.CreateGEP(code_.floatType, base, index);
        eachRow([&](Value *place) {
            return code_.invariantLoad(code_.floatType,
                                       builder_.CreateGEP(code_.floatType, origin, place));
        });
    };
    if (lanes.width() == 1)
        return share(builder_.CreateMul(builder_.CreateLoad(code_.integerType, indexPlane),
                                        builder_.getInt32(table.stride)));
    const Indices at = indices(table, indexPlane);
    builder_.SetInsertPoint(at.together);
    share(at.first);
    builder_.CreateBr(at.join);
    builder_.SetInsertPoint(at.apart);
    eachRow([&](Value *place) { return gatherOneByOne(base, at.each, place); });
    builder_.CreateBr(at.join);
    builder_.SetInsertPoint(at.join);
}

void Gathers::load(Table &table) {
    if (table.loaded.empty())
        return;
    const Lanes &lanes = code_.lanes;
    auto *base = arguments_.fieldPointer(table.baseField);
    auto *indexPlane = arguments_.plane({table.indexField});
    Values values;
    if (lanes.width() > 1) {
        values = broadcastOrGather(table, base, indexPlane);
    } else {
        auto *index = builder_.CreateMul(builder_.CreateLoad(code_.integerType, indexPlane),
                                         builder_.getInt32(table.stride));
        values = broadcast(table, builder_.CreateGEP(code_.floatType, base, index));
    }
    std::size_t next = 0;
    for (auto &[place, value] : table.loaded)
        value = values[next++];
}

} // namespace candela::codegen

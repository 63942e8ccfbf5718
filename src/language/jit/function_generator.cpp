// SPDX-License-Identifier: Apache-2.0
// The loop over blocks of points, and which part of the generator an instruction belongs to.
#include "language/jit/function_generator.h"

#include "foundation/units/color.h"
#include "language/ir/core/op_info.h"
#include "language/jit/arithmetic.h"
#include "language/jit/array_memory.h"
#include "language/jit/function_pieces.h"
#include "language/jit/gathers.h"
#include "language/jit/light_loop.h"
#include "language/runtime/shader_abi.h"

#include <cstddef>
#include <optional>
#include <utility>

namespace candela {
namespace codegen {
namespace {

using ir::Instruction;
using ir::Op;
using ir::OpClass;
using ir::Rate;
using ir::Region;

class FunctionGenerator {
public:
    FunctionGenerator(const ir::Function &, const CodeTarget &, const std::string &symbol,
                      llvm::Module &);

    void generate();

private:
    void emitBody(Value *mask);
    void emitRegion(const Region &);
    /// The machine function that is being written, and what it knows of its surroundings.
    struct Standing {
        llvm::Function *function;
        ShaderArguments::Place place;
        Value *spills;
        Values turns, arrays;
    };
    /// Makes another one the current one; gives that until now.
    Standing exchangeStanding(Standing);
    /// Writes a piece of the region as a machine function of its own, and calls it.
    void emitPiece(const Region &, const Piece &);
    void loadAtHead(const Region &);
    void emit(const Instruction &);
    void emitControl(const Instruction &);
    /// Of values alone.
    Value *operation(const Instruction &);
    /// The results of what takes a value from outside; none of other instructions.
    Values source(const Instruction &);
    Value *load(std::size_t tableField, int plane);
    Value *answersRequest(int request);
    /// Arrays, outputs, the frame, and calls, which read and write too.
    void emitMemory(const Instruction &);

    const ir::Function &function_;
    CodeFunction code_;
    const FunctionPieces pieces_;
    std::optional<SpillArea> spills_; ///< If there are pieces.
    llvm::IRBuilder<> &builder_;
    ValueTable values_;
    ShaderArguments arguments_;
    Gathers gathers_;
    RuntimeCalls calls_;
    TurnLimit limit_;
    ArrayMemory arrays_;
    ControlFlow control_;
};

FunctionGenerator::FunctionGenerator(const ir::Function &function, const CodeTarget &target,
                                     const std::string &symbol, llvm::Module &module)
    : function_(function), code_(target, module, symbol),
      pieces_(cutIntoPieces(function, target.longestFunction)), builder_(code_.builder),
      values_(function, code_.lanes), arguments_(code_), gathers_(code_, arguments_, function.body),
      calls_(code_, arguments_, values_), limit_(code_, values_, calls_),
      arrays_(code_, values_, calls_, limit_),
      control_(code_, values_, limit_, [this](const Region &region) { emitRegion(region); }) {
    code_.colorSamples = function.colors.samples;
    if (!pieces_.whole())
        values_.keepIn(spills_.emplace(code_, pieces_.slot, pieces_.slots));
}

void FunctionGenerator::generate() {
    auto *count = arguments_.field(offsetof(ShaderArgs, count), code_.integerType);
    auto *prepare = code_.block("prepare"), *head = code_.block("block"),
         *body = code_.block("body"), *next = code_.block("next"), *done = code_.block("done");
    builder_.CreateCondBr(builder_.CreateICmpSGT(count, builder_.getInt32(0)), prepare, done);
    builder_.SetInsertPoint(prepare);
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    auto *base = builder_.CreatePHI(code_.integerType, 2, "base");
    base->addIncoming(builder_.getInt32(0), prepare);
    arguments_.enterBlock(prepare, base);
    auto *number = builder_.CreateAdd(code_.lanes.splat(base), code_.lanes.laneNumbers());
    auto *inside = builder_.CreateICmpSLT(number, code_.lanes.splat(count));
    auto *mask = builder_.CreateAnd(inside, arguments_.blockMask(), "full_mask");
    builder_.CreateCondBr(code_.lanes.any(mask), body, next);

    builder_.SetInsertPoint(body);
    emitBody(mask);
    builder_.CreateBr(next);

    builder_.SetInsertPoint(next);
    auto *nextBase = builder_.CreateAdd(base, builder_.getInt32(code_.lanes.width()));
    base->addIncoming(nextBase, next);
    builder_.CreateCondBr(builder_.CreateICmpSLT(nextBase, count), head, done);

    builder_.SetInsertPoint(done);
    builder_.CreateRetVoid();
    if (spills_)
        spills_->finish();
}

void FunctionGenerator::emitBody(Value *mask) {
    MaskStack::Scope scope(code_.masks, mask);
    arrays_.clear();
    limit_.begin();
    gathers_.load();
    if (spills_)
        loadAtHead(function_.body);
    emitRegion(function_.body);
}

void FunctionGenerator::loadAtHead(const Region &region) {
    for (const Instruction &i : region.body) {
        const Values given = isLoadedAtHead(i.op) ? source(i) : Values();
        for (std::size_t k = 0; k < given.size(); ++k)
            values_.set(i.results[k], given[k]);
        for (const Region &inner : i.regions)
            loadAtHead(inner);
    }
}

void FunctionGenerator::emitRegion(const Region &region) {
    if (const auto cut = pieces_.cut.find(&region); cut != pieces_.cut.end()) {
        for (const Piece &piece : cut->second)
            emitPiece(region, piece);
        return;
    }
    for (const Instruction &i : region.body)
        emit(i);
}

void FunctionGenerator::emitPiece(const Region &region, const Piece &piece) {
    Values given{arguments_.pointer(), arguments_.firstPoint(),
                 code_.lanes.bits(code_.masks.current()), spills_->base()};
    const Values turns = limit_.memory();
    given.insert(given.end(), turns.begin(), turns.end());
    given.insert(given.end(), arrays_.memory().begin(), arrays_.memory().end());
    std::vector<llvm::Type *> types;
    for (Value *each : given)
        types.push_back(each->getType());
    llvm::Function *function = code_.addPiece(types);
    builder_.CreateCall(function, given);

    llvm::IRBuilder<>::InsertPointGuard guard(builder_);
    auto *prepare = llvm::BasicBlock::Create(code_.module.getContext(), "prepare", function);
    auto *start = llvm::BasicBlock::Create(code_.module.getContext(), "piece", function);
    builder_.SetInsertPoint(prepare);
    builder_.CreateBr(start);
    builder_.SetInsertPoint(start);
    Values taken;
    for (llvm::Argument &argument : function->args())
        taken.push_back(&argument);
    MaskStack::Scope scope(code_.masks, code_.lanes.maskOfBits(taken[2]));
    const auto turnsEnd = taken.begin() + 4 + std::ptrdiff_t(turns.size());
    Standing caller = exchangeStanding({function,
                                        {taken[0], taken[1], prepare, {}},
                                        taken[3],
                                        {taken.begin() + 4, turnsEnd},
                                        {turnsEnd, taken.end()}});
    for (std::size_t at = piece.begin; at < piece.end; ++at)
        emit(region.body[at]);
    builder_.CreateRetVoid();
    exchangeStanding(std::move(caller));
}

FunctionGenerator::Standing FunctionGenerator::exchangeStanding(Standing next) {
    return {std::exchange(code_.function, next.function),
            arguments_.exchangePlace(std::move(next.place)), spills_->exchangeBase(next.spills),
            limit_.exchangeMemory(next.turns), arrays_.exchangeMemory(std::move(next.arrays))};
}

void FunctionGenerator::emit(const Instruction &i) {
    if (spills_ && isLoadedAtHead(i.op))
        return;
    switch (ir::info(i.op).kind) {
    case OpClass::Arithmetic:
    case OpClass::Transcendental:
    case OpClass::Comparison:
    case OpClass::Logic:
    case OpClass::Choice:
    case OpClass::Conversion: return values_.set(i.results[0], operation(i));
    case OpClass::Control: return emitControl(i);
    default: break;
    }
    const Values given = source(i);
    for (std::size_t k = 0; k < given.size(); ++k)
        values_.set(i.results[k], given[k]);
    if (given.empty())
        emitMemory(i);
}

Value *FunctionGenerator::operation(const Instruction &i) {
    const Rate rate = values_.rate(i.results[0]);
    const auto operand = [&](int k) { return values_.get(i.operands[k], rate); };
    if (!ir::isFloatArithmetic(i.op))
        return logicOperation(code_, i.op, rate, operand);
    auto *a = operand(0), *b = operand(int(i.operands.size()) - 1);
    return floatOperation(code_, i.op, a, b);
}

void FunctionGenerator::emitControl(const Instruction &i) {
    if (i.op == Op::LightLoop)
        LightLoop(code_, arguments_, values_, i).emit([this](const Region &region) {
            emitRegion(region);
        });
    else if (i.op == Op::Loop)
        control_.emitLoop(i);
    else
        control_.emitIf(i);
}

Value *FunctionGenerator::load(std::size_t tableField, int plane) {
    return code_.lanes.load(code_.floatType, arguments_.plane(tableField, plane));
}

Value *FunctionGenerator::answersRequest(int request) {
    auto *plane = builder_.CreateGEP(code_.integerType,
                                     arguments_.fieldPointer(offsetof(ShaderArgs, answeredRequest)),
                                     arguments_.firstPoint());
    auto *answered = code_.lanes.maskedLoad(code_.integerType, plane, code_.masks.current());
    return builder_.CreateICmpEQ(answered, code_.lanes.splat(builder_.getInt32(request)));
}

Values FunctionGenerator::source(const Instruction &i) {
    switch (i.op) {
    case Op::ConstFloat:
        return {llvm::ConstantFP::get(code_.module.getContext(), llvm::APFloat(i.number))};
    case Op::ConstBool: return {builder_.getInt1(i.immediate != 0)};
    case Op::ConstInteger: return {builder_.getInt32(i.immediate)};
    case Op::ConstString: return {calls_.string(i.immediate)};
    case Op::Input: return {load(offsetof(ShaderArgs, inputs), i.immediate)};
    case Op::Variable: return {load(offsetof(ShaderArgs, variables), i.immediate)};
    case Op::Parameter: return {gathers_.parameter(i.immediate)};
    case Op::Space: return arguments_.spaceMatrix(i.immediate, false);
    case Op::SpaceInverse: return arguments_.spaceMatrix(i.immediate, true);
    case Op::Object: return gathers_.objectMatrix(false);
    case Op::ObjectInverse: return gathers_.objectMatrix(true);
    case Op::Random: {
        auto *seeds = arguments_.plane(offsetof(ShaderArgs, inputs), int(ShaderInput::seed));
        return {randomNumber(code_, code_.lanes.load(code_.integerType, seeds), i.immediate,
                             values_.get(i.operands[0], Rate::Varying))};
    }
    case Op::FrameLoad:
        return {code_.lanes.load(code_.floatType,
                                 arguments_.frameSlot(i.immediate, function_.frameSlots))};
    case Op::AnsweredRequest: return {answersRequest(i.immediate)};
    case Op::CategoryAccepts:
        return {acceptedByCategory(code_, arguments_, i.immediate, arguments_.firstPoint())};
    case Op::Answer:
        return arguments_.color(offsetof(ShaderArgs, answers), i.immediate * code_.colorSamples);
    case Op::Ambient: return arguments_.color(offsetof(ShaderArgs, ambient), 0);
    case Op::Irradiance: return arguments_.color(offsetof(ShaderArgs, irradiance), 0);
    default: return {};
    }
}

void FunctionGenerator::emitMemory(const Instruction &i) {
    switch (i.op) {
    case Op::ArrayLoad: return values_.set(i.results[0], arrays_.load(i));
    case Op::ArrayStore: return arrays_.store(i);
    case Op::Call: return calls_.call(i);
    case Op::Print: {
        MaskStack::Scope scope(code_.masks, limit_.running(code_.masks.current()));
        return calls_.print(i);
    }
    case Op::EmissionCone: return; // For Question::Emission.
    case Op::Output:
        return code_.lanes.maskedStore(
            limit_.whereRunning(values_.get(i.operands[0], Rate::Varying),
                                function_.outputs[i.immediate].whenEnded),
            arguments_.plane(offsetof(ShaderArgs, outputs), i.immediate), code_.masks.current());
    case Op::FrameStore: {
        auto *value = values_.get(i.operands[0], Rate::Varying);
        if (value->getType()->isIntOrIntVectorTy())
            value = builder_.CreateUIToFP(value, code_.lanes.varying(code_.floatType));
        return code_.lanes.maskedStore(limit_.whereRunning(value, 0),
                                       arguments_.frameSlot(i.immediate, function_.frameSlots),
                                       code_.masks.current());
    }
    default: return;
    }
}

} // namespace
} // namespace codegen

void generateFunction(const ir::Function &function, const CodeTarget &target,
                      const std::string &symbol, llvm::Module &module) {
    codegen::FunctionGenerator(function, target, symbol, module).generate();
}

} // namespace candela

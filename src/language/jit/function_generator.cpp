// SPDX-License-Identifier: Apache-2.0
// The loop over blocks of points, and which part of the generator an instruction belongs to.
#include "language/jit/function_generator.h"

#include "foundation/units/color.h"
#include "language/ir/core/op_info.h"
#include "language/jit/arithmetic.h"
#include "language/jit/array_memory.h"
#include "language/jit/earlier_lanes.h"
#include "language/jit/function_pieces.h"
#include "language/jit/gathers.h"
#include "language/jit/image_access.h"
#include "language/jit/light_loop.h"
#include "language/jit/service_calls.h"
#include "language/runtime/shader_abi.h"

#include <cstddef>
#include <optional>
#include <span>
#include <utility>

namespace candela {
namespace codegen {
namespace {

using ir::Instruction;
using ir::Op;
using ir::OpClass;
using ir::Region;
using ir::Uniformity;

struct PlaneStore {
    Value *value, *to;
};

bool isStore(const Instruction &i) { return i.op == Op::Output || i.op == Op::FrameStore; }

PlaneStore planeStore(CodeFunction &code, ShaderArguments &arguments, const ValueTable &values,
                      const TurnLimit &limit, const Instruction &i) {
    auto *value = values.get(i.operands[0], Uniformity::Varying);
    if (i.op == Op::Output)
        return {limit.whereRunning(value, values.function().outputs[i.immediate].whenEnded),
                arguments.plane({offsetof(ShaderArgs, outputs), i.immediate})};
    if (value->getType()->isIntOrIntVectorTy())
        value = code.builder.CreateUIToFP(value, code.lanes.varying(code.floatType));
    return {limit.whereRunning(value, 0),
            arguments.slotToSave(ir::spillSlot(values.function(), i.immediate))};
}

/// Stores in a row. Where masking costs, one test, `allRun`, finds out whether all lanes run.
void emitStores(CodeFunction &code, const std::vector<PlaneStore> &stores, Value *allRun) {
    const auto storeMasked = [&] {
        for (const PlaneStore &store : stores)
            code.lanes.maskedStore(store.value, store.to, code.masks.current());
    };
    if (stores.size() < 2 || !code.masks.isWhole() || !code.lanes.maskingCosts()) {
        storeMasked();
        return;
    }
    auto *whole = code.block("store_all"), *part = code.block("store_some"),
         *join = code.block("stored");
    code.builder.CreateCondBr(allRun, whole, part);
    code.builder.SetInsertPoint(whole);
    for (const PlaneStore &store : stores)
        code.lanes.store(store.value, store.to);
    code.builder.CreateBr(join);
    code.builder.SetInsertPoint(part);
    storeMasked();
    code.builder.CreateBr(join);
    code.builder.SetInsertPoint(join);
}

class FunctionGenerator {
public:
    FunctionGenerator(const ir::Function &, const CodeTarget &, const std::string &symbol,
                      llvm::Module &);

    void generate();

private:
    void emitRegion(const Region &);
    void emitAll(std::span<const Instruction>);
    /// The machine function that is being written, and what it knows of its surroundings.
    struct Standing {
        llvm::Function *function;
        ShaderArguments::Place place;
        MaskStack::Masks masks;
        Value *allRun;
        Value *spills;
        Values turns, arrays;
    };
    /// Makes another one the current one; gives that until now.
    Standing exchangeStanding(Standing);
    /// Writes a piece of a region as a machine function of its own, and calls it.
    void emitPiece(std::span<const Instruction>);
    void loadAtHead(const Region &);
    bool parametersInMemory() const { return !pieces_.parametersInMemory.empty(); }
    void emit(const Instruction &);
    void emitControl(const Instruction &);
    /// Of values alone.
    Value *operation(const Instruction &);
    /// The results of what takes a value from outside; none of other instructions.
    Values source(const Instruction &);
    Value *answersRequest(int request);
    /// Arrays, and calls, which read and write too.
    void emitMemory(const Instruction &);

    const ir::Function &function_;
    CodeFunction code_;
    const FunctionPieces pieces_;
    std::optional<SpillArea> spills_; ///< If anything has a slot.
    llvm::IRBuilder<> &builder_;
    ValueTable values_;
    ShaderArguments arguments_;
    EarlierLanes earlier_;
    Gathers gathers_;
    ConstantStrings strings_;
    RuntimeCalls calls_;
    ServiceCalls services_;
    TurnLimit limit_;
    ArrayMemory arrays_;
    ImageAccess images_;
    ControlFlow control_;
    Value *allRun_ = nullptr; ///< Do all lanes run where the machine function begins?
};

FunctionGenerator::FunctionGenerator(const ir::Function &function, const CodeTarget &target,
                                     const std::string &symbol, llvm::Module &module)
    : function_(function), code_(target, module, symbol),
      pieces_(cutIntoPieces(function, target.longestFunction)), builder_(code_.builder),
      values_(function, code_.lanes), arguments_(code_), earlier_(code_, arguments_, function),
      gathers_(code_, arguments_, function.body), strings_(code_, function),
      calls_(code_, arguments_, values_, strings_, pieces_),
      services_(code_, arguments_, values_, strings_), limit_(code_, values_, calls_),
      arrays_(code_, values_, calls_, limit_, arguments_),
      images_(code_, arguments_, values_, limit_, arrays_),
      control_(code_, values_, limit_, [this](const Region &region) { emitRegion(region); }) {
    code_.colorSamples = function.colors.samples;
    code_.fusesProducts = function.isFused;
    if (pieces_.hasSlots())
        values_.keepIn(spills_.emplace(code_, pieces_));
}

static Value *allLanesIn(CodeFunction &code, Value *bits) {
    const auto all = ~0u >> (32 - code.lanes.width());
    return code.builder.CreateICmpEQ(bits, code.builder.getInt32(all), "all_run");
}

void FunctionGenerator::generate() {
    auto *count = arguments_.field(offsetof(ShaderArgs, count), code_.integerType);
    auto *prepare = code_.block("prepare"), *head = code_.block("block"),
         *body = code_.block("body"), *next = code_.block("next"), *done = code_.block("done");
    builder_.CreateCondBr(builder_.CreateICmpSGT(count, builder_.getInt32(0)), prepare, done);
    builder_.SetInsertPoint(prepare);
    earlier_.begin();
    builder_.CreateBr(head);

    builder_.SetInsertPoint(head);
    auto *base = builder_.CreatePHI(code_.integerType, 2, "base");
    base->addIncoming(builder_.getInt32(0), prepare);
    arguments_.enterBlock(prepare, base);
    auto *bits = arguments_.blockBits(count);
    builder_.CreateCondBr(builder_.CreateIsNotNull(bits), body, next);

    builder_.SetInsertPoint(body);
    allRun_ = allLanesIn(code_, bits);
    {
        MaskStack::Scope scope(code_.masks, code_.lanes.maskOf(bits));
        arrays_.clear();
        limit_.begin();
        earlier_.load();
        gathers_.load(parametersInMemory() ? spills_->base() : nullptr);
        if (spills_)
            loadAtHead(function_.body);
        emitRegion(function_.body);
    }
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

void FunctionGenerator::loadAtHead(const Region &region) {
    for (const Instruction &i : region.body) {
        const bool loads = isLoadedAtHead(i.op) && !(i.op == Op::Parameter && parametersInMemory());
        const Values given = loads ? source(i) : Values();
        for (std::size_t k = 0; k < given.size(); ++k)
            values_.set(i.results[k], given[k]);
        for (const Region &inner : i.regions)
            loadAtHead(inner);
    }
}

void FunctionGenerator::emitRegion(const Region &region) {
    const std::span<const Instruction> body = region.body;
    const auto cut = pieces_.cut.find(&region);
    if (cut == pieces_.cut.end())
        return emitAll(body);
    for (const Piece &piece : cut->second)
        emitPiece(body.subspan(piece.begin, piece.end - piece.begin));
}

void FunctionGenerator::emitAll(std::span<const Instruction> instructions) {
    const auto end = instructions.end();
    for (auto i = instructions.begin(); i != end;) {
        if (i->op == Op::ArrayStore)
            if (const std::size_t known = arrays_.storeKnown({i, end})) {
                i += std::ptrdiff_t(known);
                continue;
            }
        if (!isStore(*i)) {
            emit(*i++);
            continue;
        }
        std::vector<PlaneStore> stores;
        for (; i != end && isStore(*i); ++i)
            stores.push_back(planeStore(code_, arguments_, values_, limit_, *i));
        emitStores(code_, stores, allRun_);
    }
}

void FunctionGenerator::emitPiece(std::span<const Instruction> instructions) {
    Values given{arguments_.pointer(), arguments_.firstPoint(), code_.masks.currentBits(),
                 spills_->base()};
    if (arguments_.rows())
        given.push_back(arguments_.rows());
    const auto fixed = std::ptrdiff_t(given.size());
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
    const auto turnsBegin = taken.begin() + fixed;
    const auto turnsEnd = turnsBegin + std::ptrdiff_t(turns.size());
    Standing caller =
        exchangeStanding({function,
                          {taken[0], taken[1], prepare, fixed > 4 ? taken[4] : nullptr},
                          {code_.lanes.kept(code_.lanes.maskOf(taken[2]))},
                          allLanesIn(code_, taken[2]),
                          taken[3],
                          {turnsBegin, turnsEnd},
                          {turnsEnd, taken.end()}});
    emitAll(instructions);
    builder_.CreateRetVoid();
    exchangeStanding(std::move(caller));
}

FunctionGenerator::Standing FunctionGenerator::exchangeStanding(Standing next) {
    return {std::exchange(code_.function, next.function),
            arguments_.exchangePlace(std::move(next.place)),
            code_.masks.exchange(std::move(next.masks)),
            std::exchange(allRun_, next.allRun),
            spills_->exchangeBase(next.spills),
            limit_.exchangeMemory(next.turns),
            arrays_.exchangeMemory(std::move(next.arrays))};
}

void FunctionGenerator::emit(const Instruction &i) {
    if (spills_ && isLoadedAtHead(i.op))
        return;
    switch (ir::info(i.op).kind) {
    case OpClass::Arithmetic:
    case OpClass::Fused:
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
    const Uniformity uniformity = values_.uniformity(i.results[0]);
    const auto operand = [&](int k) { return values_.get(i.operands[k], uniformity); };
    if (i.op == Op::MulAdd)
        return fusedProduct(code_, operand(0), operand(1), operand(2));
    if (!ir::isFloatArithmetic(i.op))
        return logicOperation(code_, i.op, uniformity, operand);
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

Value *FunctionGenerator::answersRequest(int request) {
    auto *plane = builder_.CreateGEP(code_.integerType,
                                     arguments_.fieldPointer(offsetof(ShaderArgs, answeredRequest)),
                                     arguments_.firstPoint());
    auto *answered = code_.lanes.maskedLoad(code_.integerType, plane, code_.masks.current());
    return builder_.CreateICmpEQ(answered, code_.lanes.splat(builder_.getInt32(request)));
}

Values FunctionGenerator::source(const Instruction &i) {
    const auto load = [&](std::size_t tableField, int plane) {
        return code_.lanes.load(code_.floatType, arguments_.plane({tableField, plane}));
    };
    switch (i.op) {
    case Op::ConstFloat:
        return {llvm::ConstantFP::get(code_.module.getContext(), llvm::APFloat(i.number))};
    case Op::ConstBool: return {builder_.getInt1(i.immediate != 0)};
    case Op::ConstInteger: return {builder_.getInt32(i.immediate)};
    case Op::ConstString: return {strings_.value(i.immediate)};
    case Op::Input: return {load(offsetof(ShaderArgs, inputs), i.immediate)};
    case Op::Variable: return {load(offsetof(ShaderArgs, variables), i.immediate)};
    case Op::Parameter: return {gathers_.parameter(i.immediate)};
    case Op::Captured:
        return {code_.invariantLoad(
            code_.floatType,
            builder_.CreateConstGEP1_64(code_.floatType,
                                        arguments_.fieldPointer(offsetof(ShaderArgs, captured)),
                                        std::uint64_t(i.immediate)))};
    case Op::Space: return arguments_.spaceMatrix(i.immediate, false);
    case Op::SpaceInverse: return arguments_.spaceMatrix(i.immediate, true);
    case Op::Object: return gathers_.objectMatrix(false);
    case Op::ObjectInverse: return gathers_.objectMatrix(true);
    case Op::Random: {
        auto *seeds = arguments_.plane({offsetof(ShaderArgs, inputs), int(ShaderInput::seed)});
        return {randomNumber(code_, code_.lanes.load(code_.integerType, seeds), i.immediate,
                             values_.get(i.operands[0], Uniformity::Varying))};
    }
    case Op::FrameLoad:
        return {code_.lanes.load(code_.floatType,
                                 arguments_.slotToLoad(ir::spillSlot(function_, i.immediate)))};
    case Op::AnsweredRequest: return {answersRequest(i.immediate)};
    case Op::CategoryAccepts:
        return {code_.lanes.asMask(acceptedByCategory(
            code_, arguments_, i.immediate, arguments_.firstPoint(), code_.masks.current()))};
    case Op::SampleLight: return {lightNumber(code_, arguments_, arguments_.firstPoint())};
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
    case Op::ImageLoad: return images_.load(i);
    case Op::ImageStore: return images_.store(i);
    case Op::PixelLoop: return images_.runLoop(i);
    case Op::Query:
    case Op::Command: {
        MaskStack::Scope scope(code_.masks, limit_.running(code_.masks.current()));
        return services_.ask(i);
    }
    case Op::EmissionCone: return; // For Question::Emission.
    default: return;
    }
}

} // namespace
} // namespace codegen

void generateFunction(const ir::Function &function, const CodeTarget &target,
                      const std::string &symbol, llvm::Module &module) {
    CodeTarget own = target;
    own.registersTogether = function.registersTogether;
    codegen::FunctionGenerator(function, own, symbol, module).generate();
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// From ir::Function to one LLVM function, at any width.
#pragma once

#include "language/ir/ir.h"
#include "language/jit/code_target.h"
#include "language/jit/lanes.h"
#include "language/jit/mask_stack.h"
#include "language/runtime/vector_math.h"

#include <llvm/IR/Module.h>

#include <map>
#include <set>
#include <string>
#include <vector>

namespace candela {

/// The symbol under which generated code calls a runtime function, and printing.
std::string runtimeSymbol(int runtimeFunction, int width);
inline constexpr const char *printSymbol = "candela_print";
inline constexpr const char *indexOutsideSymbol = "candela_index_outside";

class FunctionGenerator {
public:
    FunctionGenerator(const ir::Function &, const CodeTarget &, llvm::Module &);

    /// Adds void symbol(const ShaderArgs *) to the module.
    void generate(const std::string &symbol);

private:
    using Value = llvm::Value;
    using Values = std::vector<llvm::Value *>;

    // function_generator.cpp: the frame about the body, and control.
    void declare(const std::string &symbol);
    void makeArrays();
    void clearArrays();
    void generateBlocks();
    Value *blockMask();
    void preloadGathers();
    void preload(const std::set<int> &used, std::map<int, Value *> &loaded, std::size_t baseField,
                 std::size_t indexField, int scale);
    void collectGathers(const ir::Region &);
    void emitRegion(const ir::Region &);
    void emitControl(const ir::Instruction &);
    void emitIf(const ir::Instruction &);
    Values emitBranch(const ir::Region &, Value *taken, const ir::Instruction &);
    void emitUniformIf(const ir::Instruction &);
    void emitLoop(const ir::Instruction &);
    void emitLightLoop(const ir::Instruction &);
    struct LightSample {
        Values L, Cl;
        Value *lanes; ///< Who takes it.
    };
    struct LightLoopPlan {
        const ir::LightRequest *request;
        Value *delta = nullptr; ///< Lanes of a delta request; null = none at all.
        Values coneAxis;        ///< Normalised; Classic only.
        Value *coneCosine = nullptr;
    };
    LightLoopPlan planLightLoop(const ir::Instruction &);
    LightSample deltaSample(const ir::Instruction &, const LightLoopPlan &);
    LightSample finiteSample(const LightLoopPlan &, Value *sample);
    LightSample nextSample(const ir::Instruction &, const LightLoopPlan &, Value *sample);
    Value *acceptedByCategory(int category, Value *row);
    Value *anyNonZero(const Values &color);
    Values normalized(const Values &);
    Value *dot(const Values &, const Values &);

    // operations.cpp: everything without regions.
    void emit(const ir::Instruction &);
    bool emitSource(const ir::Instruction &);
    bool emitLogic(const ir::Instruction &);
    void emitRest(const ir::Instruction &);
    Value *emitFloat(const ir::Instruction &);
    Value *emitTranscendental(ir::Op, Value *a, Value *b);
    Value *callMath(runtime::MathFunction, const Values &arguments);
    Value *clampToUnit(Value *);
    Value *power(Value *base, Value *exponent);
    Value *intrinsic(unsigned id, Value *);
    Value *like(Value *model, float);
    Value *randomNumber(int immediate);
    void emitCall(const ir::Instruction &);
    void emitPrint(const ir::Instruction &);
    void emitIndexCheck(const ir::Instruction &, Value *raw, Value *clamped);
    Value *elementAddress(const ir::Instruction &, Value *&index);
    Value *loadElement(const ir::Instruction &);
    void storeElement(const ir::Instruction &);
    Value *frameAddress(int slot);
    /// colorSamples planes from `first` on of a table that may be null: black then.
    Values loadColor(std::size_t tableField, int first);
    void loadMatrix(const ir::Instruction &, bool inverse);

    // Small tools.
    Value *get(ir::ValueId, ir::Rate);
    Values get(const std::vector<ir::ValueId> &, ir::Rate);
    void set(ir::ValueId, Value *);
    ir::Rate rate(ir::ValueId v) const { return function_.values[v].rate; }
    ir::Rate resultRate(const ir::Instruction &i) const { return rate(i.results[0]); }
    /// A field of ShaderArgs; fields and tables never change during a call.
    Value *field(std::size_t offset, llvm::Type *);
    Value *fieldPointer(std::size_t offset);
    Value *constantLoad(llvm::Type *, Value *from);
    /// table[index] + base: where the block's lanes stand in a plane. The plane is looked up
    /// before the loop over blocks, where the table can't be null.
    Value *planeBlock(std::size_t tableField, int index);
    /// The same, looked up here and now.
    Value *planeBlockHere(std::size_t tableField, int index);
    Value *entryAlloca(llvm::Type *, int count, const char *name);
    llvm::BasicBlock *block(const char *name);
    llvm::FunctionCallee external(const std::string &name, llvm::FunctionType *, bool pure);
    Value *globalText(const std::string &bytes);

    const ir::Function &function_;
    const CodeTarget &target_;
    llvm::Module &module_;
    llvm::IRBuilder<> builder_;
    Lanes lanes_;
    MaskStack masks_;

    llvm::Function *code_ = nullptr;
    Value *args_ = nullptr;
    Value *base_ = nullptr;               ///< First point of the block.
    llvm::BasicBlock *prepare_ = nullptr; ///< Runs once, before the first block, if there is one.
    std::map<std::pair<std::size_t, int>, Value *> planes_; ///< Looked up in prepare_.
    Values values_;                                         ///< By ValueId.
    std::vector<llvm::AllocaInst *> arrays_;
    Value *callInputs_ = nullptr, *callOutputs_ = nullptr;
    /// What is gathered at the head of each block: parameters, and object matrix elements.
    std::set<int> parametersUsed_, objectElementsUsed_;
    std::map<int, Value *> parameters_, objectElements_;
    std::vector<int> stringOffset_; ///< Of Function::strings, in stringBlob_; equal texts agree.
    std::string stringBlob_;
    llvm::Type *float_, *integer_, *pointer_;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// LightLoop: a region that runs once for each sample of light that the caller gives, in the lanes
// which the request's cones and category let it reach.
#pragma once

#include "language/jit/control_flow.h"
#include "language/jit/shader_arguments.h"
#include "language/jit/value_table.h"

namespace candela::codegen {

/// Of the lanes `among`, those whose light in a row of samples, which begins at element `row`, a
/// category accepts: categoryAccepts[category * (lightCount + 1) + light] != 0. As they are kept.
Value *acceptedByCategory(CodeFunction &, ShaderArguments &, int category, Value *row,
                          Value *among);

/// ShaderArgs::sampleLight of a row of samples, which begins at element `row`, as floats.
Value *lightNumber(CodeFunction &, ShaderArguments &, Value *row);

/// One such loop.
class LightLoop {
public:
    LightLoop(CodeFunction &, ShaderArguments &, ValueTable &, const ir::Instruction &);

    void emit(const EmitRegion &);

private:
    struct Sample {
        Values L, Cl;
        Value *number; ///< Of the light.
        Value *lanes;  ///< Who takes it.
    };
    void findCones();
    void findPlanes(Value *sampleCount);
    Value *firstNumber();
    /// The loop's sample of that number; number -1 is the delta request's.
    Sample sample(Value *number);
    /// Delta requests see their own traced answer, along their first axis.
    Sample deltaSample();
    Sample finiteSample(Value *number);
    /// What the loop carries, at its head; it has these values when it comes from `from`.
    std::vector<llvm::PHINode *> carry(const Values &initial, llvm::BasicBlock *from);
    /// Runs the region for a sample; what the loop carries on.
    Values run(const Sample &, const Values &carried, const EmitRegion &);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ShaderArguments &arguments_;
    ValueTable &values_;
    const ir::Instruction &instruction_;
    const ir::LightRequest &request_;
    bool readsNumber_;       ///< The region wants to know which light it is.
    Value *delta_ = nullptr; ///< Lanes of a delta request; null = none at all.
    Values coneAxis_;        ///< Classic only, as the cone's cosine.
    Value *coneCosine_ = nullptr;
    Values samplePlanes_; ///< Of L, then of Cl.
};

} // namespace candela::codegen

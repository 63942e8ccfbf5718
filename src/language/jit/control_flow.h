// SPDX-License-Identifier: Apache-2.0
// If and Loop. Uniform control is plain control; varying control runs regions in the lanes that
// take them.
#pragma once

#include "language/jit/turn_limit.h"

#include <functional>

namespace candela::codegen {

/// Writes the instructions of a region where the builder stands.
using EmitRegion = std::function<void(const ir::Region &)>;

class ControlFlow {
public:
    ControlFlow(CodeFunction &, ValueTable &, TurnLimit &, EmitRegion);

    void emitIf(const ir::Instruction &);
    /// A varying loop goes on until no lane is active; a lane that has finished keeps its values.
    void emitLoop(const ir::Instruction &);

private:
    void emitUniformIf(const ir::Instruction &);
    void emitVaryingIf(const ir::Instruction &);
    /// Runs a branch of a varying If in the `taken` lanes, skipping it if there is none. Returns
    /// what it yields, meaningless in other lanes.
    Values emitBranch(const ir::Region &, Value *taken, const ir::Instruction &owner);
    /// What a region yields for the results of its owner.
    Values yields(const ir::Region &, const ir::Instruction &owner) const;

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ValueTable &values_;
    TurnLimit &limit_;
    EmitRegion emitRegion_;
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
// What a batch of views reads of its points, and a batch of responses of its views and points: it
// stands at the lanes that ShaderArgs::surfaceLane and viewLane name. Where they name none, code
// reads it where it stands, as all else. Else what is read is gathered at the head of a block into
// rows of memory, one for a plane or a slot, and code reads the rows: nothing but addresses
// differs.
#pragma once

#include "language/jit/shader_arguments.h"

#include <vector>

namespace candela::codegen {

class EarlierLanes {
public:
    /// For all that the function's body reads.
    EarlierLanes(CodeFunction &, ShaderArguments &, const ir::Function &);

    /// Makes the rows known to the arguments; before the first block.
    void begin();
    /// Gathers; at the head of a block.
    void load();

private:
    /// Of the block's lanes, or of one.
    struct Places {
        Value *view, *surface;
        Value *at(BindingTime time) const { return time == BindingTime::Surface ? surface : view; }
    };
    struct Row {
        ShaderArguments::PlaneName plane; ///< Or a frame's field.
        BindingTime time;
        int row;
        ir::SpillSlot slot; ///< Of a frame's; else `slots` is 0.
    };
    void collect(const ir::Region &, const ir::Function &);
    void addPlane(ShaderArguments::PlaneName, BindingTime);
    void addFrames(const ir::Function &);
    Value *base(const Row &);
    Value *index(const Row &, const Places &);
    Value *viewLanes();
    void gather(Value *view);
    void gatherInLoop(Value *view);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ShaderArguments &arguments_;
    const BindingTime lanes_;
    std::vector<Row> rows_;
    ShaderArguments::Rows known_;
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
// Ends loops that run for too long (Function::mostTurns), lane by lane: whether a lane's loop is
// ended depends on nothing but the lane.
//
// A lane that is active in a loop's turn has run all its turns before, so one number for all lanes
// counts the turns of a loop that stands alone. In loops within loops lanes come to different sums,
// which a vector counts; it is looked at only where the number for all has come to the limit.
#pragma once

#include "language/jit/runtime_calls.h"

namespace candela::codegen {

class TurnLimit {
public:
    TurnLimit(CodeFunction &, ValueTable &, RuntimeCalls &);

    /// Where turns are counted, as the machine function knows it that is being written; empty where
    /// no loop is counted.
    Values memory() const { return ended_ ? Values{all_, each_, ended_} : Values(); }
    /// Makes another function's pointers the current ones; gives those until now.
    Values exchangeMemory(const Values &memory);

    /// At the head of a block of points: no lane has been ended.
    void begin();
    /// Those of the lanes that have not been ended.
    Value *running(Value *lanes) const;
    /// What a lane stores: `ended` in those that have been ended.
    Value *whereRunning(Value *value, float ended) const;

    /// While it lives, the loop is being written. Turns of loops that end soon are not counted.
    class Scope {
    public:
        Scope(TurnLimit &, const ir::Instruction &loop);
        ~Scope();
        Scope(const Scope &) = delete;
        Scope &operator=(const Scope &) = delete;

        /// At the loop's head: those that go on of the lanes for which its condition holds.
        Value *running(Value *lanes) const;
        /// In a block of its own, before a turn of the lanes, of which there is one: the lanes that
        /// may take it. The builder then stands where they do; if there are none, at `done`.
        Value *take(Value *lanes, llvm::BasicBlock *done);

    private:
        TurnLimit &limit_;
        const ir::Instruction &loop_;
        bool counts_, contains_; ///< Whether it counts its turns, and has loops that do.
        Value *entered_ = nullptr;
    };

private:
    Value *countLanes(Value *lanes);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ValueTable &values_;
    RuntimeCalls &calls_;
    Value *all_ = nullptr;   ///< Memory: turns of any lane.
    Value *each_ = nullptr;  ///< Memory: turns of each lane, in loops within loops.
    Value *ended_ = nullptr; ///< Memory: a mask. Null where no loop is counted.
    int open_ = 0;           ///< Counted loops around.
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
// What stands at an index that each lane has its own: parameters and object matrices. Mostly all
// lanes of a block share one, an instance's: then they are loaded once and broadcast.
#pragma once

#include "language/jit/shader_arguments.h"

#include <map>

namespace candela::codegen {

class Gathers {
public:
    /// For all that the function's body asks for.
    Gathers(CodeFunction &, ShaderArguments &, const ir::Region &body);

    /// Loads it all; at the head of a block. If `rows` is given, parameters go there, in their
    /// order.
    void load(Value *rows);
    Value *parameter(int slot) const { return parameters_.loaded.at(slot); }
    /// The elements of the lanes' matrices from object space, or of their inverses.
    Values objectMatrix(bool inverse) const;

private:
    struct Table {
        std::size_t baseField, indexField; ///< Of ShaderArgs.
        int stride;                        ///< Floats from one index to the next.
        std::map<int, Value *> loaded;     ///< By place behind the index; those asked for.
    };
    void collect(const ir::Region &);
    void load(Table &);
    void loadIntoRows(const Table &, Value *rows);
    Values broadcast(const Table &, Value *origin);
    Values gather(const Table &, Value *base, Value *index);
    Values gatherInLoop(const Table &, Value *base, Value *index);
    /// The lanes' elements at `place`, one load a lane.
    Value *gatherOneByOne(Value *base, Value *index, Value *place);
    Values broadcastOrGather(const Table &, Value *base, Value *indexPlane);
    /// Where the elements of a block of points stand: each lane's index, and an active lane's, in
    /// floats; code then goes on where it is the same for all, or where it is not.
    struct Indices {
        Value *each, *first;
        llvm::BasicBlock *together, *apart, *join;
    };
    Indices indices(const Table &, Value *indexPlane);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    ShaderArguments &arguments_;
    Table parameters_, objectMatrices_;
};

} // namespace candela::codegen

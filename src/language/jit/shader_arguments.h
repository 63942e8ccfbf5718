// SPDX-License-Identifier: Apache-2.0
// What generated code is called with: the fields of ShaderArgs, the tables of planes that they
// point to, and where in a plane the block of W points stands that the code is at.
#pragma once

#include "language/jit/code_function.h"

#include <map>
#include <utility>

namespace candela::codegen {

class ShaderArguments {
public:
    explicit ShaderArguments(CodeFunction &);

    /// From here on code is about the block of points that begins with `firstPoint`. `prepare` runs
    /// once before the first block, if there is one.
    void enterBlock(llvm::BasicBlock *prepare, Value *firstPoint);
    Value *firstPoint() const { return place_.firstPoint; }
    /// A bit for each active lane of the block, of `count` points in all.
    Value *blockBits(Value *count);

    /// Where a machine function finds the arguments.
    struct Place {
        Value *pointer = nullptr;    ///< To ShaderArgs.
        Value *firstPoint = nullptr; ///< Of the block.
        llvm::BasicBlock *prepare = nullptr;
        std::map<std::pair<std::size_t, int>, Value *> planes; ///< Looked up in `prepare`.
    };
    /// From here on code stands in another machine function; gives the place until now.
    Place exchangePlace(Place place) { return std::exchange(place_, std::move(place)); }

    Value *pointer() const { return place_.pointer; }
    /// A field of ShaderArgs, by its offset; fields and tables never change during a call.
    Value *field(std::size_t offset, llvm::Type *);
    Value *fieldPointer(std::size_t offset);
    /// Where the block's lanes stand in plane `index` of a table, which can't be null. The first
    /// planes of a machine function are looked up before its loop over blocks.
    Value *plane(std::size_t tableField, int index);
    /// A colour's planes, from `first` on of a table that may be null: black then.
    Values color(std::size_t tableField, int first);
    /// A slot of the frame, which has `slots` for each group of 16 points.
    Value *spillSlot(int slot, int slots);
    /// The elements of a named coordinate system's matrix.
    Values spaceMatrix(int space, bool inverse);

private:
    /// As plane(), looked up here and now.
    Value *planeHere(std::size_t tableField, int index);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    Place place_;
};

} // namespace candela::codegen

// SPDX-License-Identifier: Apache-2.0
// What generated code is called with: the fields of ShaderArgs, the tables of planes that they
// point to, and where in a plane the block of W points stands that the code is at.
#pragma once

#include "language/jit/code_function.h"

#include <compare>
#include <cstddef>
#include <map>
#include <utility>

namespace candela::codegen {

/// Of ShaderArgs, by its offset.
std::size_t frameField(BindingTime frame);

class ShaderArguments {
public:
    explicit ShaderArguments(CodeFunction &);

    /// From here on code is about the block of points that begins with `firstPoint`. `prepare` runs
    /// once before the first block, if there is one.
    void enterBlock(llvm::BasicBlock *prepare, Value *firstPoint);
    Value *firstPoint() const { return place_.firstPoint; }
    /// A bit for each active lane of the block, of `count` points in all.
    Value *blockBits(Value *count);

    /// A plane: entry `index` of the table that a field points to, or (-1) what it points to.
    struct PlaneName {
        std::size_t field;
        int index = -1;
        auto operator<=>(const PlaneName &) const = default;
    };
    /// Planes and frames that code may read rows of memory for instead: see EarlierLanes.
    struct Rows {
        std::map<PlaneName, int> of; ///< The row of a plane; the first one of a frame.
        int count = 0;
        Value *memory = nullptr; ///< Of laneBlock floats each; null at run time = not now.
    };
    void readRows(const Rows &rows) { rows_ = rows.of, place_.rows = rows.memory; }

    /// Where a machine function finds the arguments.
    struct Place {
        Value *pointer = nullptr;    ///< To ShaderArgs.
        Value *firstPoint = nullptr; ///< Of the block.
        llvm::BasicBlock *prepare = nullptr;
        Value *rows = nullptr;                 ///< As Rows::memory; null if there never are any.
        std::map<PlaneName, Value *> planes{}; ///< Looked up in `prepare`.
    };
    /// From here on code stands in another machine function; gives the place until now.
    Place exchangePlace(Place place) { return std::exchange(place_, std::move(place)); }

    /// What `work` writes before the machine function's first block.
    template <typename Work> Value *atHead(Work work) {
        llvm::IRBuilder<>::InsertPointGuard guard(builder_);
        builder_.SetInsertPoint(place_.prepare->getTerminator());
        return work();
    }

    Value *pointer() const { return place_.pointer; }
    Value *rows() const { return place_.rows; }
    /// A field of ShaderArgs, by its offset; fields and tables never change during a call.
    Value *field(std::size_t offset, llvm::Type *);
    Value *fieldPointer(std::size_t offset);
    /// Where the block's lanes stand in plane `index` of a table, which can't be null. The first
    /// planes of a machine function are looked up before its loop over blocks.
    Value *plane(PlaneName);
    /// Where the plane begins, whatever rows there are.
    Value *planeStart(PlaneName);
    /// A colour's planes, from `first` on of a table that may be null: black then.
    Values color(std::size_t tableField, int first);
    /// A slot of a frame, to save in and to load from.
    Value *slotToSave(const ir::SpillSlot &);
    Value *slotToLoad(const ir::SpillSlot &);
    /// The elements of a named coordinate system's matrix.
    Values spaceMatrix(int space, bool inverse);

private:
    /// As plane(), looked up here and now.
    Value *planeHere(PlaneName);
    Value *areRowsRead() { return builder_.CreateIsNotNull(place_.rows); }
    Value *row(int number);

    CodeFunction &code_;
    llvm::IRBuilder<> &builder_;
    Place place_;
    std::map<PlaneName, int> rows_;
};

} // namespace candela::codegen

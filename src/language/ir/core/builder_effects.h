// SPDX-License-Identifier: Apache-2.0
// What stays in program order: arrays in memory, outputs.
#pragma once

#include "language/ir/core/builder.h"

#include <string>

namespace candela::ir {

int addArray(Builder &, Type, int size);
ValueId arrayLoad(Builder &, int array, ValueId index);
void arrayStore(Builder &, int array, ValueId index, ValueId value);

/// An output as code knows it.
OutputSlot outputSlot(const OutputName &, int component);
/// Numbers in all arrays of the function together.
std::size_t arrayNumbers(const Function &);

/// Adds the planes of an output of outputs.def.
void addOutputSlots(std::vector<OutputSlot> &, const OutputName &, int colorSamples);
/// The function gets the slot if it has none of that name and component yet.
void output(Builder &, const OutputName &, int component, ValueId);

} // namespace candela::ir

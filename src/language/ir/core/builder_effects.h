// SPDX-License-Identifier: Apache-2.0
// What stays in program order: arrays in memory, outputs, prints.
#pragma once

#include "language/ir/core/builder.h"

#include <string>

namespace candela::ir {

int addArray(Builder &, Type, int size);
ValueId arrayLoad(Builder &, int array, ValueId index);
void arrayStore(Builder &, int array, ValueId index, ValueId value);

/// The function gets the slot if it has none of that name and component yet.
void output(Builder &, const OutputName &, int component, ValueId);
void printValues(Builder &, const std::string &format, const Values &);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Derivatives of noise: one call gives the values and their slopes along the coordinates.
#pragma once

#include "language/ir/transform/jet_series.h"
#include "language/runtime/runtime_functions.h"

#include <vector>

namespace candela::ir {

/// The function to call in place of `function` where derivatives are wanted: its results are those
/// of `function` and then, if it has none itself, their slopes.
runtime::RuntimeFunction latticeWithSlopes(runtime::RuntimeFunction function);

/// The series of all results of a call of a function with slopes; `operands` are its operands.
/// Second derivatives are central differences of the slopes over 1/128 of a cell; beyond them none
/// may be asked for.
std::vector<Jet> ofLattice(Jets &, runtime::RuntimeFunction withSlopes,
                           const std::vector<Jet> &operands, const Values &results);

/// From this order on there are no derivatives of a result of `function`.
int firstRefusedOrder(runtime::RuntimeFunction, int result);

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// Over a box: noise and cell noise.
#pragma once

#include "language/ir/transform/bound_values.h"

#include <vector>

namespace candela::ir {

/// Of each result of noise or cell noise, those in the middle being `middles`.
std::vector<FormParts> boundOfNoise(Builder &, RuntimeFunction,
                                    const std::vector<BoundedValue> &inputs, const Values &middles);

} // namespace candela::ir

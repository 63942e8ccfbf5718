// SPDX-License-Identifier: Apache-2.0
// Derivatives of services that have a twin (runtime/services.def).
#pragma once

#include "language/ir/core/ir.h"
#include "language/ir/transform/jet_series.h"

#include <vector>

namespace candela::ir {

/// Asks the twin in the service's place: values, then derivatives by the first operand, then those
/// by the second.
Values askTwin(Builder &, const ServiceUse &, const Values &operands);

/// Of the values among the results of askTwin(): the chain rule, to first order.
std::vector<Jet> ofTwin(Jets &, const std::vector<Jet> &operands, const Values &results);

} // namespace candela::ir

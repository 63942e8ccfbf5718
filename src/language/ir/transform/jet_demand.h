// SPDX-License-Identifier: Apache-2.0
// Which derivatives a function's Slopes need: of every value and array those orders that reach a
// Slope and may differ from zero.
#pragma once

#include "language/ir/transform/jet.h"
#include "language/ir/transform/jet_order.h"

#include <vector>

namespace candela::ir {

struct JetDemand {
    std::vector<Parts> ofValue, ofArray;
    SlopeReport report;
};

JetDemand jetDemand(const Function &);

} // namespace candela::ir

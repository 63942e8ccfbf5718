// SPDX-License-Identifier: Apache-2.0
// Where light shaders send light, and cones in outputs.
#pragma once

#include "language/ir/questions/questions.h"

namespace candela::ir {

/// Where the outputs have the cone of that number, which a request states.
ConeSlot coneSlot(const std::vector<OutputSlot> &, int cone, int request);

} // namespace candela::ir

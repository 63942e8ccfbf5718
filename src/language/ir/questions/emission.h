// SPDX-License-Identifier: Apache-2.0
// Where light shaders send light.
#pragma once

#include "language/ir/questions/questions.h"

namespace candela::ir {

/// Answers Question::Emission.
Function sliceEmission(const Function &whole);

} // namespace candela::ir

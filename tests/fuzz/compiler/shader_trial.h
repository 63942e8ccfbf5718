// SPDX-License-Identifier: Apache-2.0
// A lowered shader through its questions: every slice is verified, what slices answer is compared
// with the whole text's answer, and code with the interpreter.
#pragma once

#include "chance.h"
#include "trial.h"

#include "language/ir/lower/lower.h"

#include <string>

namespace candela::fuzz {

/// What is wrong, or nothing.
std::string tryLowered(const ir::LoweredShader &, Chance &, const TrialSettings &, Monitor &);

} // namespace candela::fuzz

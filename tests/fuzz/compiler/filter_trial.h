// SPDX-License-Identifier: Apache-2.0
// A lowered filter: the pixel loops that are taken out of its text make of a small picture what the
// text does, turn by turn.
#pragma once

#include "workers.h"

#include "language/ir/lower/lower.h"

#include <string>

namespace candela::fuzz {

/// What is wrong, or nothing.
std::string tryFilter(const ir::LoweredShader &, Monitor &);

} // namespace candela::fuzz

// SPDX-License-Identifier: Apache-2.0
// Generated code of both widths against the interpreter.
#pragma once

#include "runs.h"
#include "workers.h"

namespace candela::fuzz {

/// What is wrong with the code for a question, made as the renderer does, or nothing. The batch's frames are as the
/// questions before have left them, and are that again for each run.
std::string compareCode(ir::Function, Batch &, const std::string &question, Monitor &);

} // namespace candela::fuzz

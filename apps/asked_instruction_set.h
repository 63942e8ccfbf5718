// SPDX-License-Identifier: Apache-2.0
// The instruction set as the command line asks for it.
#pragma once

#include <string>

namespace candela {

/// The instruction set was chosen before main (foundation/base/instruction_set.cpp); says what is
/// wrong where it isn't the one asked for, by --cpu (`name`, if not empty) or else by CANDELA_CPU.
bool instructionSetIsAsAsked(std::string name);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"

#include "foundation/base/instruction_set.h"

#include <cstdio>
#include <cstdlib>

namespace candela {

bool instructionSetIsAsAsked(std::string name) {
    const char *variable = std::getenv("CANDELA_CPU");
    if (name.empty() && variable)
        name = variable;
    if (name.empty() || name == nameOf(instructionSet()))
        return true;
    const char *problem = !instructionSetOf(name) ? "there is no instruction set %s: v2, v3 or v4"
                          : *instructionSetOf(name) > hostInstructionSet()
                              ? "this machine cannot run code for %s"
                              : "cannot choose %s: /proc is not there to be read";
    std::fputs("candela: ", stderr);
    std::fprintf(stderr, problem, name.c_str());
    std::fputs("\n", stderr);
    return false;
}

} // namespace candela

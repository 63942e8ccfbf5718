// SPDX-License-Identifier: Apache-2.0
// at_level v2|v3|v4 program [argument...]: runs a test program at an instruction set. Exit status
// 77, by which CTest knows tests that are left out, where the host lacks it or where it is the
// host's best, which the same test without a suffix runs at anyway.
#include "foundation/base/instruction_set.h"

#include <cstdio>
#include <cstdlib>
#include <unistd.h>

int main(int count, char **words) {
    using namespace candela;
    const auto level = count > 2 ? instructionSetOf(words[1]) : std::nullopt;
    if (!level) {
        std::fputs("at_level v2|v3|v4 program [argument...]\n", stderr);
        return 2;
    }
    if (*level >= hostInstructionSet()) {
        std::printf(*level == hostInstructionSet()
                        ? "left out: %s is this host's best, the test without a suffix runs it\n"
                        : "left out: this host has no %s\n",
                    words[1]);
        return 77;
    }
    setenv("CANDELA_CPU", words[1], 1);
    setenv("CANDELA_EXPECTED_CPU", words[1], 1);
    execv(words[2], words + 2);
    std::perror(words[2]);
    return 2;
}

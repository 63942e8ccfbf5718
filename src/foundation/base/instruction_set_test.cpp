// SPDX-License-Identifier: Apache-2.0
// Run by CTest at every level that the host has.
#include "foundation/base/instruction_set.h"

#include "foundation/base/hot.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace candela {
namespace {

#ifdef CANDELA_WIDE
CANDELA_WIDE InstructionSet chosen() { return InstructionSet::V4; }
__attribute__((target("arch=x86-64-v3"))) InstructionSet chosen() { return InstructionSet::V3; }
CANDELA_PLAIN InstructionSet chosen() { return InstructionSet::V2; }

TEST(InstructionSet, TheLoaderChoosesTheOneInForce) { EXPECT_EQ(chosen(), instructionSet()); }
#endif

TEST(InstructionSet, IsTheOneAskedForOrTheHostsBest) {
    const char *text = std::getenv("CANDELA_CPU");
    const auto asked = text ? instructionSetOf(text) : std::nullopt;
    EXPECT_EQ(instructionSet(),
              asked ? std::min(*asked, hostInstructionSet()) : hostInstructionSet());
    // An emulator's processor is the one that CTest wants.
    if (const char *expected = std::getenv("CANDELA_EXPECTED_CPU")) {
        EXPECT_EQ(instructionSet(), instructionSetOf(expected));
    }
}

TEST(InstructionSet, Names) {
    for (InstructionSet level : {InstructionSet::V2, InstructionSet::V3, InstructionSet::V4})
        EXPECT_EQ(instructionSetOf(nameOf(level)), level);
    for (const char *name : {"", "v1", "v5", "v33", "V3", "x86-64-v3"})
        EXPECT_FALSE(instructionSetOf(name)) << name;
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// --cpu and CANDELA_CPU, and that the program under test runs at the level that is meant:
// CANDELA_EXPECTED_CPU where a launcher or CTest chose it, else the host's best.
#include "foundation/base/instruction_set.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

class InstructionSetOption : public testing::Test {
protected:
    InstructionSetOption() {
        const char *expected = std::getenv("CANDELA_EXPECTED_CPU");
        expected_ = expected ? instructionSetOf(expected).value() : hostInstructionSet();
        rib_ = folder_.write("scene.rib", "Display \"out.exr\" \"openexr\" \"rgb\"\nFormat 4 4 1\n"
                                          "WorldBegin\nTranslate 0 0 5\nDisk 0 1 360\nWorldEnd\n");
    }

    Outcome run(std::vector<std::string> options) {
        options.insert(options.end(), {rib_, "--output-dir", folder_.path(), "--stats",
                                       folder_.path("figures.json")});
        return runCandela(options);
    }
    void expectLevel(InstructionSet level) {
        const std::string line =
            "\"process.instructionSet\": " + std::to_string(2 + int(level)) + ",";
        EXPECT_NE(folder_.read("figures.json").find(line), std::string::npos) << line;
    }

    ScratchFolder folder_;
    std::string rib_;
    InstructionSet expected_;
};

} // namespace

TEST_F(InstructionSetOption, TheProgramRunsAtTheExpectedOne) {
    Outcome outcome = run({});
    ASSERT_EQ(outcome.status, 0) << outcome.text();
    expectLevel(expected_);
}

TEST_F(InstructionSetOption, ChoosesALevel) {
    for (InstructionSet level : {InstructionSet::V2, InstructionSet::V3, InstructionSet::V4}) {
        if (level > expected_)
            break;
        for (bool joined : {false, true}) {
            const std::string name = nameOf(level);
            Outcome outcome = joined ? run({"--cpu=" + name}) : run({"--cpu", name});
            ASSERT_EQ(outcome.status, 0) << outcome.text();
            expectLevel(level);
        }
    }
}

TEST_F(InstructionSetOption, RefusesWhatThereIsNot) {
    for (const char *name : {"v1", "v5", "znver4", "x86-64-v3"}) {
        Outcome outcome = run({"--cpu", name});
        EXPECT_EQ(outcome.status, 2) << outcome.text();
        EXPECT_TRUE(outcome.says(name)) << outcome.text();
    }
    const bool chosen = std::getenv("CANDELA_CPU") != nullptr; // The host may have more.
    for (InstructionSet level : {InstructionSet::V3, InstructionSet::V4})
        if (level > expected_ && !chosen) {
            Outcome outcome = run({"--cpu", nameOf(level)});
            EXPECT_EQ(outcome.status, 2) << outcome.text();
            EXPECT_TRUE(outcome.says("cannot run")) << outcome.text();
        }
}

} // namespace candela::test

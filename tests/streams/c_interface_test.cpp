// SPDX-License-Identifier: Apache-2.0
// The example in C renders, and the RIB that it writes gives the same picture.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

TEST(CInterface, theRibOfAProgramIsItsPicture) {
    const ScratchFolder folder;
    RunSettings settings;
    settings.folder = folder.path();
    settings.program = std::filesystem::path(candelaProgram()).replace_filename("balls");
    Outcome outcome = runCandela({}, settings);
    ASSERT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.err, "");
    std::filesystem::rename(folder.path("balls.exr"), folder.path("direct.exr"));
    for (const char *form : {"balls.rib", "balls.rib.gz", "|cat > piped.rib"}) {
        outcome = runCandela({form}, settings);
        EXPECT_EQ(outcome.status, 0) << outcome.text();
        EXPECT_FALSE(folder.has("balls.exr"));
        const std::string file = form[0] == '|' ? "piped.rib" : form;
        EXPECT_EQ(runCandela({"--quiet", "--output-dir", folder.path(), folder.path(file)}).status,
                  0);
        EXPECT_EQ(runCandela({"diff", folder.path("direct.exr"), folder.path("balls.exr")}).status,
                  0)
            << form;
        std::filesystem::remove(folder.path("balls.exr"));
    }
    outcome = runCandela({"none/balls.rib"}, settings);
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("RiBegin: 'none/balls.rib' cannot be written"));
}

} // namespace
} // namespace candela::test

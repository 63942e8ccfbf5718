// SPDX-License-Identifier: Apache-2.0
// candela cat: what comes out, where it goes, and what is wrong with the command.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string scene = "##RenderMan RIB\n"
                          "Display \"p.exr\" \"openexr\" \"rgba\"\n"
                          "Format 16 16 1\n"
                          "WorldBegin\n"
                          "  Surface \"constant\"\n"
                          "  Color [0.1 0.2 0.3]\n"
                          "  Polygon \"P\" [-1 -1 1 -1 1 1 1 1 1 1 -1 1]\n"
                          "WorldEnd\n";

TEST(Cat, formsAreOneAndTheSame) {
    const ScratchFolder folder;
    const std::string ascii = folder.write("a.rib", scene);
    const auto cat = [](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), "cat");
        const Outcome outcome = runCandela(arguments);
        EXPECT_EQ(outcome.status, 0) << outcome.text();
        EXPECT_EQ(outcome.err, "");
        return outcome.out;
    };
    EXPECT_EQ(cat({ascii}), scene);
    cat({ascii, "--binary", "-o", folder.path("b.rib")});
    cat({ascii, "--gzip", "-o", folder.path("c.rib")});
    cat({folder.path("b.rib"), "--binary", "--gzip", "--output", folder.path("d.rib")});
    EXPECT_EQ(folder.read("c.rib").substr(0, 2), "\x1f\x8b");
    EXPECT_EQ(folder.read("d.rib").substr(0, 2), "\x1f\x8b");
    for (const char *name : {"a.rib", "b.rib", "c.rib", "d.rib"}) {
        EXPECT_EQ(cat({folder.path(name), "--ascii"}), scene) << name;
        const Outcome outcome =
            runCandela({"--quiet", "--output-dir", folder.path(), folder.path(name)});
        EXPECT_EQ(outcome.status, 0) << outcome.text();
        const std::string picture = folder.path(std::string(name) + ".exr");
        std::filesystem::rename(folder.path("p.exr"), picture);
        EXPECT_EQ(runCandela({"diff", folder.path("a.rib.exr"), picture}).status, 0) << name;
    }
    EXPECT_EQ(cat({ascii, ascii}), scene + scene);
    RunSettings settings;
    settings.input = folder.path("d.rib");
    EXPECT_EQ(runCandela({"cat"}, settings).out, scene);
    EXPECT_EQ(runCandela({"cat", "-"}, settings).out, scene);
}

TEST(Cat, whatIsWrongIsSaid) {
    const ScratchFolder folder;
    const std::string ascii = folder.write("a.rib", scene),
                      bad = folder.write("bad.rib", "Foo 1\n");
    const struct {
        std::vector<std::string> arguments;
        int status;
        const char *message;
    } cases[] = {
        {{"cat", ascii, "-o", ascii}, 2, "would be overwritten while it is read"},
        {{"cat", ascii, "-o", folder.path("none/x.rib")}, 1, "cannot be written"},
        {{"cat", ascii, "-o", "/dev/full"}, 1, "cannot be written"},
        {{"cat", folder.path("missing.rib")}, 1, "cannot be opened"},
        {{"cat", bad}, 1, "unknown request 'Foo'"},
        {{"cat", ascii, "--ascii", "--binary"}, 2, "excludes"},
    };
    for (const auto &each : cases) {
        const Outcome outcome = runCandela(each.arguments);
        EXPECT_EQ(outcome.status, each.status) << outcome.text();
        EXPECT_TRUE(outcome.says(each.message)) << outcome.text();
    }
    EXPECT_EQ(folder.read("a.rib"), scene);
}

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// Where a stranger's file may write: names, what lies under them, and whose word they are.
#include "image/output_path.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

namespace candela {
namespace {

namespace fs = std::filesystem;

class OutputPath : public ::testing::Test {
protected:
    OutputPath() {
        root_ = fs::canonical(fs::temp_directory_path()) /
                ("candela-output-path-" + std::to_string(::getpid()));
        fs::remove_all(root_);
        fs::create_directories(root_ / "out/.git");
        fs::create_directories(root_ / "elsewhere");
        write("out/notes.txt", "the work of a year");
        write("out/short", "x");
        write("out/scene.rib", "##RenderMan RIB-Structure 1.0\n");
        write("out/bm.c", "BMW = 1; // No bitmap.");
        write("out/page.txt", "P.S.: no portable map.");
        write("out/empty.exr", "");
        write("out/old.exr", std::string("v/1\x01\x02\0\0\0", 8));
        write("out/old.png", "\x89PNG\r\n\x1a\n....");
        write("out/old.tif", std::string("II*\0....", 8));
        write("out/old.tx", std::string("MM\0*....", 8));
        write("out/old.hdr", "#?RADIANCE\n");
        write("out/old.jpg", "\xff\xd8\xff\xe0....");
        write("out/old.ppm", "P6 1 1 255 ...");
        write("elsewhere/list.txt", "the work of two years");
        fs::create_symlink(root_ / "elsewhere", root_ / "out/door");
        fs::create_symlink(root_ / "out/notes.txt", root_ / "out/alias.exr");
        fs::create_symlink(root_ / "elsewhere/new.exr", root_ / "out/dangling.exr");
    }
    ~OutputPath() override { fs::remove_all(root_); }

    void write(const std::string &name, const std::string &bytes) {
        std::ofstream(root_ / name, std::ios::binary) << bytes;
    }

    /// Where it goes, below the root; the reason if nowhere.
    std::string pathOf(const std::string &name, bool isTrusted) {
        note_.clear(), problem_.clear();
        const auto path = outputPath(name, {(root_ / "out").string(), isTrusted}, note_, problem_);
        return path ? fs::path(*path).lexically_relative(root_).string() : "refused: " + problem_;
    }

    fs::path root_;
    std::string note_, problem_;
};

TEST_F(OutputPath, NamesOfStrangers) {
    const struct {
        std::string name, expected;
    } table[] = {
        {"a.exr", "out/a.exr"},
        {"./a.exr", "out/a.exr"},
        {"sub/folder/a.exr", "out/sub/folder/a.exr"},
        {"sub/../a.exr", "out/a.exr"},
        {"two words.exr", "out/two words.exr"},
        {"b\xfc"
         "cher.tif",
         "out/b\xfc"
         "cher.tif"}, // Latin 1, as old files have it.
        {"a-b.c.exr", "out/a-b.c.exr"},
        // What is there.
        {"empty.exr", "out/empty.exr"},
        {"old.exr", "out/old.exr"},
        {"old.png", "out/old.png"},
        {"old.tif", "out/old.tif"},
        {"old.tx", "out/old.tx"},
        {"old.hdr", "out/old.hdr"},
        {"old.jpg", "out/old.jpg"},
        {"old.ppm", "out/old.ppm"},
        {"notes.txt", "it is there and no picture"},
        {"sub/../notes.txt", "it is there and no picture"},
        {"short", "it is there and no picture"},
        {"scene.rib", "it is there and no picture"},
        {"bm.c", "it is there and no picture"},
        {"page.txt", "it is there and no picture"},
        {"alias.exr", "it is there and no picture"},
        // Who leads outside comes in under the last part, if that may be.
        {"../a.exr", "out/a.exr"},
        {"/tmp/a.exr", "out/a.exr"},
        {"door/a.exr", "out/a.exr"},
        {"C:\\renders\\a.exr", "out/a.exr"},
        {"../notes.txt", "it is there and no picture"},
        {"/etc/.hidden.exr", "begin with \".\""},
        {"C:\\-rf", "begin with \"-\""},
        {"dangling.exr", "out/dangling.exr"}, // The link itself is replaced.
        {"..", "outside the output folder"},
        {"/", "outside the output folder"},
        // Names that no picture has.
        {".bashrc", "begin with \".\""},
        {".git/hooks/pre-commit", "begin with \".\""},
        {"sub/.a.exr", "begin with \".\""},
        {"...exr", "begin with \".\""},
        {"-rf", "begin with \"-\""},
        {"--checkpoint-action=exec=sh a.sh", "begin with \"-\""},
        {"sub/-a.exr", "begin with \"-\""},
        {"a\nb.exr", "control characters"},
        {"a\x1b[2J.exr", "control characters"},
        {"a\x7f.exr", "control characters"},
        {"a\u202egnp.exe", "control characters"},
        {"", "needs a file name"},
        {std::string("a\0b.exr", 7), "needs a file name"},
    };
    for (const auto &[name, expected] : table) {
        const std::string path = pathOf(name, false);
        if (expected.starts_with("out/"))
            EXPECT_EQ(path, expected) << name;
        else
            EXPECT_TRUE(path.starts_with("refused") && path.find(expected) != std::string::npos)
                << name << ": " << path;
    }
    EXPECT_FALSE(fs::exists(root_ / "out/sub/-a.exr"));
    EXPECT_FALSE(fs::exists(root_ / "out/.git/hooks")) << "a folder for a name that is refused";
}

TEST_F(OutputPath, ThoseWhoAreTrustedMayDoAsTheyLike) {
    const struct {
        std::string name, expected;
    } table[] = {
        {"notes.txt", "out/notes.txt"},   {".hidden.exr", "out/.hidden.exr"},
        {"-a.exr", "out/-a.exr"},         {"../elsewhere/list.txt", "elsewhere/list.txt"},
        {"door/b.exr", "out/door/b.exr"}, {"D:\\c.exr", "out/c.exr"},
    };
    for (const auto &[name, expected] : table)
        EXPECT_EQ(pathOf(name, true), expected) << name;
    EXPECT_EQ(pathOf((root_ / "elsewhere/a.exr").string(), true), "elsewhere/a.exr");
}

} // namespace
} // namespace candela

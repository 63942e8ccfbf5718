// SPDX-License-Identifier: Apache-2.0
// Files: archives, search paths, compression, and files that cannot be read.
#include "interface/rib/reading_fixture.h"

#include <filesystem>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

namespace candela::testing {

namespace fs = std::filesystem;

class Archives : public Reading {
protected:
    fs::path folder = fs::path(CANDELA_BINARY_DIR) /
                      ("archives_test." + std::to_string(::getpid()) + "." +
                       ::testing::UnitTest::GetInstance()->current_test_info()->name());

    void SetUp() override { fs::create_directories(folder / "sub"); }
    void TearDown() override { fs::remove_all(folder); }

    std::string write(const std::string &name, const std::string &text) {
        std::ofstream(folder / name, std::ios::binary) << text;
        return (folder / name).string();
    }
    std::string compress(const std::string &name, const std::string &text) {
        std::string path = (folder / name).string();
        gzFile file = gzopen(path.c_str(), "wb");
        gzwrite(file, text.data(), unsigned(text.size()));
        gzclose(file);
        return path;
    }
    bool readFile(const std::string &path) {
        ErrorPolicy policy(found);
        GraphicsState state(builder, shaders, policy, settings);
        bool opened = RibReader(state, policy).readFile(path);
        state.finish();
        return opened;
    }
    std::size_t primitives() const { return builder.worlds.back().primitives.size(); }
};

TEST_F(Archives, areReadInPlaceFromTheFolderOfTheFile) {
    write("sub/ball.rib", "Color [0 1 0]\nSphere 1 -1 1 360\n");
    write("sub/pair.rib", "ReadArchive \"ball.rib\" ReadArchive \"ball.rib\"");
    EXPECT_TRUE(readFile(write("main.rib", "WorldBegin\nReadArchive \"sub/pair.rib\"\n"
                                           "Disk 0 1 360\nWorldEnd\n")));
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(primitives(), 3u);
    EXPECT_EQ(builder.worlds[0].primitives[2].attributes->color, Color(0, 1, 0));
    SourceLocation where = builder.worlds[0].primitives[0].record->where;
    EXPECT_EQ(where.text(), (folder / "sub/ball.rib").string() + ":2:1");
}

TEST_F(Archives, areFoundThroughTheSearchPath) {
    write("sub/ball.rib", "Sphere 1 -1 1 360\n");
    readFile(write("main.rib", "Option \"searchpath\" \"string archive\" [\"/nowhere:" +
                                   (folder / "sub").string() +
                                   "\"]\nWorldBegin ReadArchive \"ball.rib\" WorldEnd"));
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(primitives(), 1u);
    settings.searchPaths.archive = (folder / "sub").string();
    readFile(write("main.rib", "WorldBegin ReadArchive \"ball.rib\" WorldEnd"));
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(primitives(), 1u);
}

// As shaders are by --shader-path: what the file says does not take it away.
TEST_F(Archives, areFoundByTheCommandLinesPathAlways) {
    write("sub/ball.rib", "Sphere 1 -1 1 360\n");
    settings.searchPaths.archive = (folder / "sub").string();
    readFile(write("main.rib", "Option \"searchpath\" \"archive\" [\"elsewhere\"]\n"
                               "WorldBegin ReadArchive \"ball.rib\" WorldEnd"));
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(primitives(), 1u);
}

TEST_F(Archives, mayBePartOfObjects) {
    write("ball.rib", "Sphere 1 -1 1 360\n");
    readFile(write("main.rib", "WorldBegin ObjectBegin 1 ReadArchive \"ball.rib\" ObjectEnd\n"
                               "ObjectInstance 1 ObjectInstance 1 WorldEnd"));
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(primitives(), 0u);
    ASSERT_EQ(builder.worlds.back().objects.size(), 1u);
    EXPECT_EQ(builder.worlds.back().objects[0].primitives.size(), 1u);
    EXPECT_EQ(builder.worlds.back().instances.size(), 2u);
}

TEST_F(Archives, thatAreMissingAreErrors) {
    readFile(write("main.rib", "WorldBegin\nReadArchive \"none.rib\"\nReadArchive \"sub\"\n"
                               "Sphere 1 -1 1 360\nWorldEnd"));
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(says("main.rib:2:1: error: ReadArchive: there is no archive 'none.rib'"));
    EXPECT_EQ(primitives(), 1u);
}

TEST_F(Archives, thatReadThemselvesAreErrors) {
    write("a.rib", "Sphere 1 -1 1 360 ReadArchive \"b.rib\" ReadArchive \"b.rib\"\n");
    write("b.rib", "Disk 0 1 360 ReadArchive \"./sub/../a.rib\"");
    readFile(write("main.rib", "WorldBegin ReadArchive \"a.rib\" WorldEnd"));
    EXPECT_EQ(errors(), 2);
    EXPECT_EQ(primitives(), 3u);
}

TEST_F(Archives, chainsHaveALimit) {
    for (int i = 0; i < 100; ++i)
        write(std::to_string(i) + ".rib", "ReadArchive \"" + std::to_string(i + 1) + ".rib\"");
    write("100.rib", "");
    readFile((folder / "0.rib").string());
    EXPECT_EQ(errors(), 1);
    EXPECT_TRUE(says("nested more than"));
}

TEST_F(Archives, thatReadOthersTwiceHaveALimit) {
    for (int i = 0; i < 50; ++i) {
        const std::string next = "ReadArchive \"" + std::to_string(i + 1) + ".rib\"\n";
        write(std::to_string(i) + ".rib", next + next);
    }
    write("50.rib", "");
    readFile((folder / "0.rib").string());
    EXPECT_GT(errors(), 0);
    EXPECT_LT(errors(), 100);
    EXPECT_TRUE(says("10000 others already"));
}

// Neither is read, for reading would not end.
TEST_F(Archives, areRegularFiles) {
    ASSERT_EQ(mkfifo((folder / "pipe.rib").c_str(), 0600), 0);
    readFile(write("main.rib", "ReadArchive \"/dev/zero\"\nReadArchive \"pipe.rib\"\n"));
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(says("main.rib:1:1: error: ReadArchive: there is no archive '/dev/zero'"));
}

TEST_F(Archives, mayBeCompressed) {
    compress("ball.rib.gz", "Sphere 1 -1 1 360\n");
    readFile(compress("main.rib", "WorldBegin ReadArchive \"ball.rib.gz\" WorldEnd"));
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(primitives(), 1u);
}

TEST_F(Archives, thatAreCutShortWhereCompressedAreErrors) {
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 20000; ++i)
        text += "Translate " + std::to_string(i * 7919 % 1000) + " 0 0\n";
    std::string path = compress("main.rib.gz", text + "WorldEnd\n");
    fs::resize_file(path, fs::file_size(path) / 2);
    readFile(path);
    EXPECT_TRUE(says("cannot be read further"));
}

TEST_F(Archives, longFilesAreReadThroughTheWindow) {
    // Tokens of all lengths lie across the borders of the reader's window.
    std::string text = "WorldBegin\n";
    for (int i = 0; i < 3000; ++i)
        text += "Attribute \"identifier\" \"name\" [\"" + std::string(i % 97, 'x') +
                std::to_string(i) + "\"] Sphere " + std::to_string(i + 1) + " -1 1 360\n";
    readFile(write("main.rib", text + "WorldEnd\n"));
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(primitives(), 3000u);
    for (int i = 0; i < 3000; ++i) {
        const auto &primitive = builder.worlds[0].primitives[i];
        ASSERT_EQ(std::get<SphereRecord>(primitive.record->shape).radius, i + 1);
        ASSERT_EQ(primitive.attributes->name, std::string(i % 97, 'x') + std::to_string(i));
    }
}

TEST_F(Archives, filesThatCannotBeOpenedAreErrors) {
    EXPECT_FALSE(readFile((folder / "none.rib").string()));
    EXPECT_FALSE(readFile((folder / "sub").string()));
    EXPECT_EQ(errors(), 2);
    EXPECT_TRUE(says("none.rib: error: the file cannot be opened: No such file"));
    EXPECT_TRUE(readFile(write("empty.rib", "")));
    EXPECT_EQ(errors(), 2);
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
// ArchiveBegin and ArchiveEnd: archives in the stream.
#include "interface/rib/reading_fixture.h"

#include <filesystem>
#include <fstream>

namespace candela::testing {

TEST_F(Reading, inlineArchivesDrawWhereTheyAreReadAndNowhereElse) {
    const auto seen =
        world("ArchiveBegin \"ball\"\nTranslate 0 1 0\nSphere 1 -1 1 360\nArchiveEnd\n"
              "Color 1 0 0\nTransformBegin ReadArchive \"ball\" TransformEnd\n"
              "Color 0 1 0\nTranslate 5 0 0\nReadArchive \"ball\"");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(seen.primitives.size(), 2u);
    EXPECT_EQ(seen.primitives[0].attributes->color, Color(1, 0, 0));
    EXPECT_EQ(seen.primitives[1].attributes->color, Color(0, 1, 0));
    EXPECT_EQ(seen.primitives[0].place(0, 0, 0), (Vec3{0, 1, 0}));
    EXPECT_EQ(seen.primitives[1].place(0, 0, 0), (Vec3{5, 1, 0}));
    EXPECT_EQ(seen.primitives[1].record->where.text(), "test.rib:4:1");
}

TEST_F(Reading, aSecondDefinitionOfANameWins) {
    const auto seen = world("ArchiveBegin \"a\" Sphere 1 -1 1 360 ArchiveEnd\n"
                            "ReadArchive \"a\"\n"
                            "ArchiveBegin \"a\" Disk 0 1 360 ArchiveEnd\n"
                            "ReadArchive \"a\"");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(seen.primitives.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<SphereRecord>(seen.primitives[0].record->shape));
    EXPECT_TRUE(std::holds_alternative<DiskRecord>(seen.primitives[1].record->shape));
}

TEST_F(Reading, inlineArchivesNestAndReadOthers) {
    const auto seen = world("ArchiveBegin \"outer\"\n"
                            "  ArchiveBegin \"inner\" Sphere 1 -1 1 360 ArchiveEnd\n"
                            "  ReadArchive \"inner\" ReadArchive \"inner\" ReadArchive \"later\"\n"
                            "ArchiveEnd\n"
                            "ArchiveBegin \"later\" Disk 0 1 360 ArchiveEnd\n"
                            "ReadArchive \"outer\" ReadArchive \"inner\"");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(seen.primitives.size(), 4u);
}

// Conditions in them are asked where they are read.
TEST_F(Reading, conditionsInInlineArchivesAreAskedWhenTheyAreRead) {
    const auto seen =
        world("ArchiveBegin \"a\"\n"
              "IfBegin \"$user:big == 1\" Sphere 9 -9 9 360 Else Sphere 1 -1 1 360 "
              "IfEnd ArchiveEnd\n"
              "ReadArchive \"a\" Attribute \"user\" \"int big\" [1] ReadArchive \"a\"");
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(seen.primitives.size(), 2u);
    EXPECT_EQ(std::get<SphereRecord>(seen.primitives[0].record->shape).radius, 1);
    EXPECT_EQ(std::get<SphereRecord>(seen.primitives[1].record->shape).radius, 9);
}

TEST_F(Reading, inlineArchivesEndWithTheirFrameOrWorld) {
    read("ArchiveBegin \"all\" Sphere 1 -1 1 360 ArchiveEnd\n"
         "FrameBegin 1\nArchiveBegin \"frame\" Sphere 1 -1 1 360 ArchiveEnd\n"
         "WorldBegin ArchiveBegin \"world\" Sphere 1 -1 1 360 ArchiveEnd\n"
         "AttributeBegin ArchiveBegin \"block\" Sphere 1 -1 1 360 ArchiveEnd AttributeEnd\n"
         "ReadArchive \"all\" ReadArchive \"frame\" ReadArchive \"world\" ReadArchive \"block\"\n"
         "WorldEnd\nWorldBegin ReadArchive \"all\" ReadArchive \"frame\" WorldEnd FrameEnd\n");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(builder.worlds[0].primitives.size(), 4u);
    EXPECT_EQ(builder.worlds[1].primitives.size(), 2u);
    const std::string before = "FrameBegin 1 ArchiveBegin \"a\" Sphere 1 -1 1 360 ArchiveEnd "
                               "FrameEnd FrameEnd WorldBegin ReadArchive \"a\" WorldEnd";
    read(before);
    EXPECT_EQ(builder.worlds.back().primitives.size(), 0u);
    EXPECT_TRUE(says("there is no archive 'a'"));
}

TEST_F(Reading, inlineArchivesMayBePartOfObjectsAndMotion) {
    const auto seen = world("ArchiveBegin \"a\" Sphere 1 -1 1 360 ArchiveEnd\n"
                            "ObjectBegin 1 ReadArchive \"a\" ObjectEnd ObjectInstance 1");
    EXPECT_EQ(found.text(), "");
    EXPECT_EQ(seen.objects.at(0).primitives.size(), 1u);
    EXPECT_EQ(seen.instances.size(), 1u);
}

TEST_F(Reading, inlineArchivesAreFoundBeforeFiles) {
    const std::string file = std::string(CANDELA_BINARY_DIR) + "/inline_archives_test.rib";
    std::ofstream(file) << "Sphere 1 -1 1 360\n";
    const auto seen = world("ReadArchive \"" + file + "\"\nArchiveBegin \"" + file +
                            "\" Disk 0 1 360 ArchiveEnd\nReadArchive \"" + file + "\"");
    std::filesystem::remove(file);
    EXPECT_EQ(found.text(), "");
    ASSERT_EQ(seen.primitives.size(), 2u);
    EXPECT_TRUE(std::holds_alternative<SphereRecord>(seen.primitives[0].record->shape));
    EXPECT_TRUE(std::holds_alternative<DiskRecord>(seen.primitives[1].record->shape));
}

TEST_F(Reading, whatIsWrongWithInlineArchivesIsReported) {
    const auto seen = world("ArchiveEnd\nArchiveBegin \"self\" ReadArchive \"self\" ArchiveEnd\n"
                            "ReadArchive \"self\" Disk 0 1 360");
    EXPECT_TRUE(says("test.rib:2:1: error: ArchiveEnd without ArchiveBegin"));
    EXPECT_TRUE(says("test.rib:3:21: error: ReadArchive: 'self' would read itself without end"));
    EXPECT_EQ(errors(), 2);
    EXPECT_EQ(seen.primitives.size(), 1u);
    read("WorldBegin Disk 0 1 360 WorldEnd ArchiveBegin \"open\" Sphere 1 -1 1 360");
    EXPECT_TRUE(says("test.rib:1:34: error: ArchiveBegin is never closed by ArchiveEnd"));
    EXPECT_EQ(errors(), 3);
}

// Each reads the one before twice: their number doubles from one to the next.
TEST_F(Reading, inlineArchivesThatGrowWithoutBoundEnd) {
    std::string text = "ArchiveBegin \"0\" Sphere 1 -1 1 360 ArchiveEnd\n";
    for (int i = 1; i < 60; ++i) {
        const std::string inner = "ReadArchive \"" + std::to_string(i - 1) + "\" ";
        text += "ArchiveBegin \"" + std::to_string(i) + "\" " + inner + inner + "ArchiveEnd\n";
    }
    read("ErrorHandler \"ignore\"\n" + text + "WorldBegin ReadArchive \"59\" WorldEnd");
    EXPECT_LE(builder.worlds.back().primitives.size(), 100001u);
    EXPECT_TRUE(builder.worlds.back().ended);
}

} // namespace candela::testing

// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/search_path.h"

#include <cstdlib>
#include <gtest/gtest.h>

namespace candela {

TEST(SearchPath, expands) {
    setenv("CANDELA_TEST_FOLDER", "/somewhere", 1);
    unsetenv("CANDELA_TEST_UNSET");
    struct {
        const char *text, *expected;
    } cases[] = {
        {"a:b", "a:b"},
        {"a::b:", "a:b"},
        {"&:a", "old1:old2:a"},
        {"a:@", "a:std"},
        {"&:@:&", "old1:old2:std"},
        {"%CANDELA_TEST_FOLDER%/x:y", "/somewhere/x:y"},
        {"%CANDELA_TEST_UNSET%:y", "y"},
        {"${CANDELA_TEST_FOLDER}/x:y", "/somewhere/x:y"},
        {"${CANDELA_TEST_UNSET}:y", "y"},
        {"C;d:e", "C:d:e"},
        {"100%", "100%"},
        {"", ""},
    };
    for (const auto &each : cases)
        EXPECT_EQ(expandSearchPath(each.text, "old1:old2", "std"), each.expected) << each.text;
}

TEST(SearchPath, variablesMayHoldSeveralFolders) {
    setenv("CANDELA_TEST_FOLDER", "/a:/b", 1);
    std::string many;
    for (std::size_t i = 0; i < 2 * mostSearchFolders; ++i)
        many += "/f" + std::to_string(i) + ":";
    EXPECT_EQ(splitSearchPath(expandSearchPath(many, "", "")).size(), mostSearchFolders);
    EXPECT_EQ(splitSearchPath(expandSearchPath("%CANDELA_TEST_FOLDER%:/c", "", "")),
              (std::vector<std::string>{"/a", "/b", "/c"}));
}

TEST(SearchPath, filesAreFoundInOrder) {
    std::string here = CANDELA_SOURCE_DIR "/src/interface/ri";
    EXPECT_EQ(findFile("options.h", {"/nowhere", here}), here + "/options.h");
    EXPECT_EQ(findFile("options.h", {"/nowhere"}), std::nullopt);
    EXPECT_EQ(findFile(here + "/options.h", {}), here + "/options.h");
    EXPECT_EQ(findFile("ri", {CANDELA_SOURCE_DIR "/src/interface"}), std::nullopt); // A folder.
}

TEST(SearchPath, namesakesLieInOtherFolders) {
    const std::string here = CANDELA_SOURCE_DIR "/src/interface/ri";
    for (const char *name : {"/somebody/options.h", "C:\\x\\options.h", "x/y/options.h"})
        EXPECT_EQ(findNamesake(name, {"/nowhere", here}), here + "/options.h") << name;
    EXPECT_EQ(findNamesake("ri\\options.h", {CANDELA_SOURCE_DIR "/src/interface"}),
              here + "/options.h");
    for (const char *name : {"options.h", "/somebody/", "/somebody/else.h"})
        EXPECT_EQ(findNamesake(name, {here}), std::nullopt) << name;
}

TEST(SearchPath, foldersAreSeenFromTheFileToo) {
    const std::string source = CANDELA_SOURCE_DIR;
    EXPECT_EQ(withFoldersBeside("src:nowhere:/usr", source + "/scene.rib"),
              "src:" + source + "/src:nowhere:/usr");
    EXPECT_EQ(withFoldersBeside("src", "scene.rib"), "src");
}

} // namespace candela

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
        {"100%", "100%"},
        {"", ""},
    };
    for (const auto &each : cases)
        EXPECT_EQ(expandSearchPath(each.text, "old1:old2", "std"), each.expected) << each.text;
}

TEST(SearchPath, variablesMayHoldSeveralFolders) {
    setenv("CANDELA_TEST_FOLDER", "/a:/b", 1);
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

} // namespace candela

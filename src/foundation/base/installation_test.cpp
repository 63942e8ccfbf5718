// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/installation.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

TEST(Installation, BelongsToWhatLiesInItsBinAndLib) {
    const std::pair<const char *, const char *> rows[] = {
        {"/opt/candela/bin/candela", "/opt/candela"},
        {"/opt/candela/lib/libcandela.so", "/opt/candela"},
        {"/usr/lib/x86_64-linux-gnu/libcandela.so", "/usr"},
        {"/usr/lib64/libcandela.so", "/usr"},
        {"/opt/candela/lib/python3/dist-packages/candela/ri.so", "/opt/candela"},
        {"/tmp/shared/build/bin/candela", "/tmp/shared/build"},
        {"/bin/candela", "/"},
    };
    for (const auto &[file, prefix] : rows)
        EXPECT_EQ(prefixOf(file), prefix) << file;
}

TEST(Installation, IsNotWhateverLiesAroundAFile) {
    for (const char *file :
         {"", "candela", "/candela", "/tmp/candela", "/tmp/work/balls", "/home/me/bin/new/candela",
          "/srv/lib/a/b/c/d/e/balls", "/tmp/binary/candela", "/tmp/library/candela"})
        EXPECT_EQ(prefixOf(file), "") << file;
}

/// The build is laid out as installations are.
TEST(Installation, HasTheShadersThatThisTestCameWith) {
    const auto shaders = installedPath("share/candela/shaders");
    ASSERT_TRUE(shaders);
    EXPECT_TRUE(std::filesystem::exists(*shaders / "surface" / "plastic.sl"));
    EXPECT_FALSE(installedPath("share/candela/no such thing"));
    EXPECT_FALSE(installedPath("../share/candela/nor this"));
}

} // namespace
} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "image/disk_space.h"

#include <gtest/gtest.h>

namespace candela {
namespace {

PlannedDisplay display(const std::string &path, FileFormat format, int planes) {
    PlannedDisplay result;
    result.record.name = path;
    result.path = path;
    result.format = format;
    result.planes.resize(std::size_t(planes));
    return result;
}

std::string warnings(std::vector<PlannedDisplay> displays, double room) {
    DiagnosticList heard;
    warnOfSmallDisks(displays, 1e6, heard, [&](const std::string &) { return room; });
    EXPECT_EQ(heard.count(Severity::Error), 0);
    return heard.text();
}

TEST(DiskSpace, IsCountedForAllDisplaysOfAFolder) {
    const auto exr = display("/a/one.exr", FileFormat::OpenExr, 4);
    const auto png = display("/a/two.png", FileFormat::Png, 4);
    EXPECT_EQ(warnings({exr}, 16e6), "");
    EXPECT_NE(warnings({exr}, 15.9e6).find("one.exr"), std::string::npos);
    EXPECT_EQ(warnings({png}, 4e6), "");
    const std::string both = warnings({exr, png}, 19e6);
    EXPECT_EQ(both.find("one.exr"), std::string::npos) << both;
    EXPECT_NE(both.find("\"/a/two.png\": /a has 19 MB left, and up to 20 MB"), std::string::npos)
        << both;
}

TEST(DiskSpace, OfOtherFoldersIsTheirOwn) {
    EXPECT_EQ(warnings({display("/a/one.exr", FileFormat::OpenExr, 4),
                        display("/b/one.exr", FileFormat::OpenExr, 4)},
                       16e6),
              "");
}

TEST(DiskSpace, OfNoFolderIsNotComplainedOf) {
    EXPECT_GT(freeSpaceOf("/no/such/folder"), 1e300);
    EXPECT_GE(freeSpaceOf("/"), 0);
}

} // namespace
} // namespace candela

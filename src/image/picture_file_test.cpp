// SPDX-License-Identifier: Apache-2.0
#include "image/picture_file.h"

#include "foundation/base/hash.h"
#include "foundation/base/whole_file.h"
#include "image/exr_file.h"
#include "image/png_file.h"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <gtest/gtest.h>

namespace candela {
namespace {

Picture makePicture(const std::vector<std::string> &names, FrameWindow window, float largest) {
    Picture picture;
    picture.window = window;
    for (std::size_t k = 0; k < names.size(); ++k) {
        PictureChannel channel{names[k], {}};
        for (std::size_t i = 0; i < window.pixels(); ++i)
            channel.values.push_back(
                std::floor(float(mixBits(i * 16 + k) >> 40) * 0x1p-24f * largest));
        picture.channels.push_back(channel);
    }
    picture.metadata = {{"renderer", "candela"}, {"long name of a thing", "two\nlines"}};
    return picture;
}

TEST(PictureFile, ExrRoundTripIsExact) {
    Picture picture = makePicture({"A", "B", "G", "R", "half0.R"}, {40, 30, -3, 20, 5, 33}, 1e6f);
    picture.channels[0].values[3] = INFINITY;
    picture.channels[1].values[4] = -1.5e-30f;
    picture.pixelAspectRatio = 0.5f;
    picture.worldToNdc = Matrix4{{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16}};
    std::string problem;
    const auto bytes = encodeExr(picture, problem);
    ASSERT_TRUE(bytes) << problem;
    EXPECT_EQ(*bytes, *encodeExr(picture, problem)); // No time stamp in it.
    const auto back = decodeExr(*bytes, problem);
    ASSERT_TRUE(back) << problem;
    EXPECT_EQ(back->window, picture.window);
    EXPECT_EQ(back->pixelAspectRatio, 0.5f);
    EXPECT_EQ(back->worldToNdc, picture.worldToNdc);
    EXPECT_EQ(back->worldToCamera, std::nullopt);
    EXPECT_EQ(back->metadata, picture.metadata);
    ASSERT_EQ(back->channels.size(), 5u);
    for (const PictureChannel &channel : picture.channels)
        EXPECT_EQ(back->find(channel.name)->values, channel.values);
}

TEST(PictureFile, PngRoundTripOfAllLayouts) {
    const std::vector<std::vector<std::string>> layouts{
        {"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    for (int bits : {8, 16})
        for (const auto &names : layouts) {
            const float largest = bits == 16 ? 65535.0f : 255.0f;
            const Picture picture = makePicture(names, {9, 7, 0, 9, 0, 7}, largest + 1);
            std::string problem;
            const auto bytes = encodePng(picture, bits, 2.2f, problem);
            ASSERT_TRUE(bytes) << problem;
            const auto back = decodePng(*bytes, problem);
            ASSERT_TRUE(back) << problem;
            EXPECT_EQ(back->metadata.at("renderer"), "candela");
            ASSERT_EQ(back->channels.size(), names.size());
            for (const PictureChannel &channel : picture.channels)
                for (std::size_t i = 0; i < channel.values.size(); ++i)
                    ASSERT_EQ(back->find(channel.name)->values[i], channel.values[i] / largest);
        }
}

TEST(PictureFile, PngClampsAndRefuses) {
    Picture picture = makePicture({"Y"}, {3, 1, 0, 3, 0, 1}, 1);
    picture.channels[0].values = {-5, NAN, 1e30f};
    std::string problem;
    const auto back = decodePng(*encodePng(picture, 8, 1, problem), problem);
    EXPECT_EQ(back->channels[0].values, (std::vector<float>{0, 0, 1}));
    EXPECT_FALSE(
        encodePng(makePicture({"1", "2", "3", "4", "5"}, picture.window, 1), 8, 1, problem));
    EXPECT_NE(problem.find("1 to 4 channels"), std::string::npos);
}

TEST(PictureFile, EveryPrefixIsReported) {
    const Picture picture = makePicture({"R", "G", "B"}, {12, 40, 0, 12, 0, 40}, 256);
    std::string problem;
    const std::string exr = *encodeExr(picture, problem), png = *encodePng(picture, 8, 1, problem);
    for (std::size_t size = 0; size < exr.size(); ++size) {
        problem.clear();
        ASSERT_FALSE(decodeExr(std::string_view(exr).substr(0, size), problem)) << size;
        ASSERT_FALSE(problem.empty());
    }
    for (std::size_t size = 0; size < png.size(); ++size) {
        problem.clear();
        ASSERT_FALSE(decodePng(std::string_view(png).substr(0, size), problem)) << size;
        ASSERT_FALSE(problem.empty());
    }
}

TEST(PictureFile, DamagedBytesNeverCrash) {
    const Picture picture = makePicture({"R", "G", "B"}, {12, 20, 0, 12, 0, 20}, 256);
    std::string problem;
    const std::string exr = *encodeExr(picture, problem), png = *encodePng(picture, 8, 1, problem);
    int refused = 0;
    for (int k = 0; k < 400; ++k) {
        std::string damagedExr = exr, damagedPng = png;
        // Mostly the header, where sizes and offsets stand.
        const std::size_t reach = k % 2 ? exr.size() : 400;
        damagedExr[mixBits(2 * k) % reach] = char(mixBits(2 * k + 1));
        damagedPng[mixBits(2 * k) % png.size()] = char(mixBits(2 * k + 1));
        for (const auto &result :
             {decodeExr(damagedExr, problem), decodePng(damagedPng, problem)}) {
            refused += !result;
            if (!result)
                continue;
            for (const PictureChannel &channel : result->channels)
                ASSERT_EQ(channel.values.size(), result->window.pixels());
        }
    }
    EXPECT_GT(refused, 100);
}

TEST(PictureFile, ReadPictureNamesTheFile) {
    std::string folder = (std::filesystem::temp_directory_path() / "candela_read_XXXXXX").string();
    ASSERT_TRUE(::mkdtemp(folder.data()));
    std::string problem;
    const Picture picture = makePicture({"Y"}, {3, 2, 0, 3, 0, 2}, 256);
    ASSERT_TRUE(writeWholeFile(folder + "/a", *encodePng(picture, 8, 1, problem), problem));
    ASSERT_TRUE(writeWholeFile(folder + "/b", *encodeExr(picture, problem), problem));
    ASSERT_TRUE(writeWholeFile(folder + "/c", "not a picture", problem));
    ASSERT_TRUE(writeWholeFile(folder + "/empty", "", problem));
    EXPECT_TRUE(readPicture(folder + "/a", problem));
    EXPECT_TRUE(readPicture(folder + "/b", problem));
    for (const char *name : {"/c", "/empty", "/missing", "/", "/a/below"}) {
        EXPECT_FALSE(readPicture(folder + name, problem));
        EXPECT_NE(problem.find(folder + name), std::string::npos) << problem;
    }
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace candela

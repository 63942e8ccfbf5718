// SPDX-License-Identifier: Apache-2.0
#include "image/picture_maps.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

/// Of 2 x 1 pixels; channel k is k, k + .5.
Picture pictureOf(std::initializer_list<const char *> channels) {
    Picture picture;
    picture.window = {3, 3, 1, 3, 1, 2};
    picture.metadata["scene"] = "a.rib";
    picture.worldToNdc = Matrix4{};
    for (const char *name : channels) {
        const float k = float(picture.channels.size());
        picture.channels.push_back({name, {k, k + .5f}});
    }
    return picture;
}

std::vector<float> valuesAt1(const ImageMaps &maps, const std::string &name) {
    std::vector<float> values;
    if (const OwnedImage *map = maps.find(name))
        for (int c = 0; c < map->channels(); ++c)
            values.push_back(map->row(c, 0)[1]);
    return values;
}

using Values = std::vector<float>;

TEST(PictureMaps, channelsAndLayersAreMaps) {
    struct Case {
        std::initializer_list<const char *> channels;
        const char *map;
        Values expected; ///< At the second pixel.
    };
    const Case table[] = {
        {{"B", "G", "R"}, "Ci", {2.5f, 1.5f, .5f}},
        {{"Y"}, "Ci", {.5f, .5f, .5f}},
        {{"radiance.B", "radiance.G", "radiance.R"}, "Ci", {2.5f, 1.5f, .5f}},
        {{"R", "G", "B", "radiance.B", "radiance.G", "radiance.R"}, "Ci", {.5f, 1.5f, 2.5f}},
        {{"R", "G", "B", "radiance.B", "radiance.G", "radiance.R"}, "radiance", {5.5f, 4.5f, 3.5f}},
        {{"R", "G", "B", "A"}, "Oi", {3.5f, 3.5f, 3.5f}},
        {{"R", "G", "B"}, "Oi", {1, 1, 1}},
        {{"R", "G", "B", "A", "Oi.R", "Oi.G", "Oi.B"}, "Oi", {4.5f, 5.5f, 6.5f}},
        {{"R", "G", "B", "Z"}, "Z", {3.5f}},
        {{"R", "G", "B", "id"}, "id", {3.5f}},
        {{"R", "G", "B", "N.Z", "N.Y", "N.X"}, "N", {5.5f, 4.5f, 3.5f}},
        {{"R", "G", "B", "half0.R", "half0.G", "half0.B", "half0.A"},
         "half0",
         {3.5f, 4.5f, 5.5f, 6.5f}},
        {{"R", "G", "B", "m.0", "m.1", "m.2", "m.3", "m.4"}, "m", {3.5f, 4.5f, 5.5f, 6.5f, 7.5f}},
        {{"R", "G", "B"}, "N", {}},
        {{"R", "G", "B", "N.X"}, "N", {}},
    };
    for (const Case &test : table) {
        std::string problem;
        const std::vector<std::string> names{test.map};
        const ImageMaps maps = mapsOf(pictureOf(test.channels), names, problem);
        EXPECT_EQ(problem, "");
        EXPECT_EQ(valuesAt1(maps, test.map), test.expected) << test.map;
    }
}

TEST(PictureMaps, aPictureWithoutColoursIsNone) {
    std::string problem;
    EXPECT_TRUE(mapsOf(pictureOf({"Z", "A"}), {}, problem).names().empty());
    EXPECT_NE(problem.find("no colours"), std::string::npos);
}

TEST(PictureMaps, whatIsNotFiniteIsLeftToTheStackInCiAlone) {
    Picture picture = pictureOf({"R", "G", "B", "variance.R", "variance.G", "variance.B"});
    picture.channels[0].values[1] = picture.channels[3].values[1] = INFINITY;
    std::string problem;
    const std::vector<std::string> names{"variance"};
    const ImageMaps maps = mapsOf(picture, names, problem);
    EXPECT_EQ(valuesAt1(maps, "Ci")[0], INFINITY);
    EXPECT_EQ(valuesAt1(maps, "variance")[0], 0);
}

std::vector<std::string> namesOf(const Picture &picture) {
    std::vector<std::string> names;
    for (const PictureChannel &channel : picture.channels)
        names.push_back(channel.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(PictureMaps, allChannelsGoThrough) {
    Picture picture = pictureOf({"R", "G", "B", "A", "Z"});
    std::string problem;
    ImageMaps maps = mapsOf(picture, {}, problem);
    maps.find("Ci")->row(1, 0)[1] = 7;
    EXPECT_TRUE(putMaps(maps, {}, picture).empty());
    EXPECT_EQ(namesOf(picture), (Names{"R", "G", "B", "A", "Z"}));
    EXPECT_EQ(picture.find("G")->values, (Values{1, 7}));
    EXPECT_EQ(picture.find("Z")->values, (Values{4, 4.5f}));
    EXPECT_EQ(picture.window, (FrameWindow{3, 3, 1, 3, 1, 2}));
    EXPECT_EQ(picture.metadata.at("scene"), "a.rib");
    EXPECT_TRUE(picture.worldToNdc);
}

TEST(PictureMaps, radianceStaysBesideWhatIsMadeOfIt) {
    Picture picture = pictureOf({"radiance.R", "radiance.G", "radiance.B"});
    std::string problem;
    ImageMaps maps = mapsOf(picture, {}, problem);
    maps.find("Ci")->row(0, 0)[1] = 7;
    putMaps(maps, {}, picture);
    EXPECT_EQ(picture.find("radiance.R")->values, (Values{0, .5f}));
    EXPECT_EQ(picture.find("R")->values, (Values{0, 7}));
}

TEST(PictureMaps, greyBecomesColour) {
    Picture picture = pictureOf({"Y", "A"});
    std::string problem;
    const ImageMaps maps = mapsOf(picture, {}, problem);
    putMaps(maps, {}, picture);
    EXPECT_EQ(namesOf(picture), (Names{"A", "R", "G", "B"}));
}

TEST(PictureMaps, mapsThatFiltersSetBecomeChannels) {
    Picture picture = pictureOf({"R", "G", "B", "N.X", "N.Y", "N.Z", "A"});
    std::string problem;
    const std::vector<std::string> names{"N", "Oi"};
    ImageMaps maps = mapsOf(picture, names, problem);
    maps.set("mine", OwnedImage(2, 1, 1)).row(0, 0)[1] = 3;
    maps.set("tint", OwnedImage(2, 1, 3)).row(2, 0)[1] = 4;
    maps.find("N")->row(1, 0)[1] = 9;
    const Names set{"mine", "tint", "N", "nobody's"};
    EXPECT_TRUE(putMaps(maps, set, picture).empty());
    EXPECT_EQ(picture.find("mine")->values, (Values{0, 3}));
    EXPECT_EQ(picture.find("tint.B")->values, (Values{0, 4}));
    EXPECT_EQ(picture.find("N.Y")->values[1], 9);
    EXPECT_EQ(picture.find("A")->values[1], 6.5f);
}

TEST(PictureMaps, opacityGoesIntoAlpha) {
    Picture picture = pictureOf({"R", "G", "B", "A"});
    std::string problem;
    ImageMaps maps = mapsOf(picture, Names{"Oi"}, problem);
    for (int c = 0; c < 3; ++c)
        maps.find("Oi")->row(c, 0)[1] = float(c + 1);
    putMaps(maps, Names{"Oi"}, picture);
    EXPECT_EQ(namesOf(picture), (Names{"R", "G", "B", "A"}));
    EXPECT_EQ(picture.find("A")->values, (Values{3, 2}));
}

TEST(PictureMaps, anotherSizeTakesOutWhatHasItNot) {
    Picture picture = pictureOf({"R", "G", "B", "A", "Z"});
    std::string problem;
    const std::vector<std::string> names{"Oi"};
    ImageMaps maps = mapsOf(picture, names, problem);
    maps.set("Ci", OwnedImage(5, 4, 3));
    maps.set("mine", OwnedImage(5, 4, 1));
    const Names set{"mine"};
    EXPECT_EQ(putMaps(maps, set, picture), (Names{"A", "Z"}));
    EXPECT_EQ(namesOf(picture), (Names{"R", "G", "B", "mine"}));
    EXPECT_EQ(picture.window, (FrameWindow{5, 4, 0, 5, 0, 4}));
    EXPECT_EQ(picture.find("R")->values.size(), 20u);
    EXPECT_FALSE(picture.worldToNdc);
    EXPECT_EQ(picture.metadata.at("scene"), "a.rib");
}

} // namespace
} // namespace candela

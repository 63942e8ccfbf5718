// SPDX-License-Identifier: Apache-2.0
#include "image/merge_pictures.h"

#include <functional>
#include <gtest/gtest.h>

namespace candela {
namespace {

NamedPicture picture(const std::string &name, const std::string &seed, const std::string &samples,
                     float value) {
    Picture result;
    result.window = {2, 1, 0, 2, 0, 1};
    for (const char *channel : {"R", "half0.R", "variance.R", "Z", "id"})
        result.channels.push_back({channel, {value, 2 * value}});
    result.metadata = {{"seed", seed}, {"spp", samples}, {"exposure", "1 1"}, {"scene", "a.rib"}};
    return {name, result};
}

std::string refusal(const std::vector<NamedPicture> &pictures) {
    std::string problem;
    EXPECT_FALSE(mergePictures(pictures, problem));
    return problem;
}

TEST(Merge, WeighsPicturesByTheirSamples) {
    std::string problem;
    const auto merged = mergePictures(
        {picture("a", "1", "16", 1), picture("b", "2", "48", 5), picture("c", "3", "64", 3)},
        problem);
    ASSERT_TRUE(merged) << problem;
    // (16 + 5 * 48 + 3 * 64) / 128, and with squares for variances of means.
    EXPECT_EQ(merged->find("R")->values, (std::vector<float>{3.5f, 7}));
    EXPECT_EQ(merged->find("half0.R")->values, (std::vector<float>{3.5f, 7}));
    const float variance = (1 * 16 * 16 + 5 * 48 * 48 + 3 * 64 * 64) / float(128 * 128);
    EXPECT_FLOAT_EQ(merged->find("variance.R")->values[0], variance);
    EXPECT_EQ(merged->find("Z")->values, (std::vector<float>{1, 2}));
    EXPECT_EQ(merged->find("id")->values, (std::vector<float>{1, 2}));
    EXPECT_EQ(merged->metadata.at("spp"), "128");
    EXPECT_EQ(merged->metadata.at("seed"), "1 2 3");
}

TEST(Merge, OfAMergedPictureIsThatOfAll) {
    const NamedPicture a = picture("a", "1", "16", 1), b = picture("b", "2", "48", 5),
                       c = picture("c", "3", "64", 3);
    std::string problem;
    const auto ab = mergePictures({a, b}, problem);
    ASSERT_TRUE(ab);
    EXPECT_EQ(mergePictures({{"ab", *ab}, c}, problem)->find("R")->values,
              mergePictures({a, b, c}, problem)->find("R")->values);
    EXPECT_NE(refusal({{"ab", *ab}, b}).find("of seed 2, as ab is"), std::string::npos);
}

TEST(Merge, RefusesWhatIsNotOfOneFrame) {
    struct Row {
        std::function<void(Picture &)> change;
        std::string says;
    };
    const Row rows[] = {
        {[](Picture &p) { p.metadata["seed"] = "1"; }, "same samples"},
        {[](Picture &p) { p.metadata.erase("spp"); }, "does not say its samples"},
        {[](Picture &p) { p.metadata["spp"] = "-4"; }, "does not say its samples"},
        {[](Picture &p) { p.metadata["spp"] = "many"; }, "does not say its samples"},
        {[](Picture &p) { p.metadata.erase("seed"); }, "does not say its samples"},
        {[](Picture &p) { p.metadata["exposure"] = "1 2.2"; }, "exposed"},
        {[](Picture &p) { p.metadata["quantize"] = "255 0 255 .5"; }, "quantised"},
        {[](Picture &p) { p.metadata["filters"] = "bloom"; }, "filtered"},
        {[](Picture &p) { p.metadata["scene"] = "b.rib"; }, "its scene is \"b.rib\""},
        {[](Picture &p) { p.window.width = 3; }, "other pixels"},
        {[](Picture &p) { p.channels.pop_back(); }, "other channels"},
        {[](Picture &p) { p.worldToCamera = Matrix4(); }, "camera"},
    };
    for (const Row &row : rows) {
        NamedPicture other = picture("b", "2", "16", 1);
        row.change(other.picture);
        const std::string said = refusal({picture("a", "1", "16", 1), other});
        EXPECT_NE(said.find(row.says), std::string::npos) << row.says << ": " << said;
        EXPECT_TRUE(said.starts_with("b cannot be merged with a")) << said;
    }
}

} // namespace
} // namespace candela

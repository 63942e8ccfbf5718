// SPDX-License-Identifier: Apache-2.0
// One scene, one seed, one picture: not a bit may depend on how the work is divided.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

/// The pictures of a run, with any options.
class Rendering {
public:
    explicit Rendering(const std::vector<std::string> &options) {
        const std::string here = CANDELA_SOURCE_DIR "/tests/determinism";
        std::vector<std::string> arguments{here + "/everything.rib", "--shader-path",
                                           here + "/shaders", "--output-dir", folder_.path()};
        arguments.insert(arguments.end(), options.begin(), options.end());
        Outcome run = runCandela(arguments);
        EXPECT_EQ(run.status, 0) << run.text();
        color = read("everything.exr");
        first = read("first.exr");
    }

    Picture color; ///< R, G, B, A
    Picture first; ///< Z, N, id

private:
    ScratchFolder folder_;

    Picture read(const std::string &name) {
        std::string problem;
        std::optional<Picture> picture = readPicture(folder_.path(name), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }
};

/// How many pixels of the part are not, bit by bit, those of the whole.
std::size_t differences(const Picture &part, const Picture &whole) {
    std::size_t count = 0;
    EXPECT_FALSE(part.channels.empty());
    EXPECT_EQ(part.channels.size(), whole.channels.size());
    for (const PictureChannel &channel : part.channels) {
        const PictureChannel *other = whole.find(channel.name);
        if (!other)
            return part.window.pixels();
        std::size_t i = 0;
        for (int y = part.window.y0; y < part.window.y1; ++y)
            for (int x = part.window.x0; x < part.window.x1; ++x, ++i) {
                std::size_t at = std::size_t(y - whole.window.y0) * whole.window.columns() +
                                 (x - whole.window.x0);
                count += std::memcmp(&channel.values[i], &other->values[at], sizeof(float)) != 0;
            }
    }
    return count;
}

void expectSame(const Rendering &part, const Rendering &whole) {
    EXPECT_EQ(differences(part.color, whole.color), 0u);
    EXPECT_EQ(differences(part.first, whole.first), 0u);
}

/// Rendered once for all tests.
const Rendering &reference() {
    static const Rendering run({"--threads", "2", "--lanes", "16"});
    return run;
}

} // namespace

// A black or flat picture would be the same in any case.
TEST(Determinism, TheSceneShowsSomething) {
    const Picture &picture = reference().color;
    ASSERT_EQ(picture.window.pixels(), 72u * 54u);
    double sum = 0, squares = 0;
    for (float value : picture.find("R")->values) {
        ASSERT_TRUE(std::isfinite(value));
        sum += value;
        squares += double(value) * value;
    }
    double count = 72 * 54, mean = sum / count;
    EXPECT_GT(mean, 0.05);
    EXPECT_GT(std::sqrt(squares / count - mean * mean), 0.3 * mean);
    EXPECT_EQ(differences(reference().color, reference().color), 0u);
}

TEST(Determinism, AnotherSeedIsAnotherPicture) {
    EXPECT_GT(differences(Rendering({"--seed", "1"}).color, reference().color), 1000u);
}

TEST(Determinism, OneThread) { expectSame(Rendering({"--threads", "1"}), reference()); }

TEST(Determinism, OneLane) { expectSame(Rendering({"--lanes", "1"}), reference()); }

TEST(Determinism, CropsJoin) {
    std::size_t pixels = 0;
    for (const char *crop : {"0,0.3,0,0.55", "0.3,1,0,0.55", "0,0.77,0.55,1", "0.77,1,0.55,1"}) {
        Rendering part({"--crop", crop});
        expectSame(part, reference());
        pixels += part.color.window.pixels();
    }
    EXPECT_EQ(pixels, reference().color.window.pixels());
}

TEST(Determinism, CropsJoinAtOneLaneAndOneThread) {
    expectSame(Rendering({"--crop", "0.21,0.68,0.33,0.71", "--lanes", "1", "--threads", "1"}),
               reference());
}

// Pixels take different numbers of samples, and look at those around them, beyond the crop too.
TEST(Determinism, AdaptiveSampling) {
    const auto rendered = [](std::vector<std::string> options) {
        options.insert(options.end(), {"--spp", "128", "--pixel-variance", "2e-3"});
        return Rendering(options);
    };
    const Rendering whole = rendered({"--threads", "2", "--lanes", "16"});
    ASSERT_TRUE(whole.color.metadata.contains("sppRange"));
    EXPECT_EQ(whole.color.metadata.at("sppRange"), "16 to 128");
    expectSame(rendered({"--threads", "1", "--lanes", "1"}), whole);
    for (const char *crop : {"0,0.3,0,0.55", "0.21,0.68,0.33,0.71", "0.77,1,0.55,1"})
        expectSame(rendered({"--crop", crop}), whole);
}

} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// Displays whose pictures somebody takes, while they are made and when they are done.
#include "foundation/base/whole_file.h"
#include "image/picture_file.h"
#include "render/interrupt.h"
#include "render/render.h"

#include <atomic>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace candela {
namespace {

/// Takes framebuffers, and, if it is told to, has enough at the first glance.
class Onlooker final : public DisplayTaker {
public:
    Interest interestIn(const std::string &type) override {
        return type == "framebuffer" ? Interest::Instead : Interest::None;
    }
    void take(const std::string &display, Picture picture, bool isFinished) override {
        EXPECT_EQ(display, "seen");
        EXPECT_EQ(finished, 0) << "nothing comes after the finished picture";
        (isFinished ? finished : unfinished) += 1;
        last = std::move(picture);
    }
    bool wantsUnfinished() const override { return wants; }
    bool wantsEnd() const override { return endsEarly && unfinished > 0; }

    bool wants = true, endsEarly = false;
    std::atomic<int> unfinished{0}, finished{0};
    Picture last;
};

class TakenDisplays : public testing::Test {
protected:
    TakenDisplays()
        : folder_(std::string(CANDELA_BINARY_DIR) + "/taken." + std::to_string(::getpid())) {
        std::filesystem::create_directory(folder_);
    }
    ~TakenDisplays() override { std::filesystem::remove_all(folder_); }

    std::string path(const std::string &name) const { return folder_ + "/" + name; }

    /// Some seconds of work, if it is done to its end.
    int render(const std::string &displays, int samples, DisplayTaker *taker,
               const std::string &output = {}) const {
        std::ofstream(path("scene.rib"))
            << displays
            << "Format 64 48 1 PixelFilter \"box\" 1 1 Projection \"perspective\" \"fov\" [40]\n"
               "Option \"render\" \"string integrator\" \"path\" Translate 0 0 5 WorldBegin\n"
               "LightSource \"pointlight\" 1 \"from\" [3 3 -3] \"intensity\" [20]\n"
               "Surface \"matte\" Sphere 1 -1 1 360 Translate 0 -1 0 Rotate 90 1 0 0\n"
               "Disk 0 3 360 WorldEnd\n";
        RenderSettings settings;
        settings.quiet = true;
        settings.threads = 1;
        settings.samplesPerPixel = samples;
        settings.outputDirectory = folder_;
        settings.outputFile = output;
        settings.taker = taker;
        return renderFiles({path("scene.rib")}, settings);
    }

    const std::string folder_;
};

std::string bytesOf(const std::string &file) {
    std::string problem;
    return readWholeFile(file, problem).value_or("");
}

constexpr const char *both = "Display \"seen\" \"framebuffer\" \"rgba\"\n"
                             "Display \"+file.exr\" \"openexr\" \"rgba\"\n";

// Whoever looks changes nothing.
TEST_F(TakenDisplays, areSeenInTheMakingAndAreWhatFilesAre) {
    Onlooker onlooker;
    ASSERT_EQ(render(both, 1000, &onlooker), 0);
    EXPECT_GT(onlooker.unfinished, 0);
    EXPECT_EQ(onlooker.finished, 1);
    EXPECT_FALSE(std::filesystem::exists(path("seen.exr")));
    const std::string watched = bytesOf(path("file.exr"));
    std::string problem;
    const auto file = readPicture(path("file.exr"), problem);
    ASSERT_TRUE(file) << problem;
    ASSERT_EQ(onlooker.last.channels.size(), 4u);
    for (const PictureChannel &channel : onlooker.last.channels)
        EXPECT_EQ(channel.values, file->find(channel.name)->values) << channel.name;
    ASSERT_EQ(render("Display \"file.exr\" \"openexr\" \"rgba\"\n", 1000, nullptr), 0);
    EXPECT_EQ(bytesOf(path("file.exr")), watched);
}

TEST_F(TakenDisplays, areNotDisturbedByWhoWaitsForTheEnd) {
    Onlooker onlooker;
    onlooker.wants = false;
    ASSERT_EQ(render(both, 4, &onlooker), 0);
    EXPECT_EQ(onlooker.unfinished, 0);
    EXPECT_EQ(onlooker.finished, 1);
}

TEST_F(TakenDisplays, endTheRenderWhenTheirTakerHasEnough) {
    Onlooker onlooker;
    onlooker.endsEarly = true;
    EXPECT_EQ(render(both, 1 << 20, &onlooker), statusOfInterrupt);
    EXPECT_EQ(onlooker.finished, 1);
    std::string problem;
    const auto file = readPicture(path("file.exr"), problem);
    ASSERT_TRUE(file) << problem;
    EXPECT_EQ(file->channels[0].values, onlooker.last.find(file->channels[0].name)->values);
}

TEST_F(TakenDisplays, areFilesWithoutATakerOrWhereAFileIsAskedFor) {
    const std::string window = "Display \"seen\" \"x11\" \"rgba\"\n"; // An old name of the type.
    EXPECT_EQ(render(window, 1, nullptr), 0);
    EXPECT_TRUE(std::filesystem::exists(path("seen.exr")));
    Onlooker onlooker;
    EXPECT_EQ(render(window, 1, &onlooker), 0);
    EXPECT_EQ(onlooker.finished, 1);
}

// Filters and imagers have a finished picture alone.
TEST_F(TakenDisplays, haveWhatFiltersMake) {
    Onlooker onlooker;
    EXPECT_EQ(
        render("PushFilter \"linear_scale\" Exposure 2 1\n" + std::string(both), 1, &onlooker), 0);
    std::string problem;
    const auto file = readPicture(path("file.exr"), problem);
    ASSERT_TRUE(file) << problem;
    EXPECT_EQ(onlooker.last.find("R")->values, file->find("R")->values);
}

} // namespace
} // namespace candela

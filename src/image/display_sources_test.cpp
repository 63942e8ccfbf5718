// SPDX-License-Identifier: Apache-2.0
// What filters have made, on its way to displays.
#include "image/displays.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

/// A film of 4 x 2 pixels: Ci = 0.25, Oi = 0.5, z = 3, N = (0.75, 0.75, 0.75).
class FilteredDisplays : public testing::Test {
protected:
    FilteredDisplays() : film_(settings()) {
        const float color = .25f, opacity = .5f, z = 3, normal = .75f, weight = 1;
        const float *planes[] = {&color,   &color, &color,  &opacity, &opacity,
                                 &opacity, &z,     &normal, &normal,  &normal};
        for (int y = 0; y < 2; ++y)
            for (int x = 0; x < 4; ++x)
                for (int sample = 0; sample < 2; ++sample)
                    film_.add({1, &x, &y, &sample, &weight, planes});
        filtered_.maps.set("Ci", constant(4, 2, 3, .5f));
    }
    static Film::Settings settings() {
        Film::Settings settings;
        settings.window = {4, 2, 0, 4, 0, 2};
        settings.channels = {{"z", 1}, {"N", 3}};
        settings.keepHalves = true;
        return settings;
    }
    static OwnedImage constant(int width, int height, int channels, float value) {
        OwnedImage image(width, height, channels);
        for (int c = 0; c < channels; ++c)
            for (int y = 0; y < height; ++y)
                std::fill_n(image.row(c, y), width, value);
        return image;
    }
    void set(const std::string &name, OwnedImage image) {
        filtered_.maps.set(name, std::move(image));
        filtered_.set.push_back(name);
    }
    std::vector<DisplayPlane> planes(const std::string &mode) {
        std::string problem;
        const std::vector<ChannelInfo> available{{"z", 1}, {"N", 3}, {"mine", 1}};
        return displayPlanes(mode, available, problem).value_or(std::vector<DisplayPlane>());
    }
    /// The value of the picture's channel, which is the same everywhere.
    float shown(const std::string &mode, const std::string &channel,
                const PlaneSettings &settings = {}) {
        const DisplaySources sources(film_, &filtered_, imaged_ ? &*imaged_ : nullptr);
        const Picture picture = developPicture(sources, planes(mode), settings);
        const PictureChannel *found = picture.find(channel);
        if (!found || found->values.size() != picture.window.pixels())
            return NAN;
        for (float value : found->values)
            EXPECT_EQ(value, found->values[0]);
        return found->values[0];
    }

    Film film_;
    FilteredPicture filtered_;
    std::optional<ImagedPicture> imaged_;
};

TEST_F(FilteredDisplays, coloursAreFilteredAndAllElseIsRaw) {
    PlaneSettings settings;
    settings.exposure.gain = 2;
    EXPECT_EQ(shown("rgbaz,radiance,N,Oi", "R", settings), 1); // Exposed behind the filters.
    EXPECT_EQ(shown("rgbaz,radiance,N,Oi", "radiance.R", settings), .25f);
    EXPECT_EQ(shown("rgbaz,radiance,N,Oi", "A"), .5f);
    EXPECT_EQ(shown("rgbaz,radiance,N,Oi", "Z"), 3);
    EXPECT_EQ(shown("rgbaz,radiance,N,Oi", "N.Y"), .75f);
    settings.halves = true;
    EXPECT_EQ(shown("rgb", "half0.R", settings), .5f); // Of the film, through exposure.
}

TEST_F(FilteredDisplays, whatFiltersHaveSetIsShown) {
    set("Oi", constant(4, 2, 3, 1));
    set("Z", constant(4, 2, 1, 8));
    set("N", constant(4, 2, 3, -1));
    set("mine", constant(4, 2, 1, 6));
    EXPECT_EQ(shown("rgbaz,Oi,N,mine", "A"), 1);
    EXPECT_EQ(shown("rgbaz,Oi,N,mine", "Oi.G"), 1);
    EXPECT_EQ(shown("rgbaz,Oi,N,mine", "Z"), 8);
    EXPECT_EQ(shown("rgbaz,Oi,N,mine", "N.X"), -1);
    EXPECT_EQ(shown("rgbaz,Oi,N,mine", "mine"), 6);
}

TEST_F(FilteredDisplays, aMapThatIsReadOnlyChangesNothing) {
    filtered_.maps.set("N", constant(4, 2, 3, 0));
    EXPECT_EQ(shown("N", "N.X"), .75f);
}

TEST_F(FilteredDisplays, thePictureTakesTheSizeThatFiltersGive) {
    filtered_.maps.set("Ci", constant(2, 5, 3, .5f));
    const DisplaySources sources(film_, &filtered_);
    const Picture picture = developPicture(sources, planes("rgb"), {});
    EXPECT_EQ(picture.window, (FrameWindow{2, 5, 0, 2, 0, 5}));
    EXPECT_EQ(sizeOfPlane(sources, planes("rgb")[0]), (PlaneSize{2, 5}));
    EXPECT_EQ(sizeOfPlane(sources, planes("a")[0]), (PlaneSize{4, 2}));
    set("Oi", constant(2, 5, 3, 1));
    EXPECT_EQ(sizeOfPlane(DisplaySources(film_, &filtered_), planes("a")[0]), (PlaneSize{2, 5}));
    EXPECT_FALSE(sizeOfPlane(sources, planes("mine")[0]));
}

TEST_F(FilteredDisplays, anImagerHasTheLastWordOnColourAndAlpha) {
    imaged_ = ImagedPicture{{4, 2}, {}, std::vector<float>(8, 1)};
    imaged_->color.assign(3, std::vector<float>(8, .125f));
    PlaneSettings settings;
    settings.exposure.gain = 2; // Has been applied before the imager.
    EXPECT_EQ(shown("rgba,Oi", "R", settings), .125f);
    EXPECT_EQ(shown("rgba,Oi", "A", settings), 1);
    EXPECT_EQ(shown("rgba,Oi", "Oi.R", settings), .5f);
}

} // namespace
} // namespace candela

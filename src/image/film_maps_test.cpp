// SPDX-License-Identifier: Apache-2.0
#include "image/film_maps.h"
#include "image/kept_samples.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

const std::vector<ChannelInfo> available{{"z", 1}, {"N", 3}, {"id", 1}, {"albedo", 3}};

Film::Settings settingsFor(std::vector<std::string> names) {
    Film::Settings settings;
    settings.window = {4, 4, 1, 3, 0, 2};
    wantMaps(names, available, settings);
    return settings;
}

/// Two samples a pixel: component k of the film is k + 1 in the even one, k + 3 in the odd one.
void fill(SampleSink &film, int samples) {
    int components = 0;
    for (const ChannelInfo &channel : film.channels())
        components += channel.components;
    for (int y = 0; y < 2; ++y)
        for (int x = 1; x < 3; ++x)
            for (int sample = 0; sample < samples; ++sample) {
                std::vector<float> values;
                std::vector<const float *> planes;
                for (int k = 0; k < components; ++k)
                    values.push_back(float(k + 1 + 2 * sample));
                for (const float &value : values)
                    planes.push_back(&value);
                const float weight = 1;
                film.add({1, &x, &y, &sample, &weight, planes.data()});
            }
}

float at(const ImageMaps &maps, const std::string &name, int channel) {
    const OwnedImage *map = maps.find(name);
    return map ? map->row(channel, 1)[1] : NAN;
}

TEST(FilmMaps, onlyWhatIsAskedForIsKept) {
    EXPECT_TRUE(settingsFor({}).channels.empty());
    EXPECT_TRUE(settingsFor({"Oi", "variance", "radiance", "mine"}).channels.empty());
    EXPECT_FALSE(settingsFor({"Oi", "variance", "N"}).keepHalves);
    const Film::Settings some = settingsFor({"N", "Z", "N"});
    ASSERT_EQ(some.channels.size(), 2u);
    EXPECT_EQ(some.channels[0].name, "N");
    EXPECT_EQ(some.channels[1].name, "z");
    EXPECT_TRUE(settingsFor({"half1"}).keepHalves);
}

TEST(FilmMaps, holdTheFilmsMeans) {
    const std::vector<std::string> names{"Oi", "Z", "N", "variance", "half0", "half1", "radiance"};
    Film film(settingsFor(names));
    fill(film, 2);
    ImageMaps maps;
    addMaps(film, names, maps);
    ASSERT_TRUE(maps.find("Ci"));
    EXPECT_EQ(maps.find("Ci")->width(), 2);
    for (int c = 0; c < 3; ++c) {
        EXPECT_EQ(at(maps, "Ci", c), float(c + 2));
        EXPECT_EQ(at(maps, "radiance", c), float(c + 2));
        EXPECT_EQ(at(maps, "Oi", c), float(c + 5));
        EXPECT_EQ(at(maps, "half0", c), float(c + 1));
        EXPECT_EQ(at(maps, "half1", c), float(c + 3));
        EXPECT_EQ(at(maps, "variance", c), 1); // Of the mean of two that are 2 apart.
        EXPECT_EQ(at(maps, "N", c), film.mean(film.channelIndex("N"), c)[3]);
    }
    EXPECT_EQ(maps.find("Z")->channels(), 1);
    EXPECT_EQ(at(maps, "Z", 0), film.mean(film.channelIndex("z"), 0)[3]);
}

TEST(FilmMaps, whatNobodyGivesIsNotThere) {
    Film film(settingsFor({"N"}));
    fill(film, 2);
    const std::vector<std::string> names{"N", "albedo", "mine", "half0", "Z"};
    ImageMaps maps;
    addMaps(film, names, maps);
    EXPECT_EQ(maps.names(), (std::vector<std::string>{"Ci", "N"}));
}

TEST(FilmMaps, anUnknownVarianceIsZero) {
    const std::vector<std::string> names{"variance", "half1"};
    Film film(settingsFor(names));
    fill(film, 1);
    ImageMaps maps;
    addMaps(film, names, maps);
    EXPECT_EQ(at(maps, "variance", 0), 0);
    EXPECT_EQ(at(maps, "half1", 0), 0); // No odd sample.
}

TEST(FilmMaps, keptSamplesAreAMapOfAllOfThem) {
    Film film(settingsFor({"N"}));
    KeptSamples kept(film, 2);
    fill(kept, 3); // More than there is room for: no harm is done.
    EXPECT_EQ(film.mean(0, 0)[3], 3);
    const OwnedImage samples = kept.take();
    ASSERT_EQ(samples.channels(), 6);
    for (int channel = 0; channel < 6; ++channel)
        EXPECT_EQ(samples.row(channel, 1)[1], float(channel % 3 + 1 + 2 * (channel / 3)));
    EXPECT_EQ(KeptSamples::bytesNeeded({4, 4, 1, 3, 0, 2}, 2), OwnedImage::bytesNeeded(2, 2, 6));
}

TEST(FilmMaps, bytesCountWhatIsMade) {
    const double one = OwnedImage::bytesNeeded(2, 2, 1);
    EXPECT_EQ(bytesOfMaps({}, settingsFor({})), 6 * one);
    const std::vector<std::string> names{"Z", "N", "mine"};
    EXPECT_EQ(bytesOfMaps(names, settingsFor(names)), 10 * one);
}

} // namespace
} // namespace candela

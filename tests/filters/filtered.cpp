// SPDX-License-Identifier: Apache-2.0
#include "tests/filters/filtered.h"

#include "image/picture_file.h"

#include <algorithm>
#include <cmath>

namespace candela::test {

static const std::string shaders = CANDELA_SOURCE_DIR "/tests/filters/shaders";

std::string smallFrame(const std::string &more) {
    return "Option \"radiometry\" \"string units\" \"si\"\nFormat 16 12 1\nPixelSamples 1 1\n"
           "PixelFilter \"box\" 1 1\n" +
           more + "Projection \"orthographic\"\n";
}

std::string plainWorld(const std::string &color) {
    return "WorldBegin\nSurface \"constant\"\nColor " + color +
           "\nPolygon \"P\" [-5 -5 1  -5 5 1  5 5 1  5 -5 1]\nWorldEnd\n";
}

std::string ballWorld(const std::string &surface) {
    return "WorldBegin\nTranslate 0 0 5\n" + surface + "\nSphere .9 -.9 .9 360\nWorldEnd\n";
}

Outcome Filtered::run(const std::string &rib, const std::vector<std::string> &more) {
    std::vector<std::string> arguments{folder_.write("scene.rib", rib), "--output-dir",
                                       folder_.path(), "--shader-path", shaders};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runCandela(arguments);
}

Outcome Filtered::filter(const std::string &in, const std::string &out,
                         const std::vector<std::string> &words) {
    std::vector<std::string> arguments{"filter", folder_.path(in), folder_.path(out),
                                       "--shader-path", shaders};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return runCandela(arguments);
}

void Filtered::render(const std::string &rib, const std::vector<std::string> &more) {
    const Outcome outcome = run(rib, more);
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.errBesidesLight(), "");
}

Picture Filtered::read(const std::string &name) {
    std::string problem;
    std::optional<Picture> picture = readPicture(folder_.path(name), problem);
    EXPECT_TRUE(picture) << problem;
    return picture.value_or(Picture{});
}

float Filtered::at(const std::string &name, const std::string &channel, int x, int y) {
    const Picture picture = read(name);
    const PictureChannel *found = picture.find(channel);
    return found ? found->values[std::size_t(y * picture.window.columns() + x)] : NAN;
}

float Filtered::everywhere(const std::string &name, const std::string &channel) {
    const Picture picture = read(name);
    const PictureChannel *found = picture.find(channel);
    if (!found || found->values.empty())
        return NAN;
    const auto [least, most] = std::ranges::minmax(found->values);
    return least == most ? least : NAN;
}

std::vector<std::string> Filtered::channelsOf(const std::string &name) {
    std::vector<std::string> names;
    for (const PictureChannel &channel : read(name).channels)
        names.push_back(channel.name);
    std::ranges::sort(names);
    return names;
}

} // namespace candela::test

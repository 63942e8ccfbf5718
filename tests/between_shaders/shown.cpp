// SPDX-License-Identifier: Apache-2.0
#include "tests/between_shaders/shown.h"

#include "image/picture_file.h"

#include <numeric>

namespace candela::test {

std::string smallView(const std::string &displays) {
    return "Format 8 8 1\nPixelSamples 1 1\nPixelFilter \"box\" 1 1\n" + displays +
           "Projection \"orthographic\"\nScreenWindow -1 1 -1 1\n";
}

std::string squareAt(const std::string &z) {
    return "Patch \"bilinear\" \"P\" [-1 1 " + z + "  1 1 " + z + "  -1 -1 " + z + "  1 -1 " + z +
           "]\n";
}

void Shown::render(const std::string &rib, const std::vector<std::string> &more) {
    std::vector<std::string> arguments{folder_.write("scene.rib", rib), "--output-dir",
                                       folder_.path(), "--shader-path",
                                       CANDELA_SOURCE_DIR "/tests/between_shaders/shaders"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = runCandela(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(outcome.errBesidesLight(), "");
}

std::vector<float> Shown::plane(const std::string &file, const std::string &channel) {
    std::string problem;
    const std::optional<Picture> picture = readPicture(folder_.path(file), problem);
    EXPECT_TRUE(picture) << problem;
    const PictureChannel *found = picture ? picture->find(channel) : nullptr;
    EXPECT_NE(found, nullptr) << file << " has no " << channel;
    return found ? found->values : std::vector<float>{};
}

double meanOf(const std::vector<float> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

} // namespace candela::test

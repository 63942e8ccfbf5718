// SPDX-License-Identifier: Apache-2.0
#include "tests/support/frames.h"

#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

namespace {

std::string fileOf(std::size_t frame) { return "frame" + std::to_string(frame) + ".exr"; }

std::string ribOf(const std::vector<Frame> &frames) {
    std::string rib = "Option \"radiometry\" \"string units\" [\"si\"]\nPixelFilter \"box\" 1 1\n"
                      "Format 8 8 1\n";
    for (std::size_t i = 0; i < frames.size(); ++i)
        rib += "FrameBegin " + std::to_string(i) + "\nDisplay \"" + fileOf(i) +
               "\" \"openexr\" \"rgba\"\n" + frames[i].options + "WorldBegin\n" + frames[i].world +
               "WorldEnd\nFrameEnd\n";
    return rib;
}

} // namespace

std::vector<FramePixels> render(const std::vector<Frame> &frames, const FrameSettings &settings) {
    ScratchFolder folder;
    const std::string rib = folder.write("scene.rib", ribOf(frames));
    const Outcome run =
        runCandela({rib, "--quiet", "--threads", "1", "--spp", std::to_string(settings.samples),
                    "--seed", std::to_string(settings.seed), "--output-dir", folder.path(),
                    "--shader-path", CANDELA_SOURCE_DIR "/tests/" + settings.shaders});
    EXPECT_EQ(run.status, 0) << run.text();
    if (!settings.mayWarn) {
        EXPECT_EQ(run.errBesidesLight(), "");
    }
    std::vector<FramePixels> all;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::string problem;
        const std::optional<Picture> picture = readPicture(folder.path(fileOf(i)), problem);
        EXPECT_TRUE(picture) << frames[i].name << problem;
        if (!picture)
            return {};
        all.push_back(
            {picture->find("R")->values, picture->find("A")->values, picture->find("G")->values});
    }
    return all;
}

RedComparison compareRed(const FramePixels &picture, const FramePixels &other) {
    std::vector<double> differences;
    double sum = 0;
    for (std::size_t k = 0; k < picture.red.size(); ++k) {
        differences.push_back(picture.red[k] - other.red[k]);
        sum += picture.red[k];
    }
    return {sum / double(differences.size()), meanAndError(differences)};
}

} // namespace candela::test

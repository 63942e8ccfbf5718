// SPDX-License-Identifier: Apache-2.0
#include "tests/light/pictures.h"

#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {

SmallPicture takePicture(const std::string &options, const std::string &world, int samples,
                         int seed, int pixelsAcross) {
    const std::string across = std::to_string(pixelsAcross);
    ScratchFolder folder;
    const std::string rib = folder.write(
        "scene.rib", options + "Format " + across + " " + across +
                         " 1\nPixelFilter \"box\" 1 1\n"
                         "Display \"out.exr\" \"openexr\" \"rgba\"\nProjection \"orthographic\"\n"
                         "ScreenWindow -.1 .1 -.1 .1\nWorldBegin\n" +
                         world + "WorldEnd\n");
    const Outcome run =
        runCandela({rib, "--quiet", "--shader-path", CANDELA_SOURCE_DIR "/tests/light/shaders",
                    "--output-dir", folder.path(), "--spp", std::to_string(samples), "--seed",
                    std::to_string(seed), "--threads", "1"});
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    const std::optional<Picture> picture = readPicture(folder.path("out.exr"), problem);
    EXPECT_TRUE(picture) << problem;
    if (!picture)
        return {};
    return {picture->find("R")->values, picture->find("A")->values};
}

std::string squareAt(double z, double halfWidth) {
    std::ostringstream text;
    const double a = halfWidth;
    text << "Polygon \"P\" [" << -a << ' ' << -a << ' ' << z << ' ' << -a << ' ' << a << ' ' << z
         << ' ' << a << ' ' << a << ' ' << z << ' ' << a << ' ' << -a << ' ' << z << "]\n";
    return text.str();
}

} // namespace candela::test

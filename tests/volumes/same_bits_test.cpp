// SPDX-License-Identifier: Apache-2.0
// Not a bit of volumes, or of the light in them, depends on how the work is divided.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <vector>

namespace candela::test {
namespace {

/// A glass ball with a substance, a lamp with a surface and a small one, in haze.
const std::string scene = R"(
Format 20 16 1
PixelSamples 2 2
Display "out.exr" "openexr" "rgba"
Option "radiometry" "string units" ["si"]
Projection "perspective" "fov" [45]
Translate 0 0 3
WorldBegin
Atmosphere "haze" "color scattering" [.1 .1 .2] "float steps" [3] "float anisotropy" [.3]
LightSource "pointlight" 1 "intensity" [8] "from" [-1 1.2 -.5]
AttributeBegin
    AreaLightSource "arealight" 2 "radiance" [6]
    Translate 1 1.5 0
    Rotate 90 1 0 0
    Disk 0 .4 360
AttributeEnd
Illuminate 2 1
AttributeBegin
    Surface "glass"
    Interior "absorption" "color transmittance" [.3 .9 .5]
    Sphere .6 -.6 .6 360
AttributeEnd
AttributeBegin
    Surface "constant"
    Opacity [.4 .5 .6]
    Color [.2 .2 .5]
    Translate -.8 0 -.4
    Sphere .4 -.4 .4 360
AttributeEnd
Surface "matte"
Polygon "P" [-4 -1 4  -4 3 4  4 3 4  4 -1 4]
Polygon "P" [-4 -1 -3  -4 -1 4  4 -1 4  4 -1 -3]
WorldEnd
)";

std::vector<float> pixels(const std::string &integrator, const std::vector<std::string> &options) {
    ScratchFolder folder;
    std::vector<std::string> arguments{folder.write("scene.rib", scene), "--integrator", integrator,
                                       "--output-dir", folder.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome run = runCandela(arguments);
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    std::vector<float> all;
    if (const auto picture = readPicture(folder.path("out.exr"), problem))
        for (const PictureChannel &channel : picture->channels)
            all.insert(all.end(), channel.values.begin(), channel.values.end());
    return all;
}

TEST(SameBits, OfVolumesWhateverLanesAndThreads) {
    for (const std::string integrator : {"path", "classic"}) {
        const auto expected = pixels(integrator, {"--lanes", "16", "--threads", "2"});
        ASSERT_EQ(expected.size(), 4u * 20 * 16);
        for (const std::vector<std::string> &options :
             {std::vector<std::string>{"--lanes", "1", "--threads", "2"},
              {"--lanes", "16", "--threads", "3"}})
            EXPECT_TRUE(pixels(integrator, options) == expected)
                << integrator << ", " << options[1] << " lanes, " << options[3] << " threads";
    }
}

} // namespace
} // namespace candela::test

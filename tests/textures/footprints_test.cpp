// SPDX-License-Identifier: Apache-2.0
// du and dv against how u and v change from pixel to pixel: seen straight, at a low angle, in a
// mirror; on planes and spheres; in mirrored and stretched spaces and as instances.
#include "tests/textures/pictures.h"

#include "image/picture_file.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct View {
    const char *name, *placing, *shape;
};
const char *const patch = "Patch \"bilinear\" \"P\" [-1 1 0  1 1 0  -1 -1 0  1 -1 0]";
const View views[] = {
    {"from above", "Translate 0 0 5", patch},
    {"at a low angle", "Translate 0 0 5 Rotate 84 1 0 0", patch},
    {"turned at a low angle", "Translate 0 0 5 Rotate 80 1 0 0 Rotate 30 0 0 1", patch},
    {"stretched and mirrored", "Translate 0 0 5 Rotate 70 0 1 0 Scale -1 3 1 Rotate 45 0 0 1",
     patch},
    {"sheared", "Translate 0 0 5 Rotate 60 1 1 0 Skew 40 0 1 0 1 0 0", patch},
    {"sphere", "Translate 0 0 5 Rotate 90 1 0 0 Rotate 20 0 0 1", "Sphere 1.5 -1.5 1.5 360"},
    {"far", "Translate 0 0 5000 Scale 1000 1000 1000 Rotate 75 1 0 0", patch},
};

enum class Way { Straight, Mirror, Instance };

/// A picture of color(`told`) over a world: of places, by rays through the pixels' middles; of
/// extents, by one ray somewhere in a pixel, which stands for all of it.
Picture renderWorld(const ScratchFolder &folder, const std::string &world,
                    const std::string &told) {
    const std::string filter = told == "u, v" ? ".001 .001" : "1 1";
    folder.write("told.sl", "surface told() { Oi = 1; Ci = color(" + told + ", 1); }");
    folder.write("flat_mirror.sl", "surface flat_mirror() { Oi = 1; Ci = trace(P, reflect("
                                   "normalize(I), normalize(N))); }");
    const std::string scene = folder.write(
        "view.rib", "Format 21 21 1 PixelSamples 1 1 PixelFilter \"box\" " + filter +
                        "\n"
                        "Display \"view.exr\" \"openexr\" \"rgb\"\n"
                        "Projection \"perspective\" \"fov\" 2 Clipping .01 1e9\nWorldBegin\n" +
                        world + "WorldEnd\n");
    const Outcome run =
        runCandela({"--quiet", "--integrator", "classic", "--output-dir", folder.path(), scene});
    EXPECT_EQ(run.status, 0) << run.text();
    std::string problem;
    return readPicture(folder.path("view.exr"), problem).value_or(Picture{});
}

Picture render(const ScratchFolder &folder, const View &view, Way way, const std::string &told) {
    const std::string thing = std::string(view.placing) + "\n" + view.shape + "\n";
    if (way == Way::Instance)
        return renderWorld(
            folder, "ObjectBegin 1\n" + thing + "ObjectEnd\nSurface \"told\"\nObjectInstance 1\n",
            told);
    std::string world = "Surface \"told\"\n" + thing;
    // The camera looks to the side, by way of a mirror of 45 degrees, at the same things.
    if (way == Way::Mirror)
        world = "AttributeBegin\nSurface \"flat_mirror\"\nTranslate 0 0 .5\nRotate 45 0 1 0\n"
                "Patch \"bilinear\" \"P\" [-9 9 0  9 9 0  -9 -9 0  9 -9 0]\nAttributeEnd\n"
                "Translate 0 0 .5\nConcatTransform [0 0 -1 0  0 1 0 0  -1 0 0 0  0 0 0 1]\n"
                "Translate 0 0 -.5\n" +
                world;
    return renderWorld(folder, world, told);
}

/// How far a channel runs over a pixel, by its neighbours.
double runOf(const Picture &picture, const char *channel, int x, int y) {
    const auto at = [&](int column, int row) {
        return double(picture.find(channel)->values[std::size_t(row * 21 + column)]);
    };
    return std::hypot((at(x + 1, y) - at(x - 1, y)) / 2, (at(x, y + 1) - at(x, y - 1)) / 2);
}

TEST(Footprints, AreWhatAPixelShows) {
    for (const View &view : views)
        for (const Way way : {Way::Straight, Way::Mirror, Way::Instance}) {
            ScratchFolder folder;
            const Picture places = render(folder, view, way, "u, v");
            const Picture extents = render(folder, view, way, "du, dv");
            ASSERT_TRUE(places.find("B") && extents.find("B"));
            for (const auto &[x, y] : {std::pair{10, 10}, {7, 12}, {13, 9}}) {
                const auto i = std::size_t(y * 21 + x);
                ASSERT_EQ(places.find("B")->values[i], 1) << view.name << ": nothing is seen";
                const double u = runOf(places, "R", x, y), v = runOf(places, "G", x, y);
                EXPECT_NEAR(extents.find("R")->values[i], u, 0.03 * u)
                    << view.name << " way " << int(way) << " du";
                EXPECT_NEAR(extents.find("G")->values[i], v, 0.03 * v)
                    << view.name << " way " << int(way) << " dv";
            }
        }
}

/// A plane behind the eye, seen in a ball.
const std::string seenInABall =
    "AttributeBegin Surface \"flat_mirror\" Translate 0 0 5 Sphere 1 -1 1 360 AttributeEnd\n"
    "Surface \"told\" Patch \"bilinear\" \"P\" [-9 9 -2  9 9 -2  -9 -9 -2  9 -9 -2]\n";

TEST(Footprints, WidenInCurvedMirrors) {
    ScratchFolder folder;
    const Picture places = renderWorld(folder, seenInABall, "u, v");
    const Picture extents = renderWorld(folder, seenInABall, "du, dv");
    ASSERT_TRUE(places.find("B") && extents.find("B"));
    for (const auto &[x, y] : {std::pair{10, 10}, {6, 13}}) {
        const auto i = std::size_t(y * 21 + x);
        ASSERT_EQ(places.find("B")->values[i], 1) << "nothing is seen";
        EXPECT_NEAR(extents.find("R")->values[i] / runOf(places, "R", x, y), 1, 0.1);
        EXPECT_NEAR(extents.find("G")->values[i] / runOf(places, "G", x, y), 1, 0.1);
    }
}

} // namespace
} // namespace candela::test

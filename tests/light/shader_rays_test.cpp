// SPDX-License-Identifier: Apache-2.0
// Rays that shaders ask for: occlusion(), gather, rayhittest(), transmission(); what they are told
// of rays and primitives: raydepth(), attribute().
#include "tests/light/pictures.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <numeric>

namespace candela::test {
namespace {

const std::string eyeBeyondTheScreen = "Clipping .5 1000\n";
constexpr double height = 3, halfWidth = 3; // Of the screen over the receiver at z = 3.

/// What a square hides of the hemisphere above its centre, weighted by the cosine: the form factor
/// of parallel rectangles at a corner, four times.
double hiddenBySquare() {
    const double x = halfWidth / height, root = std::sqrt(1 + x * x);
    return 4 / std::numbers::pi * (x / root) * std::atan(x / root);
}

double meanOf(const SmallPicture &picture) {
    EXPECT_EQ(picture.red.size(), 64u);
    return std::accumulate(picture.red.begin(), picture.red.end(), 0.0) /
           double(picture.red.size());
}

/// The screen in various company: as it is, in a mirror, as an instance, far larger units.
struct Screen {
    const char *name;
    std::string before, world;
};
const std::string plain = squareAt(0, halfWidth);
const Screen screens[] = {
    {"plain", "", plain},
    {"mirrored", "", "Scale -1 1 1\n" + plain},
    {"one-sided", "", "Sides 1\nReverseOrientation\n" + plain},
    {"turned", "", "ReverseOrientation\n" + plain},
    {"instance", "ObjectBegin 1\n" + plain + "ObjectEnd\n", "Scale 1 -1 1\nObjectInstance 1\n"},
};

std::string worldOf(const Screen &screen, const std::string &opacity, const std::string &surface,
                    const std::string &color = ".25 0 0") {
    return screen.before + "AttributeBegin\nSurface \"matte\"\nColor [" + color + "]\nOpacity [" +
           opacity + "]\n" + screen.world + "AttributeEnd\nSurface " + surface + "\n" +
           squareAt(height);
}

TEST(ShaderRays, OcclusionIsTheFormFactor) {
    for (const std::string &integrator : {inClassic, inPath})
        for (const Screen &screen : screens) {
            const SmallPicture picture = takePicture(integrator + eyeBeyondTheScreen,
                                                     worldOf(screen, "1 1 1", "\"occluded\""), 1);
            EXPECT_NEAR(meanOf(picture), hiddenBySquare(), 3e-3) << screen.name << integrator;
        }
}

TEST(ShaderRays, OcclusionOfWhatIsNotOpaque) {
    const SmallPicture picture = takePicture(inClassic + eyeBeyondTheScreen,
                                             worldOf(screens[0], ".25 .25 .25", "\"occluded\""), 1);
    EXPECT_NEAR(meanOf(picture), hiddenBySquare() / 4, 3e-3);
}

TEST(ShaderRays, OcclusionWithinAConeAndADistance) {
    const std::string options = inClassic + eyeBeyondTheScreen;
    EXPECT_EQ(meanOf(takePicture(
                  options, worldOf(screens[0], "1 1 1", "\"occluded\" \"coneangle\" [.5]"), 1)),
              1);
    EXPECT_EQ(meanOf(takePicture(
                  options, worldOf(screens[0], "1 1 1", "\"occluded\" \"maxdist\" [2.9]"), 1)),
              0);
}

TEST(ShaderRays, GatherCountsAndTells) {
    const std::string options = inClassic + eyeBeyondTheScreen;
    const auto mean = [&](const std::string &what) {
        return meanOf(takePicture(
            options, worldOf(screens[0], "1 1 1", "\"gathered\" \"string what\" \"" + what + "\""),
            1));
    };
    EXPECT_NEAR(mean("hits"), hiddenBySquare(), 5e-3);
    EXPECT_EQ(mean("color"), .25);
    EXPECT_NEAR(mean("distance"), height, 1e-4);
}

/// However many a shader asks for.
TEST(ShaderRays, GatherTakesSoManySamplesAndNoMore) {
    EXPECT_NEAR(meanOf(takePicture(inClassic + eyeBeyondTheScreen,
                                   worldOf(screens[0], "1 1 1", "\"countless\""), 1)),
                hiddenBySquare(), 2e-3);
}

/// What gather calls surface:Ci is followed as trace() is.
TEST(ShaderRays, GatherTellsRadiance) {
    for (const std::string &integrator : {inClassic, inPath}) {
        const SmallPicture picture =
            takePicture(integrator + eyeBeyondTheScreen,
                        "AttributeBegin\nSurface \"constant\"\nColor [.25 0 0]\n" + plain +
                            "AttributeEnd\nSurface \"gathered\" \"samples\" [16] \"string what\" "
                            "\"radiance\"\n" +
                            squareAt(height),
                        4);
        EXPECT_NEAR(meanOf(picture), .25 * hiddenBySquare(), 5e-3) << integrator;
    }
}

/// indirectdiffuse() brings the light of other surfaces under classic, where loops have none, and
/// under path loops bring it: once.
TEST(ShaderRays, IndirectLightComesOnce) {
    for (const std::string &integrator : {inClassic, inPath})
        for (const char *older : {"0", "1"}) {
            const SmallPicture picture =
                takePicture(integrator + eyeBeyondTheScreen,
                            "AttributeBegin\nSurface \"constant\"\nColor [.25 0 0]\n" + plain +
                                "AttributeEnd\nColor [.5 1 1]\nSurface \"bounced\" \"older\" [" +
                                older + "]\n" + squareAt(height),
                            16);
            EXPECT_NEAR(meanOf(picture), .5 * .25 * hiddenBySquare(), 5e-3) << integrator << older;
        }
}

TEST(ShaderRays, TransmissionMultipliesWhatIsLeft) {
    const std::string options = inClassic + eyeBeyondTheScreen;
    for (const char *cone : {"0", ".3"}) {
        const std::string surface = "\"through\" \"samplecone\" [" + std::string(cone) + "]";
        for (const Screen &screen : screens) {
            EXPECT_NEAR(meanOf(takePicture(options, worldOf(screen, ".25 .5 1", surface), 1)), .75,
                        1e-6)
                << screen.name;
        }
        EXPECT_EQ(meanOf(takePicture(options, worldOf(screens[0], "1 1 1", surface), 1)), 0);
    }
}

/// Its light is dimmed by its shader alone, and once.
TEST(ShaderRays, LampsThatAskForTheirShadowsGetNoOthers) {
    for (const std::string &integrator : {inClassic, inPath}) {
        const auto lit = [&](const std::string &opacity) {
            return meanOf(takePicture(
                integrator + eyeBeyondTheScreen,
                "LightSource \"raylamp\" 1 \"intensity\" [30] \"point from\" [0 0 -1]\n" +
                    worldOf(screens[0], opacity, "\"matte\"", "0 0 0"),
                1));
        };
        const double clear = lit("0 0 0");
        EXPECT_GT(clear, .1);
        EXPECT_NEAR(lit(".25 .25 .25") / clear, .75, 1e-5) << integrator;
        EXPECT_EQ(lit("1 1 1"), 0) << integrator;
    }
}

TEST(ShaderRays, AttributesAreThePrimitives) {
    const auto pictureOf = [](const std::string &attributes) {
        return meanOf(takePicture(inClassic,
                                  "Surface \"worn\"\nAttributeBegin\nTranslate 5 0 0\n" +
                                      squareAt(3) + "AttributeEnd\n" + attributes + squareAt(3),
                                  1));
    };
    EXPECT_FLOAT_EQ(pictureOf(""), .125f + 20 + 100);
    EXPECT_FLOAT_EQ(pictureOf("Attribute \"user\" \"float wear\" [.5]\nSides 1\n"
                              "ShadingRate 2\n"),
                    .5f + 10 + 200);
}

TEST(ShaderRays, DepthCountsReflections) {
    const std::string deep = "Surface \"deep\"\n";
    EXPECT_EQ(meanOf(takePicture(inClassic, deep + squareAt(3), 1)), 1);
    EXPECT_EQ(meanOf(takePicture(inClassic + eyeBeyondTheScreen,
                                 deep + squareAt(0, 2) + "Surface \"mirror\"\n" + squareAt(3), 1)),
              2);
}

TEST(ShaderRays, TheSameForAnyLaneWidth) {
    const auto bytes = [](const char *lanes) {
        ScratchFolder folder;
        const std::string rib = folder.write(
            "scene.rib", "Format 12 12 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n"
                         "Clipping .5 100\nProjection \"orthographic\"\nWorldBegin\n"
                         "LightSource \"raylamp\" 1 \"intensity\" [30] \"point from\" [0 0 -1]\n" +
                             worldOf(screens[0], ".5 .5 .5", "\"occluded\" \"samples\" [20]") +
                             "Surface \"gathered\" \"samples\" [9]\nTranslate 0 0 2.5\n"
                             "Sphere .3 -.3 .3 360\nWorldEnd\n");
        const Outcome run =
            runCandela({rib, "--quiet", "--shader-path", CANDELA_SOURCE_DIR "/tests/light/shaders",
                        "--output-dir", folder.path(), "--spp", "2", "--lanes", lanes});
        EXPECT_EQ(run.status, 0) << run.text();
        return folder.read("out.exr");
    };
    const std::string wide = bytes("16");
    EXPECT_FALSE(wide.empty());
    EXPECT_TRUE(bytes("1") == wide);
}

} // namespace
} // namespace candela::test

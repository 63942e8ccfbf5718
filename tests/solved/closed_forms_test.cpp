// SPDX-License-Identifier: Apache-2.0
// Radiosity where the answer is known (VALIDATION A, D), in every final pass and order.
#include "tests/solved/solved.h"
#include "tests/support/frames.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <sstream>

namespace candela::test {
namespace {

const std::string box = "Polygon \"P\" [-1 -1 -1 -1 -1 1 -1 1 1 -1 1 -1]\n"
                        "Polygon \"P\" [1 -1 -1 1 1 -1 1 1 1 1 -1 1]\n"
                        "Polygon \"P\" [-1 -1 -1 1 -1 -1 1 -1 1 -1 -1 1]\n"
                        "Polygon \"P\" [-1 1 -1 -1 1 1 1 1 1 1 1 -1]\n"
                        "Polygon \"P\" [-1 -1 -1 -1 1 -1 1 1 -1 1 -1 -1]\n"
                        "Polygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1]\n";
std::string options(const std::string &pass, const std::string &more = "") {
    return "Option \"render\" \"string integrator\" [\"radiosity\"]\nOption \"radiosity\" \"string "
           "finalpass\" [\"" +
           pass + "\"]\n" + more +
           "Projection \"perspective\" \"fov\" [60]\nRotate 20 1 1 0\nTranslate .2 .1 .1\n";
}

struct Spread {
    double mean = 0, least = 1e30, most = 0;
};

Spread spreadOf(const std::vector<Frame> &frames, int samples) {
    Spread spread;
    const std::vector<FramePixels> pixels = render(frames, {samples, 1, "solved/shaders", false});
    EXPECT_FALSE(pixels.empty());
    for (const FramePixels &frame : pixels)
        for (float value : frame.red) {
            spread.mean += double(value) / double(frame.red.size() * pixels.size());
            spread.least = std::min(spread.least, double(value));
            spread.most = std::max(spread.most, double(value));
        }
    return spread;
}

struct Furnace {
    const char *name;
    std::string world;
    int order = 2;
    double mean = 0.005; ///< By which all pixels together may be off,
    double most = 0.03;  ///< and any pixel of "fe", which has no noise.
};

/// A1 and A3: radiance 1 in all directions, whatever the body and the shader.
TEST(Radiosity, FurnacesAreEven) {
    const std::string glowing = "Surface \"glow\"\n";
    const Furnace furnaces[] = {
        {"box", glowing + box},
        {"box of constant elements", glowing + box, 1, 0.015, 0.1},
        {"box of biquadratic elements", glowing + box, 3},
        {"bright box", "Surface \"glow\" \"Kd\" [.8] \"emission\" [.2]\n" + box, 2, 0.01, 0.06},
        {"mirrored box", "Scale -1 1 1\n" + glowing + box},
        {"sphere", glowing + "Sphere 2 -2 2 360\n", 2, 0.002, 0.002},
        {"ball in a box", glowing + box + "Translate .4 .3 .5\nSphere .3 -.3 .3 360\n"},
        {"glass in a box",
         glowing + box + "Translate .4 .3 .5\nSurface \"glass\"\nSphere .3 -.3 .3 360\n", 2, 0.01,
         0.06},
        // Curved and flat pieces touch, which the rule of curved ones does not see in full.
        {"can", glowing + "Cylinder 1.5 -1 1 360\nDisk 1 1.5 360\nDisk -1 1.5 360\n", 2, 0.02,
         0.06},
        // What a bounce gets wrong, white bodies have tenfold.
        {"white box", "Surface \"glow\" \"Kd\" [.95] \"emission\" [.05]\n" + box, 2, 0.02, 0.1},
        {"white can",
         "Surface \"glow\" \"Kd\" [.9] \"emission\" [.1]\n"
         "Cylinder 2 -2 2 360\nDisk 2 2 360\nDisk -2 2 360\n",
         2, 0.03, 0.1},
        {"white half ball",
         "Surface \"glow\" \"Kd\" [.8] \"emission\" [.2]\n"
         "Sphere 2 -1 2 360\nDisk -1 1.7320508 360\n",
         2, 0.02, 0.1},
        // Emission that depends on direction is sampled.
        {"box by view", "Surface \"view\"\n" + box, 2, 0.01, 0.12},
    };
    for (const Furnace &furnace : furnaces)
        for (const char *pass : finalPasses) {
            SCOPED_TRACE(std::string(furnace.name) + ", " + pass);
            const std::string more =
                "Option \"radiosity\" \"integer order\" [" + std::to_string(furnace.order) + "]\n";
            const int samples = std::string(pass) == "fe" ? 64 : 1024;
            const Spread found =
                spreadOf({{furnace.name, options(pass, more), furnace.world}}, samples);
            EXPECT_NEAR(found.mean, 1, furnace.mean);
            if (std::string(pass) == "fe") {
                EXPECT_GT(found.least, 1 - furnace.most);
                EXPECT_LT(found.most, 1 + furnace.most);
            }
        }
}

/// A9: irradiance() is pi L, and no light is counted twice.
TEST(Radiosity, EquationSevenHasEachLightOnce) {
    for (const char *pass : finalPasses) {
        SCOPED_TRACE(pass);
        const Spread found =
            spreadOf({{"asked", options(pass), "Surface \"asked\" \"emission\" [1]\n" + box}}, 256);
        EXPECT_NEAR(found.mean, 2, 0.01);
    }
}

/// A8: what a ball of exitance pi sends to the black and half grey spheres around it comes back.
TEST(Radiosity, ConcentricSpheres) {
    const std::string world = "Surface \"glow\" \"Kd\" [0] \"emission\" [1]\nSphere 1 -1 1 360\n"
                              "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\nSphere 2 -2 2 360\n";
    for (const char *pass : finalPasses) {
        SCOPED_TRACE(pass);
        const std::string camera =
            "Option \"render\" \"string integrator\" [\"radiosity\"]\nOption \"radiosity\" "
            "\"string "
            "finalpass\" [\"" +
            std::string(pass) +
            "\"]\nProjection \"perspective\" \"fov\" [40]\nTranslate 0 0 -1.2\nRotate 20 1 1 0\n";
        EXPECT_NEAR(spreadOf({{"spheres", camera, world}}, 256).mean, 0.2, 0.002);
    }
}

std::string cube(double reflectance, double epsilon, const std::string &camera = "") {
    std::ostringstream rib;
    rib << "Option \"radiometry\" \"string units\" [\"si\"]\n"
           "Option \"render\" \"string integrator\" [\"radiosity\"]\n"
           "Option \"radiosity\" \"float epsilon\" ["
        << epsilon
        << "]\nFormat 4 4 1\nPixelSamples 1 1\nDisplay \"cube.exr\" \"openexr\" \"rgb\"\n"
           "Projection \"perspective\"\n"
        << camera
        << "WorldBegin\n"
           "LightSource \"pointlight\" 1 \"float intensity\" [100] \"point from\" [.1 .2 0]\n"
           "Surface \"matte\" \"Ka\" [0] \"Kd\" ["
        << reflectance << "]\n"
        << box << "WorldEnd\n";
    return rib.str();
}

/// Its two sides are as near to each other as can be, and rounding turns them to and from each
/// other.
TEST(Radiosity, TheSidesOfAPlaneSeeNothingOfEachOther) {
    const double straight = statistic(cube(0.5, 1e-5), "elements");
    for (const char *camera :
         {"Translate .3 .1 1.3\nRotate 5 0 1 0\n", "Rotate 31 1 2 3\n",
          "Scale -1 1 1\nRotate 7 1 0 0\n", "Translate 100 30 7\nRotate 20 0 0 1\n",
          "Rotate 3 1 1 0\nScale .001 .001 .001\n"})
        EXPECT_NEAR(statistic(cube(0.5, 1e-5, camera), "elements") / straight, 1, 0.1) << camera;
}

/// A4 and D4: in a closed room of one reflectance the flux of all reflections is a geometric
/// series, whatever the room and wherever the light.
TEST(Radiosity, FluxIsInBalance) {
    const double flux = 100 * 4 * M_PI;
    for (double reflectance : {0.1, 0.5, 0.8}) {
        SCOPED_TRACE(reflectance);
        const std::string rib = cube(reflectance, 1e-5);
        EXPECT_NEAR(statistic(rib, "directFlux") / flux, 1, 0.002);
        EXPECT_NEAR(statistic(rib, "indirectFlux") / (flux * reflectance / (1 - reflectance)), 1,
                    0.005);
    }
}

/// A stripe of a thousandth of a wall's width is all the light that there is, and no lamp to RIB:
/// the flux of a closed room tells whether all of it has been found.
TEST(Radiosity, NarrowStripesAreNeverMissed) {
    const std::string walls = box.substr(0, box.find("Polygon", box.size() / 6 * 5));
    struct Place {
        const char *name, *camera, *before, *after;
    };
    const Place places[] = {
        {"alone", "", "", ""},
        {"mirrored", "Scale -1 1 1\nRotate 20 1 1 0\n", "", ""},
        {"huge", "Scale 1000 1000 1000\n", "", ""},
        {"tiny", "Scale .001 .001 .001\n", "", ""},
        {"an instance", "", "ObjectBegin 1\n", "ObjectEnd\nObjectInstance 1\n"}};
    for (const Place &place : places)
        for (const double at : {0.317, 0.5, 0.0123})
            for (const char *st : {"0 0 1 0 1 1 0 1", "0 0 0 1 1 1 1 0"}) {
                const bool isAlone = place.before + std::string(place.camera) == "";
                if (!isAlone && (at != 0.317 || st[2] != '0'))
                    continue;
                SCOPED_TRACE(std::string(place.name) + " " + std::to_string(at) + " " + st);
                std::ostringstream wall;
                wall << "Surface \"stripe\" \"at\" [" << at
                     << "]\nPolygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1] \"st\" [" << st << "]\n";
                const std::string rib = solvedScene("fe", place.camera) + "WorldBegin\n" +
                                        "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n" + walls +
                                        place.before + wall.str() + place.after + "WorldEnd\n";
                const double metres = rib.find("1000 1000 1000") != std::string::npos   ? 1e3
                                      : rib.find(".001 .001 .001") != std::string::npos ? 1e-3
                                                                                        : 1;
                const double flux = M_PI * 100 * 0.001 * 4 * metres * metres;
                EXPECT_NEAR(statistic(rib, "directFlux") / flux, 1, 0.03);
                EXPECT_NEAR(statistic(rib, "indirectFlux") / flux, 1, 0.03);
            }
}

/// Pictures of coarse solutions come nearer to that of a fine one.
TEST(Radiosity, ConvergesWithEpsilon) {
    const std::string world =
        "LightSource \"pointlight\" 1 \"float intensity\" [3] \"point from\" [.1 .2 0]\n"
        "Surface \"matte\" \"Ka\" [0] \"Kd\" [.7]\n" +
        box + "Translate .4 .3 .5\nSphere .3 -.3 .3 360\n";
    std::vector<Frame> frames;
    for (const char *epsilon : {"4e-3", "1e-3", "2.5e-4", "6.25e-5", "2e-6"})
        frames.push_back({epsilon,
                          options("fe", std::string("Option \"radiosity\" \"float epsilon\" [") +
                                            epsilon + "]\nFormat 32 32 1\n"),
                          world});
    const std::vector<FramePixels> pictures = render(frames, {16, 1, "solved/shaders", false});
    ASSERT_EQ(pictures.size(), frames.size());
    const std::vector<float> &fine = pictures.back().red;
    double before = 1, mean = 0;
    for (float value : fine)
        mean += double(value) / double(fine.size());
    for (std::size_t k = 0; k + 1 < frames.size(); ++k) {
        double squares = 0;
        for (std::size_t i = 0; i < fine.size(); ++i)
            squares += std::pow(pictures[k].red[i] - fine[i], 2) / double(fine.size());
        const double error = std::sqrt(squares) / mean;
        EXPECT_LT(error, before) << "epsilon " << frames[k].name;
        std::printf("    epsilon %-8s %.4f\n", frames[k].name.c_str(), error);
        before = error;
    }
    EXPECT_LT(before, 0.015);
}

/// A picture depends on the scene alone: not on threads, nor on lanes.
TEST(Radiosity, GivesTheSameBytes) {
    const ScratchFolder folder;
    for (const char *pass : finalPasses) {
        folder.write("scene.rib",
                     "Option \"radiometry\" \"string units\" [\"si\"]\n" + options(pass) +
                         "Format 16 16 1\nPixelSamples 4 1\nDisplay \"same.exr\" \"openexr\" "
                         "\"rgb\"\nWorldBegin\n"
                         "LightSource \"pointlight\" 1 \"float intensity\" [1]\n"
                         "Surface \"matte\" \"Ka\" [0] \"Kd\" [.6]\n" +
                         box + "Translate .4 .3 .5\nSphere .3 -.3 .3 360\nWorldEnd\n");
        const auto bytes = [&](std::vector<std::string> more) {
            more.insert(more.begin(),
                        {folder.path("scene.rib"), "--output-dir", folder.path(""), "--quiet"});
            const Outcome outcome = runCandela(more);
            EXPECT_EQ(outcome.status, 0) << outcome.text();
            return folder.read("same.exr");
        };
        const std::string one = bytes({"--threads", "1"});
        EXPECT_FALSE(one.empty());
        EXPECT_EQ(one, bytes({"--threads", "3"})) << pass;
        EXPECT_EQ(one, bytes({"--threads", "2", "--lanes", "1"})) << pass;
    }
}

/// Impossible shaders are named, and the rest goes on.
TEST(Radiosity, ImpossibleShadersAreNamed) {
    const ScratchFolder folder;
    folder.write(
        "scene.rib",
        std::string() +
            "Option \"radiometry\" \"string units\" [\"si\"]\n"
            "Option \"render\" \"string integrator\" [\"radiosity\"]\n"
            "Format 8 8 1\nPixelSamples 1 1\nDisplay \"much.exr\" \"openexr\" \"rgb\"\n"
            "Projection \"perspective\"\nWorldBegin\n"
            "LightSource \"pointlight\" 1 \"float intensity\" [1] \"point from\" [.1 .2 0]\n"
            "Surface \"much\"\n" +
            box + "Patch \"bilinear\" \"P\" [0 0 0 0 0 0 0 0 0 0 0 0]\nWorldEnd\n");
    const Outcome outcome =
        runCandela({folder.path("scene.rib"), "--output-dir", folder.path(""), "--quiet",
                    "--shader-path", std::string(CANDELA_SOURCE_DIR) + "/tests/solved/shaders"});
    EXPECT_EQ(outcome.signal, 0) << outcome.text();
    EXPECT_TRUE(outcome.says("shader \"much\" sends on more light than it gets")) << outcome.text();
}

TEST(Radiosity, WrongOptionsAreNamed) {
    const ScratchFolder folder;
    folder.write("scene.rib",
                 std::string() +
                     "Option \"radiosity\" \"string finalpass\" [\"best\"]\n"
                     "Option \"radiosity\" \"float epsilon\" [-1]\n"
                     "Option \"radiosity\" \"integer order\" [7]\nWorldBegin\nWorldEnd\n");
    const Outcome outcome = runCandela({folder.path("scene.rib"), "--output-dir", folder.path("")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("\"fe\", \"fe+direct\", \"gather\", and not \"best\""))
        << outcome.text();
    EXPECT_TRUE(outcome.says("\"radiosity\" \"epsilon\" is")) << outcome.text();
    EXPECT_TRUE(outcome.says("\"radiosity\" \"order\" is")) << outcome.text();
}

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// Radiosity where the answer is known (VALIDATION A, D), in every final pass and order.
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
const char *const passes[] = {"fe", "fe+direct", "gather"};

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
    const std::vector<FramePixels> pixels =
        render(frames, {samples, 1, "solved/shaders", false});
    EXPECT_FALSE(pixels.empty());
    for (const FramePixels &frame : pixels)
        for (float value : frame.red) {
            spread.mean += double(value) / double(frame.red.size() * pixels.size());
            spread.least = std::min(spread.least, double(value));
            spread.most = std::max(spread.most, double(value));
        }
    return spread;
}

/// A1 and A3: radiance 1 in all directions, whatever the body and the shader.
TEST(Radiosity, FurnacesAreEven) {
    const std::pair<const char *, std::string> worlds[] = {
        {"box", "Surface \"glow\"\n" + box},
        {"bright box", "Surface \"glow\" \"Kd\" [.8] \"emission\" [.2]\n" + box},
        {"sphere", "Surface \"glow\"\nSphere 2 -2 2 360\n"},
        {"mirrored box", "Scale -1 1 1\nSurface \"glow\"\n" + box},
        {"cylinder", "Surface \"glow\"\nCylinder 1.5 -1 1 360\nDisk 1 1.5 360\nDisk -1 1.5 360\n"},
        {"body within", "Surface \"glow\"\n" + box + "Translate .4 .3 .5\nSphere .3 -.3 .3 360\n"},
        {"by view", "Surface \"view\"\n" + box},
    };
    for (const auto &[name, world] : worlds)
        for (const char *pass : passes)
            for (int order : {1, 2, 3}) {
                if (order != 2 && std::string(name) != "box")
                    continue;
                SCOPED_TRACE(std::string(name) + ", " + pass + ", order " + std::to_string(order));
                const std::string more =
                    "Option \"radiosity\" \"integer order\" [" + std::to_string(order) + "]\n";
                const Spread found = spreadOf({{name, options(pass, more), world}}, 64);
                EXPECT_NEAR(found.mean, 1, order == 1 ? 0.015 : 0.005);
                if (std::string(pass) == "fe") {
                    EXPECT_GT(found.least, order == 1 ? 0.9 : 0.97);
                    EXPECT_LT(found.most, order == 1 ? 1.1 : 1.03);
                }
            }
}

/// A9: irradiance() is pi L, and no light is counted twice.
TEST(Radiosity, EquationSevenHasEachLightOnce) {
    for (const char *pass : passes) {
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
    for (const char *pass : passes) {
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

/// Numbers of --stats.
double statistic(const std::string &rib, const std::string &name) {
    const ScratchFolder folder;
    folder.write("scene.rib", rib);
    const Outcome outcome = runCandela({folder.path("scene.rib"), "--output-dir", folder.path(""),
                                        "--quiet", "--stats", folder.path("stats.json")});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    const std::string text = folder.read("stats.json");
    const std::size_t at = text.find("\"radiosity." + name + "\"");
    EXPECT_NE(at, std::string::npos) << text;
    return at == std::string::npos ? 0 : std::stod(text.substr(text.find(':', at) + 1));
}

std::string cube(double reflectance, double epsilon) {
    std::ostringstream rib;
    rib << "Option \"radiometry\" \"string units\" [\"si\"]\n"
           "Option \"render\" \"string integrator\" [\"radiosity\"]\n"
           "Option \"radiosity\" \"float epsilon\" ["
        << epsilon
        << "]\nFormat 4 4 1\nPixelSamples 1 1\nDisplay \"cube.exr\" \"openexr\" \"rgb\"\n"
           "Projection \"perspective\"\nWorldBegin\n"
           "LightSource \"pointlight\" 1 \"float intensity\" [100] \"point from\" [.1 .2 0]\n"
           "Surface \"matte\" \"Ka\" [0] \"Kd\" ["
        << reflectance << "]\n"
        << box << "WorldEnd\n";
    return rib.str();
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

TEST(Radiosity, ConvergesWithEpsilon) {
    const double flux = 100 * 4 * M_PI;
    double before = 1;
    for (double epsilon : {4e-3, 1e-3, 2.5e-4, 6.25e-5}) {
        const double error = std::fabs(statistic(cube(0.5, epsilon), "indirectFlux") / flux - 1);
        EXPECT_LT(error, std::max(before, 2e-3)) << epsilon;
        before = error;
    }
    EXPECT_LT(before, 2e-3);
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
    EXPECT_TRUE(outcome.says("there is no final pass \"best\"")) << outcome.text();
    EXPECT_TRUE(outcome.says("\"radiosity\" \"epsilon\" is")) << outcome.text();
    EXPECT_TRUE(outcome.says("\"radiosity\" \"order\" is")) << outcome.text();
}

} // namespace
} // namespace candela::test

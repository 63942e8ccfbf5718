// SPDX-License-Identifier: Apache-2.0
// What surfaces exchange, in scenes whose answer is known (VALIDATION A7, B1 to B4, D1, D2), by
// every final pass and in company.
#include "tests/probing/probing.h"
#include "tests/solved/ply.h"
#include "tests/solved/solved.h"
#include "tests/support/scratch_folder.h"

#include <array>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;
const std::string shaders = std::string(CANDELA_SOURCE_DIR) + "/tests/solved/shaders:&";

/// Spaces that change no share.
struct Company {
    const char *name;
    const char *camera; ///< Before WorldBegin.
    double scale = 1;   ///< Metres a unit of the world.
    bool isInstance = false;
};
const Company alone{"alone", ""};
const Company companies[] = {
    alone,
    {"mirrored", "Scale -1 1 1\nRotate 31 1 2 3\n"},
    {"tiny", "Rotate 5 0 1 0\nScale .001 .001 .001\n", 1e-3},
    {"huge", "Scale 1000 1000 1000\n", 1e3},
    {"far away", "Translate 100 30 70\n"},
    {"an instance", "", 1, true},
};

struct Exchange {
    const char *name, *sender, *receiver;
    double area;   ///< Of the sender.
    double factor; ///< The share of what it sends on that side.
};
const Exchange exchanges[] = {
    {"B1: opposite faces of a cube", "Patch \"bilinear\" \"P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n",
     "Patch \"bilinear\" \"P\" [0 0 1 1 0 1 0 1 1 1 1 1]\n", 1, 0.199824895698387},
    {"B1: opposite polygons", "Polygon \"P\" [0 0 0 1 0 0 1 1 0 0 1 0]\n",
     "Polygon \"P\" [0 0 1 1 0 1 1 1 1 0 1 1]\n", 1, 0.199824895698387},
    {"B1: faces that touch", "Patch \"bilinear\" \"P\" [0 0 0 1 0 0 0 1 0 1 1 0]\n",
     "Patch \"bilinear\" \"P\" [0 0 0 0 1 0 0 0 1 0 1 1]\n", 1, 0.200043776075403},
    {"B1: polygons that touch", "Polygon \"P\" [0 0 0 1 0 0 1 1 0 0 1 0]\n",
     "Polygon \"P\" [0 0 0 0 1 0 0 1 1 0 0 1]\n", 1, 0.200043776075403},
    {"B2: 2 x 1 at distance 1", "Polygon \"P\" [0 0 0 2 0 0 2 1 0 0 1 0]\n",
     "Polygon \"P\" [0 0 1 2 0 1 2 1 1 0 1 1]\n", 2, 0.285875384850715},
    {"B3: equal discs", "Disk 0 1 360\n", "Disk 1 1 360\n", pi, 0.381966011250105},
    {"B3: to a larger disc", "Disk 0 1 360\n", "Disk 1 2 360\n", pi, 0.763932022500210},
    {"B3: farther discs", "Disk 0 1 360\n", "Disk 2 1 360\n", pi, 0.171572875253810},
};

std::string sceneOf(const Exchange &exchange, const Company &company, double epsilon) {
    const std::string receiver =
        "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n" + std::string(exchange.receiver);
    return solvedScene("fe", fmt::format("Option \"radiosity\" \"float epsilon\" [{}]\n", epsilon) +
                                 company.camera) +
           "WorldBegin\nAttributeBegin\nAreaLightSource \"arealight\" 1 \"radiance\" [1]\n"
           "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n" +
           exchange.sender + "AttributeEnd\nIlluminate 1 1\n" +
           (company.isInstance ? "ObjectBegin 1\n" + receiver + "ObjectEnd\nObjectInstance 1\n"
                               : receiver) +
           "WorldEnd\n";
}

double shareOf(const Exchange &exchange, const Company &company, double epsilon) {
    return statistic(sceneOf(exchange, company, epsilon), "directFlux") /
           (pi * exchange.area * company.scale * company.scale);
}

TEST(Radiosity, SurfacesGetTheirShares) {
    for (const Exchange &exchange : exchanges) {
        EXPECT_NEAR(shareOf(exchange, alone, 1e-5) / exchange.factor, 1, 0.01) << exchange.name;
        EXPECT_NEAR(shareOf(exchange, alone, 1e-6) / exchange.factor, 1, 0.002)
            << exchange.name << ", tight";
    }
}

TEST(Radiosity, SurfacesGetTheirSharesInCompany) {
    for (const Company &company : companies)
        for (const std::size_t k : {3u, 6u})
            EXPECT_NEAR(shareOf(exchanges[k], company, 1e-5) / exchanges[k].factor, 1, 0.01)
                << exchanges[k].name << ", " << company.name;
}

/// The share of the hemisphere over a point in the plane y = 0 of a wall that looks along y, which
/// a floor in z = 0 fills between two distances, `wide` metres to either side (Lambert).
double floorBeforeWall(double height, double from, double to, double wide) {
    const auto upTo = [&](double depth) {
        // Of half of the strip from the wall on: the floor's edge at that depth.
        const double s = std::hypot(height, depth);
        return (std::atan(wide / height) - height / s * std::atan(wide / s)) / pi;
    };
    return upTo(to) - upTo(from);
}

/// And over a point of a ceiling, at that distance from the floor's edge.
double floorBelowCeiling(double height, double distance, double depth, double wide) {
    const auto corner = [&](double x, double y) {
        const double a = std::hypot(x, height), b = std::hypot(y, height);
        return (x / a * std::atan(y / a) + y / b * std::atan(x / b)) / (2 * pi);
    };
    return 2 * (corner(wide, depth - distance) + corner(wide, distance));
}

/// A square floor that sends exitance 1 from itself, or reflects that much of a sun overhead.
std::string shiningFloor(double side, bool isLit) {
    const std::string floor = fmt::format("Polygon \"P\" [{0} 0 0 {1} 0 0 {1} {2} 0 {0} {2} 0]\n",
                                          -side / 2, side / 2, side);
    const std::string own =
        isLit ? "LightSource \"distantlight\" 7 \"intensity\" [1] \"from\" [0 0 1] \"to\" [0 0 0]\n"
                "AttributeBegin\nSurface \"matte\" \"Ka\" [0] \"Kd\" [1]\n"
              : fmt::format("AttributeBegin\nSurface \"constant\"\nColor [{0} {0} {0}]\n", 1 / pi);
    return own + floor + "AttributeEnd\n";
}

const std::string blackWall = "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n"
                              "Polygon \"P\" [-5 0 0 5 0 0 5 0 4 -5 0 4]\n";
const std::string blackCeiling = "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n"
                                 "Polygon \"P\" [-5 0 3 5 0 3 5 8 3 -5 8 3]\n";

struct Place {
    std::string point;
    double expected;
};

/// By the root of the sum of squares over places (ALGORITHMS 6), noise besides.
void expectIrradiance(const std::string &world, const std::vector<Place> &places, double tolerance,
                      const std::string &more = "") {
    std::string points;
    double expected = 0;
    for (const Place &place : places) {
        points += place.point + "\n";
        expected += place.expected * place.expected;
    }
    for (const char *pass : finalPasses) {
        const Probed probed =
            probe(solvedScene(pass, more) + "WorldBegin\n" + world + "WorldEnd\n", points,
                  {"--integrator", "radiosity", "--spp", "16384", "--shader-path", shaders});
        ASSERT_EQ(probed.answers.size(), places.size()) << probed.run.text();
        double missed = 0, noise = 0;
        std::string told;
        for (std::size_t k = 0; k < places.size(); ++k) {
            const Answer &answer = probed.answers[k];
            missed += std::pow(answer.total - places[k].expected, 2);
            noise += std::pow(answer.halfWidth / answer.photometric * answer.total, 2);
            told +=
                fmt::format("{}: {} for {}\n", places[k].point, answer.total, places[k].expected);
        }
        EXPECT_LE(std::sqrt(missed / expected), tolerance + std::sqrt(noise / expected))
            << pass << "\n"
            << told;
    }
}

/// The table of VALIDATION D1, and its formulas.
TEST(Radiosity, AFloorLightsWallAndCeiling) {
    EXPECT_NEAR(floorBeforeWall(0.5, 0, 4, 2), 0.403838, 1e-6);
    EXPECT_NEAR(floorBelowCeiling(3, 0.5, 4, 2), 0.289754, 1e-6);
    for (const double side : {0.5, 4.0, 500.0})
        for (const bool isLit : {false, true}) {
            SCOPED_TRACE(fmt::format("{} m, {}", side, isLit ? "lit" : "shining"));
            std::vector<Place> wall, ceiling;
            for (const double at : {0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 3.5}) {
                wall.push_back(
                    {fmt::format("0 0 {} 0 1 0", at), floorBeforeWall(at, 0, side, side / 2)});
                ceiling.push_back(
                    {fmt::format("0 {} 3 0 0 -1", at), floorBelowCeiling(3, at, side, side / 2)});
            }
            expectIrradiance(shiningFloor(side, isLit) + blackWall, wall, 0.01);
            if (!isLit) // The ceiling would take the sun.
                expectIrradiance(shiningFloor(side, isLit) + blackCeiling, ceiling, 0.01);
        }
}

/// D2: a screen on the floor hides what lies behind it, up to where the sight over its edge goes.
TEST(Radiosity, AScreenHidesAPartOfTheFloor) {
    constexpr double distance = 1, high = 1, side = 4;
    const std::string screen = "Polygon \"P\" [-9 1 0 9 1 0 9 1 1 -9 1 1]\n";
    for (const bool isLit : {false, true}) {
        std::vector<Place> places;
        for (const double z : {0.5, 1.0, 1.2, 1.5, 2.0, 3.0}) {
            const double beyond = z > high ? distance * z / (z - high) : side;
            places.push_back(
                {fmt::format("0 0 {} 0 1 0", z),
                 floorBeforeWall(z, 0, distance, side / 2) +
                     (beyond < side ? floorBeforeWall(z, beyond, side, side / 2) : 0)});
        }
        expectIrradiance(shiningFloor(side, isLit) + blackWall + screen, places, 0.01);
    }
}

/// A7: plates that are a thousand times as wide as they are apart.
TEST(Radiosity, ParallelPlatesThrowLightToAndFro) {
    const std::string plates =
        "Surface \"glow\" \"Kd\" [.5] \"emission\" [.318309886]\n"
        "Patch \"bilinear\" \"P\" [-500 -500 0 500 -500 0 -500 500 0 500 500 0]\n"
        "Surface \"matte\" \"Ka\" [0] \"Kd\" [.8]\n"
        "Patch \"bilinear\" \"P\" [-500 -500 1 500 -500 1 -500 500 1 500 500 1]\n";
    for (const char *camera : {"", "Scale -1 1 1\nRotate 20 1 1 0\n", "Scale .001 .001 .001\n"})
        expectIrradiance(plates, {{"3 2 1 0 0 -1", 1 / 0.6}, {"3 2 0 0 0 1", 0.8 / 0.6}}, 0.01,
                         camera);
}

/// B4: a cube of one element a face, of which one shines: the linear system alone. Radiance over
/// pi is the exitance of the book's tables.
TEST(Radiosity, ACubeOfOneElementAFace) {
    struct Row {
        double reflectance, ofEmitter, emitter, opposite, side;
    };
    const Row rows[] = {{0.5, 0.5, 1.0909091, 0.1817458, 0.1818363},
                        {0.8, 0.8, 1.5517242, 0.6895511, 0.6896812},
                        {0.5, 0, 1, 0.1666003, 0.1666833},
                        {0.8, 0, 1, 0.4443774, 0.4444612}};
    const char *const faces[] = {"0 0 0 1 0 0 0 1 0 1 1 0", "0 0 1 1 0 1 0 1 1 1 1 1",
                                 "0 0 0 1 0 0 0 0 1 1 0 1", "0 1 0 1 1 0 0 1 1 1 1 1",
                                 "0 0 0 0 1 0 0 0 1 0 1 1", "1 0 0 1 1 0 1 0 1 1 1 1"};
    for (const Row &row : rows)
        for (const char *camera : {"", "Scale -1 1 1\nRotate 20 1 1 0\n"}) {
            std::string world = "WorldBegin\n";
            for (std::size_t k = 0; k < std::size(faces); ++k)
                world += (k == 0 ? fmt::format("Surface \"glow\" \"Kd\" [{}] \"emission\" [1]\n",
                                               row.ofEmitter)
                                 : fmt::format("Surface \"matte\" \"Ka\" [0] \"Kd\" [{}]\n",
                                               row.reflectance)) +
                         "Patch \"bilinear\" \"P\" [" + faces[k] + "]\n";
            const ScratchFolder folder;
            const Outcome run = runCandela(
                {folder.write("cube.rib",
                              solvedScene("fe", "Option \"radiosity\" \"integer order\" [1] "
                                                "\"leastelement\" [1]\n" +
                                                    std::string(camera)) +
                                  world + "WorldEnd\n"),
                 "--output-dir", folder.path(""), "--quiet", "--shader-path", shaders,
                 "--solution-mesh", folder.path("cube.ply")});
            ASSERT_EQ(run.status, 0) << run.text();
            const Ply ply = readPly(folder.read("cube.ply"));
            std::size_t inside = 0;
            for (const std::vector<int> &face : ply.faces) {
                const std::array<float, 9> &v = ply.vertices[std::size_t(face[0])];
                const auto [x, y, z] = std::array{v[0] - 0.5f, v[1] - 0.5f, v[2] - 0.5f};
                if (x * v[3] + y * v[4] + z * v[5] > 0)
                    continue; // It looks outwards.
                ++inside;
                const double expected = v[5] > 0.5f    ? row.emitter
                                        : v[5] < -0.5f ? row.opposite
                                                       : row.side;
                EXPECT_NEAR(v[6], expected, 1e-4 * expected)
                    << row.reflectance << " " << row.ofEmitter << " " << v[5] << camera;
            }
            EXPECT_EQ(inside, std::size(faces));
        }
}

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
// `candela probe --integrator radiosity`: sensors on surfaces are told by the solution, others
// gather it; and what stands on a surface parts its light.
#include "tests/probing/probing.h"

#include "tests/support/scratch_folder.h"

#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

namespace {

std::string solvedBy(const std::string &finalPass) {
    return "Option \"radiosity\" \"string finalpass\" \"" + finalPass + "\"\n";
}

Probed solve(const std::string &scene, const std::string &points,
             std::vector<std::string> options = {}) {
    options.insert(options.end(), {"--integrator", "radiosity"});
    return probe(scene, points, options);
}

std::string quad(const std::string &corners) { return "Polygon \"P\" [" + corners + "]\n"; }

/// A box from (x0, 0, 0) to (x1, 2, 2) without floor, seen from within.
std::string roomOverFloor(double x0, double x1) {
    return quad(fmt::format("{0} 2 0 {1} 2 0 {1} 2 2 {0} 2 2", x0, x1)) +
           quad(fmt::format("{0} 0 0 {0} 2 0 {0} 2 2 {0} 0 2", x0)) +
           quad(fmt::format("{0} 0 0 {0} 2 0 {0} 2 2 {0} 0 2", x1)) +
           quad(fmt::format("{0} 0 0 {1} 0 0 {1} 2 0 {0} 2 0", x0, x1)) +
           quad(fmt::format("{0} 0 2 {1} 0 2 {1} 2 2 {0} 2 2", x0, x1));
}

} // namespace

/// A closed box that shines and scatters half: E = pi / (1 - 1/2) everywhere, on surfaces and in
/// the middle.
TEST(SolvedProbe, AFurnaceIsTheSameEverywhere) {
    const std::string world =
        "AreaLightSource \"arealight\" 1 \"radiance\" [1] \"onesided\" [0]\nIlluminate 1 1\n"
        "Surface \"matte\" \"Ka\" [0] \"Kd\" [1]\nColor [.5 .5 .5]\n" +
        roomOverFloor(0, 3) + quad("0 0 0 3 0 0 3 0 2 0 0 2");
    const std::string points = "1 0 1 0 1 0\n.01 1 1 1 0 0\n1.5 1 1 0 0 1\n2 2 1.99 0 -1 0\n"
                               "1 0 1 1 1 0\n";
    for (const char *pass : {"fe", "fe+direct", "gather"}) {
        const Probed probed = solve(siWorld(world, solvedBy(pass)), points, {"--spp", "4096"});
        ASSERT_EQ(probed.answers.size(), 5u) << probed.run.text();
        for (std::size_t k = 0; k < 5; ++k)
            EXPECT_NEAR(probed.answers[k].total, 2 * std::numbers::pi, .02 * 2 * std::numbers::pi)
                << pass << " " << k;
    }
}

/// What the solution tells takes no samples; light sources of "fe+direct", sensors that stand free
/// and those that are tilted against their surface do.
TEST(SolvedProbe, SamplesOnlyWhatItHasTo) {
    const std::string world = "LightSource \"pointlight\" 1 \"from\" [1 1 1] \"intensity\" [10]\n"
                              "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n" +
                              roomOverFloor(0, 2) + quad("0 0 0 2 0 0 2 0 2 0 0 2");
    const std::string points = "1 0 .5 0 1 0\n1 .5 .5 0 1 0\n1 0 .5 0 1 .5\n";
    const Probed fe = solve(siWorld(world, solvedBy("fe")), points, {"--spp", "256"});
    const Probed direct = solve(siWorld(world, solvedBy("fe+direct")), points, {"--spp", "256"});
    const Probed gather = solve(siWorld(world, solvedBy("gather")), points, {"--spp", "4096"});
    ASSERT_EQ(fe.answers.size(), 3u) << fe.run.text();
    ASSERT_EQ(direct.answers.size(), 3u) << direct.run.text();
    EXPECT_EQ(fe.answers[0].samples, 0);
    EXPECT_EQ(fe.answers[0].halfWidth, 0);
    EXPECT_EQ(fe.answers[1].samples, 256);
    EXPECT_EQ(fe.answers[2].samples, 256);
    EXPECT_EQ(direct.answers[0].samples, 256);
    for (const Probed *other : {&fe, &direct})
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(other->answers[k].total, gather.answers[k].total,
                        .02 * gather.answers[k].total)
                << k;
}

TEST(SolvedProbe, AmbientLightsCount) {
    const std::string world = "LightSource \"ambientlight\" 1 \"intensity\" [1]\n"
                              "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n" +
                              quad("0 0 0 2 0 0 2 0 2 0 0 2");
    for (const char *pass : {"fe", "fe+direct", "gather"}) {
        const Probed probed = solve(siWorld(world, solvedBy(pass)), "1 0 .5 0 1 0\n");
        ASSERT_EQ(probed.answers.size(), 1u) << probed.run.text();
        EXPECT_NEAR(probed.answers[0].total, std::numbers::pi, 1e-4) << pass;
    }
}

TEST(SolvedProbe, AnswersAlikeForAnyThreadsAndFromAKeptSolution) {
    const std::string world = siWorld(lamp("Translate 1 1.9 1\nRotate 90 1 0 0\nDisk 0 .3 360\n") +
                                          "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n" +
                                          roomOverFloor(0, 2) + quad("0 0 0 2 0 0 2 0 2 0 0 2"),
                                      solvedBy("fe+direct"));
    const std::string points = "1 0 .5 0 1 0\n.1 0 .5 0 1 0\n1 1 1 0 0 1\n";
    ScratchFolder folder;
    const std::string file = folder.path("kept");
    const std::string one = solve(world, points, {"--threads", "1"}).run.out;
    EXPECT_EQ(one, solve(world, points, {"--threads", "2"}).run.out);
    EXPECT_EQ(one, solve(world, points, {"--solution", file}).run.out);
    EXPECT_EQ(one, solve(world, points, {"--solution", file}).run.out);
}

namespace {

/// What a floor of 2 x 2 m in the sun throws up to a sensor that is half as high.
double lightFrom(const std::string &surface, const std::string &place, double scale,
                 const std::string &finalPass, bool isInstance) {
    static const ScratchFolder folder;
    folder.write("checks.sl", "surface checks(float n = 50;) {\n"
                              "normal Nf = faceforward(normalize(N), I);\n"
                              "float a = mod(floor(s * n) + floor(t * n), 2);\n"
                              "Oi = 1; Ci = a * diffuse(Nf); }\n");
    const std::string floor =
        "Polygon \"P\" [-1 0 -1  1 0 -1  1 0 1  -1 0 1] \"st\" [0 0 1 0 1 1 0 1]\n";
    const std::string world =
        "LightSource \"distantlight\" 1 \"intensity\" [1] \"from\" [0 1 0] \"to\" [0 0 0]\n" +
        place + surface +
        (isInstance ? "ObjectBegin 1\n" + floor + "ObjectEnd\nObjectInstance 1\n" : floor);
    const Probed probed =
        solve(siWorld(world, solvedBy(finalPass)), fmt::format("0 {} 0 0 -1 0\n", scale),
              {"--spp", "16384", "--shader-path", folder.path() + ":&"});
    EXPECT_EQ(probed.answers.size(), 1u) << probed.run.text();
    return probed.answers.empty() ? -1 : probed.answers.front().total;
}

} // namespace

/// Checks by the power of two fall on the elements' nodes all alike.
TEST(SolvedProbe, TexturesFinerThanElementsCountByTheirMean) {
    const std::string grey = "Surface \"matte\" \"Ka\" [0] \"Kd\" [.5]\n";
    const double expected = lightFrom(grey, "", 1, "gather", false);
    for (const int checks : {16, 50, 64, 128, 256, 1024, 4096}) {
        const std::string surface = fmt::format("Surface \"checks\" \"n\" [{}]\n", checks);
        for (const char *pass : {"fe", "gather"})
            EXPECT_NEAR(lightFrom(surface, "", 1, pass, false), expected, .02 * expected)
                << checks << " " << pass;
        EXPECT_NEAR(lightFrom(surface, "Scale 1 1 -1\n", 1, "fe", true), expected, .02 * expected)
            << checks << " in a mirrored instance";
        EXPECT_NEAR(lightFrom(surface, "Scale 1000 1000 1000\n", 1000, "fe", false), expected,
                    .02 * expected)
            << checks << " huge";
    }
}

namespace {

/// Two rooms over one floor, one of them dark, parted by a wall that stands across its elements.
struct Company {
    std::string name;
    std::string camera; ///< Before WorldBegin.
    std::string place;  ///< Before the rooms.
    double scale = 1;   ///< Of points.
    double turned = 1;  ///< -1: mirrored in y.
    bool isInstance = false;
};

void PrintTo(const Company &company, std::ostream *out) { *out << company.name; }

class OverOneFloor : public testing::TestWithParam<Company> {};

constexpr double wall = 1.2345;

std::string twoRooms(const Company &company) {
    const std::string lamp = "AttributeBegin\nAreaLightSource \"arealight\" 1 \"radiance\" [10]\n"
                             "Surface \"matte\" \"Ka\" [0] \"Kd\" [0]\n" +
                             quad(".3 1.99 .7 .9 1.99 .7 .9 1.99 1.3 .3 1.99 1.3") +
                             "AttributeEnd\nIlluminate 1 1\n";
    const std::string rooms = quad("0 0 0 3 0 0 3 0 2 0 0 2") + quad("0 2 0 3 2 0 3 2 2 0 2 2") +
                              quad("0 0 0 0 2 0 0 2 2 0 0 2") + quad("3 0 0 3 2 0 3 2 2 3 0 2") +
                              quad("0 0 0 3 0 0 3 2 0 0 2 0") + quad("0 0 2 3 0 2 3 2 2 0 2 2") +
                              quad(fmt::format("{0} 0 0 {0} 2 0 {0} 2 2 {0} 0 2", wall));
    return company.place + lamp + "Surface \"matte\" \"Ka\" [0] \"Kd\" [.7]\n" +
           (company.isInstance ? "ObjectBegin 1\n" + rooms + "ObjectEnd\nObjectInstance 1\n"
                               : rooms);
}

/// On the floor, so far from the wall, and on the wall, so high.
std::string besideTheWall(const Company &company, std::vector<double> distances) {
    std::string points;
    for (const double d : distances)
        points += fmt::format("{} 0 {} 0 {} 0\n", company.scale * (wall + d), company.scale * .83,
                              company.turned);
    for (const double d : distances)
        points += fmt::format("{} {} {} {} 0 0\n", company.scale * wall,
                              company.scale * company.turned * std::fabs(d), company.scale * .83,
                              d > 0 ? 1 : -1);
    return points;
}

} // namespace

/// The rooms have their floor and ceiling in common, and what elements of these send.
TEST_P(OverOneFloor, HardlyAnyLightLeaks) {
    const Company &company = GetParam();
    const std::string scene = siWorld(twoRooms(company), company.camera);
    const Probed dark = solve(scene, besideTheWall(company, {.003, .01, .03, .1, .3}));
    const Probed lit = solve(scene, besideTheWall(company, {-.003, -.01, -.03, -.1, -.3}));
    ASSERT_EQ(dark.answers.size(), 10u) << dark.run.text();
    ASSERT_EQ(lit.answers.size(), 10u) << lit.run.text();
    for (std::size_t k = 0; k < dark.answers.size(); ++k)
        EXPECT_LT(dark.answers[k].total, 1e-3 * lit.answers[k].total) << k;
}

/// As bright as by paths up to the wall's foot, and so is the wall.
TEST_P(OverOneFloor, NoShadowIsAtTheFoot) {
    const Company &company = GetParam();
    const std::string points = besideTheWall(company, {-.003, -.01, -.03, -.1, -.3});
    const std::string world = twoRooms(company);
    const Probed path = probe(siWorld(world, company.camera), points, {"--spp", "16384"});
    const Probed fe =
        solve(siWorld(world, company.camera + solvedBy("fe+direct")), points, {"--spp", "4096"});
    ASSERT_EQ(path.answers.size(), 10u) << path.run.text();
    ASSERT_EQ(fe.answers.size(), 10u) << fe.run.text();
    for (std::size_t k = 0; k < 10; ++k)
        EXPECT_NEAR(fe.answers[k].total, path.answers[k].total, .06 * path.answers[k].total) << k;
}

INSTANTIATE_TEST_SUITE_P(
    SolvedProbe, OverOneFloor,
    testing::Values(Company{"seenFromWithin", "Translate -1 -1 0\n", ""},
                    Company{"mirroredCamera", "Scale -1 1 1\nTranslate -1 -1 5\n", ""},
                    Company{"mirroredWorld", "Translate -1 1 5\n", "Scale 1 -1 1\n", 1, -1},
                    Company{"anInstance", "Translate -1 -1 5\n", "", 1, 1, true},
                    Company{"tiny", "Translate -.001 -.001 .005\n", "Scale .001 .001 .001\n", .001},
                    Company{"huge", "Translate -1000 -1000 5000\n", "Scale 1000 1000 1000\n", 1000},
                    Company{"farOff", "Translate -3001 -1 5\nTranslate 3000 0 0\n", ""}),
    testing::PrintToStringParamName());

} // namespace candela::test

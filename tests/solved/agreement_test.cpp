// SPDX-License-Identifier: Apache-2.0
// Radiosity and `path` give the same light, region by region, whatever the final pass: one scene,
// four answers.
#include "tests/light_paths/regions.h"
#include "tests/solved/solved.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <map>
#include <set>

namespace candela::test {

/// How GoogleTest names a world that failed.
static void PrintTo(const World &world, std::ostream *stream) { *stream << world.name; }

namespace {

constexpr int seeds = 4, regions = 5;
constexpr double familyWiseLevel = 1e-3;

/// What elements may get wrong of a region, in shares of the picture's mean.
double toleranceOf(const World &world) {
    // Mirrors and glass scatter as if they were matt in the solution (docs/radiosity.md).
    static const std::map<std::string, double> coarser = {
        {"Mirror", 0.06}, {"Glass", 0.2}, {"BallInGlass", 0.2}};
    const auto found = coarser.find(world.name);
    return found == coarser.end() ? 0.015 : found->second;
}

Regions renderRegions(const World &world, const std::string &options) {
    return renderRegions(world, options, {regions, seeds, 64, true});
}

class RadiosityAgreement : public testing::TestWithParam<World> {};

TEST_P(RadiosityAgreement, WithPathRegionByRegion) {
    const World &world = GetParam();
    const Regions path = renderRegions(world, viewOf(world, "path"));
    ASSERT_FALSE(path.empty());
    double mean = 0;
    for (const std::vector<double> &region : path)
        mean += meanAndError(region).mean / double(path.size());
    ASSERT_GT(mean, 0);
    const double level = familyWiseLevel / double(2 * regions * regions * std::size(finalPasses)) /
                         double(worlds().size());
    for (const char *pass : finalPasses) {
        SCOPED_TRACE(pass);
        const std::string option =
            std::string("Option \"radiosity\" \"string finalpass\" [\"") + pass + "\"]\n";
        const Regions found = renderRegions(world, option + viewOf(world, "radiosity"));
        ASSERT_FALSE(found.empty());
        double worst = 0, sum = 0;
        for (std::size_t region = 0; region < path.size(); ++region) {
            // The same seeds see the same edges.
            std::vector<double> differences;
            for (int seed = 0; seed < seeds; ++seed)
                differences.push_back(found[region][std::size_t(seed)] -
                                      path[region][std::size_t(seed)]);
            const MeanAndError difference = meanAndError(differences);
            EXPECT_LE(std::fabs(difference.mean),
                      studentQuantile(level, seeds - 1) * difference.standardError +
                          toleranceOf(world) * mean)
                << "region " << region << ": " << meanAndError(path[region]).mean << " by path, "
                << meanAndError(found[region]).mean << " by radiosity";
            worst = std::max(worst, std::fabs(difference.mean) / mean);
            sum += difference.mean / mean / double(path.size());
        }
        std::printf("    %-9s differs by %+.2f %%, of a region by %.2f %%\n", pass, 100 * sum,
                    100 * worst);
    }
}

std::string nameOf(const testing::TestParamInfo<World> &info) { return info.param.name; }

/// What bodies do with light within them is left to paths (docs/radiosity.md).
bool isServed(const World &world) {
    return world.text.find("Interior") == std::string::npos &&
           world.text.find("Exterior") == std::string::npos &&
           world.text.find("Atmosphere") == std::string::npos;
}

/// Those of every day, and the rest (make test-long).
std::vector<World> worldsBy(bool everyDay) {
    static const std::set<std::string> names = {
        "Room",       "Mirrored",    "Tiny",   "FarAway",        "SphereLamp", "LampByASurface",
        "PointLight", "Sky",         "Linked", "Opacity",        "OneSided",   "Instances",
        "LampOfDisk", "LampOfTorus", "Spot",   "LampOfBothSides"};
    std::vector<World> chosen;
    for (const World &world : worlds())
        if (isServed(world) && names.contains(world.name) == everyDay)
            chosen.push_back(world);
    return chosen;
}

INSTANTIATE_TEST_SUITE_P(EveryDay, RadiosityAgreement, testing::ValuesIn(worldsBy(true)), nameOf);
INSTANTIATE_TEST_SUITE_P(Others, RadiosityAgreement, testing::ValuesIn(worldsBy(false)), nameOf);

} // namespace
} // namespace candela::test

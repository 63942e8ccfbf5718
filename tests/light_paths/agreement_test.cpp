// SPDX-License-Identifier: Apache-2.0
// `bidir` and `path` give the same light, region by region, whatever techniques are taken and
// however they are weighed; so weights sum to 1, and what one end makes of a surface is what the
// other does. `vcm` does, too, but for what light is spread by merging.
#include "tests/light_paths/regions.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>
#include <span>

namespace candela::test {

/// How GoogleTest names a world that failed.
static void PrintTo(const World &world, std::ostream *stream) { *stream << world.name; }

namespace {

constexpr int seeds = 8;
/// The long test, which the environment asks for, has 10 x 10 regions.
const bool fine = std::getenv("CANDELA_FINE") != nullptr;
const int regions = fine ? 10 : 5, moreSamples = fine ? 4 : 1;
constexpr double familyWiseLevel = 1e-3;
/// Floats, and densities of hits on curved lamps, which are diced.
constexpr double rounding = 2e-4;

/// What light may be shifted by, as a share of it.
struct Bias {
    double region, picture;
};
/// Over discs: walls end at their edges, and light changes from here to there.
constexpr Bias biasOfMerging{.03, .01};

struct Techniques {
    const char *name, *options;
};

/// Each alone, where it is complete: much trust leaves all that they find to paths from lights.
const Techniques techniques[] = {
    {"Image", "Option \"bidir\" \"float lightpaths\" [1] \"integer connections\" [0]\n"},
    {"All", "Option \"bidir\" \"float lightpaths\" [.5] \"integer connections\" [1]\n"},
    {"Trusted", "Option \"bidir\" \"float lightpaths\" [1] \"integer connections\" [1] \"float "
                "trust\" [30]\n"},
};

/// Merging, with weights as they are, and alone wherever there is something to merge.
const Techniques mergings[] = {
    {"Merged", "Option \"bidir\" \"float lightpaths\" [8] \"integer connections\" [1]\n"},
    {"MergedAlone", "Option \"bidir\" \"float lightpaths\" [8] \"integer connections\" [0]\n"
                    "Option \"vcm\" \"float trust\" [1000]\n"},
};

std::string optionsOf(const World &world, const std::string &integrator) {
    return "Option \"vcm\" \"float radius\" [" + std::to_string(.03 * scaleOf(world)) + "]\n" +
           viewOf(world, integrator);
}

Regions renderRegions(const World &world, const std::string &options, int samples) {
    return renderRegions(world, options, {regions, seeds, samples, world.mayWarn});
}

std::vector<double> sumsOf(const Regions &values) {
    std::vector<double> sums(seeds);
    for (const std::vector<double> &region : values)
        for (int seed = 0; seed < seeds; ++seed)
            sums[seed] += region[seed];
    return sums;
}

/// Of independent seeds; `bias` is relative.
void compare(const std::string &what, const std::vector<double> &path,
             const std::vector<double> &other, double bias) {
    const MeanAndError a = meanAndError(path), b = meanAndError(other);
    const double comparisons = double(2 * regions * regions + 1) * double(worlds().size()) *
                               double(std::size(techniques) + std::size(mergings));
    const double error = std::hypot(a.standardError, b.standardError);
    EXPECT_LE(std::fabs(b.mean - a.mean),
              studentQuantile(familyWiseLevel / comparisons, seeds - 1) * error +
                  bias * std::fabs(a.mean))
        << what << ": path " << a.mean << " +- " << a.standardError << ", other " << b.mean
        << " +- " << b.standardError;
}

void expectAgreement(const World &world, const std::string &integrator, int samples,
                     std::span<const Techniques> techniques, Bias bias) {
    const Regions path = renderRegions(world, optionsOf(world, "path"), 64 * moreSamples);
    ASSERT_FALSE(path.empty());
    const std::vector<double> pathSums = sumsOf(path);
    EXPECT_GT(meanAndError(pathSums).mean, 0);
    for (const Techniques &taken : techniques) {
        SCOPED_TRACE(taken.name);
        const Regions others = renderRegions(world, taken.options + optionsOf(world, integrator),
                                             samples * moreSamples);
        ASSERT_FALSE(others.empty());
        for (std::size_t region = 0; region < path.size(); ++region)
            compare("region " + std::to_string(region), path[region], others[region], bias.region);
        const std::vector<double> sums = sumsOf(others);
        compare("the picture", pathSums, sums, bias.picture);
        std::printf("    %-12s differs by %+.3f %%\n", taken.name,
                    100 * (meanAndError(sums).mean / meanAndError(pathSums).mean - 1));
    }
}

class Agreement : public testing::TestWithParam<World> {};

TEST_P(Agreement, OfPathAndBidirRegionByRegion) {
    expectAgreement(GetParam(), "bidir", 32, techniques, {rounding, rounding});
}

/// Those in which merging has something of its own to go wrong with.
std::vector<World> worldsToMergeIn() {
    const std::string names[] = {"Room",   "Mirrored",        "Tiny",      "Huge",
                                 "Sun",    "Linked",          "OneSided",  "OpacityUnderAPoint",
                                 "Glass",  "EyeOfTheCamera",  "Toon",      "Instances",
                                 "Mirror", "TwoKindsOfLight", "BodyInFog", "TwoScatterings"};
    std::vector<World> chosen = worlds();
    std::erase_if(chosen, [&](const World &world) {
        return std::ranges::find(names, world.name) == std::end(names);
    });
    return chosen;
}

class Merging : public testing::TestWithParam<World> {};

TEST_P(Merging, AgreesWithPathRegionByRegion) {
    expectAgreement(GetParam(), "vcm", 16, mergings, biasOfMerging);
}

std::string nameOf(const testing::TestParamInfo<World> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Bidir, Agreement, testing::ValuesIn(worlds()), nameOf);
INSTANTIATE_TEST_SUITE_P(Vcm, Merging, testing::ValuesIn(worldsToMergeIn()), nameOf);

} // namespace
} // namespace candela::test

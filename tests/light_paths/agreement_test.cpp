// SPDX-License-Identifier: Apache-2.0
// `bidir` and `path` give the same light, region by region, whatever techniques are taken and
// however they are weighed; so weights sum to 1, and what one end makes of a surface is what the
// other does.
#include "tests/light_paths/worlds.h"
#include "tests/support/frames.h"

#include <cmath>
#include <cstdlib>
#include <gtest/gtest.h>

namespace candela::test {

/// How GoogleTest names a world that failed.
static void PrintTo(const World &world, std::ostream *stream) { *stream << world.name; }

namespace {

constexpr int seeds = 8, regions = 5, pixels = 20;
constexpr double familyWiseLevel = 1e-3;
/// Floats, and densities of hits on curved lamps, which are diced.
constexpr double rounding = 2e-4;

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

std::string optionsOf(const World &world, const std::string &integrator) {
    const bool tiny = world.name == "Tiny", huge = world.name == "Huge";
    return "Format 20 20 1\nOption \"render\" \"string integrator\" [\"" + integrator + "\"]\n" +
           "Projection \"perspective\" \"fov\" [60]\n" + world.camera + "Translate 0 0 " +
           (tiny   ? ".0026"
            : huge ? "2600"
                   : "2.6") +
           "\n";
}

/// values[region][seed], of red and green.
using Regions = std::vector<std::vector<double>>;

Regions renderRegions(const World &world, const std::string &options, int samples) {
    Regions result(2 * regions * regions, std::vector<double>(seeds));
    for (int seed = 0; seed < seeds; ++seed) {
        const std::vector<FramePixels> frames =
            render(std::vector<Frame>{{world.name, options, world.text}},
                   {samples, seed + 1, "light_paths/shaders", world.mayWarn});
        if (frames.empty())
            return {};
        constexpr int side = pixels / regions;
        for (int k = 0; k < pixels * pixels; ++k) {
            const int region = k / pixels / side * regions + k % pixels / side;
            result[region][seed] += frames[0].red[k] / (side * side);
            result[regions * regions + region][seed] += frames[0].green[k] / (side * side);
        }
    }
    return result;
}

std::vector<double> sumsOf(const Regions &values) {
    std::vector<double> sums(seeds);
    for (const std::vector<double> &region : values)
        for (int seed = 0; seed < seeds; ++seed)
            sums[seed] += region[seed];
    return sums;
}

/// Of independent seeds.
void compare(const std::string &what, const std::vector<double> &path,
             const std::vector<double> &bidir) {
    const MeanAndError a = meanAndError(path), b = meanAndError(bidir);
    const double comparisons =
        double(2 * regions * regions + 1) * std::size(techniques) * double(worlds().size());
    const double error = std::hypot(a.standardError, b.standardError);
    EXPECT_LE(std::fabs(b.mean - a.mean),
              studentQuantile(familyWiseLevel / comparisons, seeds - 1) * error +
                  rounding * std::fabs(a.mean))
        << what << ": path " << a.mean << " +- " << a.standardError << ", bidir " << b.mean
        << " +- " << b.standardError;
}

class Agreement : public testing::TestWithParam<World> {};

TEST_P(Agreement, OfPathAndBidirRegionByRegion) {
    const World &world = GetParam();
    const Regions path = renderRegions(world, optionsOf(world, "path"), 64);
    ASSERT_FALSE(path.empty());
    for (const Techniques &taken : techniques) {
        SCOPED_TRACE(taken.name);
        const Regions bidir = renderRegions(world, taken.options + optionsOf(world, "bidir"), 32);
        ASSERT_FALSE(bidir.empty());
        for (std::size_t region = 0; region < path.size(); ++region)
            compare("region " + std::to_string(region), path[region], bidir[region]);
        const std::vector<double> pathSums = sumsOf(path), sums = sumsOf(bidir);
        compare("the picture", pathSums, sums);
        EXPECT_GT(meanAndError(pathSums).mean, 0);
        std::printf("    %-8s differs by %+.3f %%\n", taken.name,
                    100 * (meanAndError(sums).mean / meanAndError(pathSums).mean - 1));
    }
}

std::string nameOf(const testing::TestParamInfo<World> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(All, Agreement, testing::ValuesIn(worlds()), nameOf);

} // namespace
} // namespace candela::test

// SPDX-License-Identifier: Apache-2.0
#include "tests/light_paths/regions.h"

#include "tests/support/frames.h"

namespace candela::test {

double scaleOf(const World &world) {
    return world.name == "Tiny" ? .001 : world.name == "Huge" ? 1000 : 1;
}

std::string viewOf(const World &world, const std::string &integrator) {
    return "Format 20 20 1\nOption \"render\" \"string integrator\" [\"" + integrator + "\"]\n" +
           "Projection \"perspective\" \"fov\" [60]\n" + world.camera + "Translate 0 0 " +
           std::to_string(2.6 * scaleOf(world)) + "\n";
}

Regions renderRegions(const World &world, const std::string &options,
                      const RegionSettings &settings) {
    constexpr int pixels = 20;
    const int regions = settings.regions, side = pixels / regions;
    Regions result(std::size_t(2 * regions * regions),
                   std::vector<double>(std::size_t(settings.seeds)));
    for (int seed = 0; seed < settings.seeds; ++seed) {
        const std::vector<FramePixels> frames =
            render(std::vector<Frame>{{world.name, options, world.text}},
                   {settings.samples, seed + 1, "light_paths/shaders", settings.mayWarn});
        if (frames.empty())
            return {};
        for (int k = 0; k < pixels * pixels; ++k) {
            const int region = k / pixels / side * regions + k % pixels / side;
            result[region][seed] += frames[0].red[k] / (side * side);
            result[regions * regions + region][seed] += frames[0].green[k] / (side * side);
        }
    }
    return result;
}

} // namespace candela::test

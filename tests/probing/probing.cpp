// SPDX-License-Identifier: Apache-2.0
#include "tests/probing/probing.h"

#include "tests/support/scratch_folder.h"

#include <cstdio>
#include <sstream>

namespace candela::test {

Probed probe(const std::string &scene, const std::string &points,
             std::vector<std::string> options) {
    ScratchFolder folder;
    std::vector<std::string> arguments{"probe", folder.write("scene.rib", scene),
                                       folder.write("points.txt", points), "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    Probed result{runCandela(arguments), {}};
    std::istringstream lines(result.run.out);
    for (std::string line; std::getline(lines, line);) {
        Answer a;
        if (std::sscanf(line.c_str(), "%lf %lf %lf %lf %lf %lf %d", &a.R, &a.G, &a.B, &a.total,
                        &a.photometric, &a.halfWidth, &a.samples) == 7)
            result.answers.push_back(a);
    }
    return result;
}

std::string siWorld(const std::string &world, const std::string &camera) {
    return "Option \"radiometry\" \"string units\" \"si\"\n" + camera + "WorldBegin\n" + world +
           "WorldEnd\n";
}

std::string lamp(const std::string &shape, double radiance, bool oneSided) {
    return "AttributeBegin\nAreaLightSource \"arealight\" 1 \"radiance\" [" +
           std::to_string(radiance) + "] \"onesided\" [" + (oneSided ? "1" : "0") +
           "]\nSurface \"matte\" \"Kd\" [0] \"Ka\" [0]\n" + shape +
           "AttributeEnd\nIlluminate 1 1\n";
}

} // namespace candela::test

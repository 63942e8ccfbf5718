// SPDX-License-Identifier: Apache-2.0
#include "apps/shared_options.h"

#include <tuple>

namespace candela {

void TestingArguments::apply(RenderSettings &settings) const {
    settings.jit.width = lanes;
    settings.hemisphereOnly = sampling == "hemisphere";
}

void addTestingOptions(CLI::App &verb, TestingArguments &a, RenderSettings &settings) {
    auto *testing = verb.add_option_group("For tests and benchmarks");
    testing->add_option("--lanes", a.lanes, "Lane width of compiled shaders; default 16")
        ->check(CLI::IsMember({1, 16}));
    testing->add_option(
        "--cpu", a.cpu,
        "x86-64 level of all code: v2, v3 or v4; default: $CANDELA_CPU, else the best");
    testing->add_option("--sampling", a.sampling, "cones, or hemisphere: ignore importance cones")
        ->check(CLI::IsMember({"cones", "hemisphere"}));
    testing->add_option("--stats", settings.statisticsFile,
                        "Write figures of the run to this JSON file");
}

void addSearchPaths(CLI::App &verb, RenderSettings &settings) {
    for (auto [name, folders, what] : {std::tuple{"--shader-path", &settings.shaderPath, "shaders"},
                                       {"--archive-path", &settings.archivePath, "archives"},
                                       {"--texture-path", &settings.texturePath, "textures"}})
        verb.add_option(name, *folders, "Folders to look for " + std::string(what) + " in: a:b:c")
            ->delimiter(':')
            ->allow_extra_args(false);
}

void addSolutionFiles(CLI::App &verb, RenderSettings &settings) {
    verb.add_option(
            "--solution", settings.solutionFile,
            "Radiosity: begins with the solution in this file, of whatever view of the same "
            "scene; written if it is not there")
        ->type_name("FILE");
    verb.add_option("--solution-mesh", settings.solutionMesh,
                    "Radiosity: writes the solution's elements and their radiance, PLY")
        ->type_name("FILE");
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"
#include "apps/verbs.h"

#include "render/run_shader.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    RunSettings settings;
    std::string size, cpu;
    int lanes = laneBlock;
};

/// What is wrong with "WxH"; empty if nothing is, and the settings have it.
std::string takeSize(const std::string &text, RunSettings &settings) {
    char end = 0;
    const bool good =
        text.empty() ||
        (std::sscanf(text.c_str(), "%dx%d%c", &settings.width, &settings.height, &end) == 2 &&
         settings.width > 0 && settings.height > 0 && settings.width <= 8192 &&
         settings.height <= 8192);
    return good ? "" : "--size: expected WIDTHxHEIGHT, each from 1 to 8192, not '" + text + "'";
}

int runGiven(Arguments &a) {
    a.settings.jit.width = a.lanes;
    const std::string flaw = takeSize(a.size, a.settings);
    if (flaw.empty())
        return runShader(a.settings);
    std::fprintf(stderr, "candela run: %s\nRun with --help for more information.\n", flaw.c_str());
    return 2;
}

} // namespace

void addRun(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *run = app.add_subcommand(
        "run", "Run a shader over a grid of points, without a scene: a picture or numbers out");
    run->footer("The points fill the square from (-1, 1, 0) to (1, -1, 0); u, v, s, t go from 0 to "
                "1 over it, N is (0, 0, -1), the eye is far away along it, with a white light "
                "there. Cs and Os are 1. Imagers get pixels, light shaders the square as what they "
                "light.\n"
                "Exit status: 0 all went well, 1 something was wrong and has been reported, 2 the "
                "command line cannot be understood.");
    run->add_option("shader", a.settings.shader,
                    "A file, or a name that is looked for on the shader path and in the library")
        ->required();
    run->add_option("values", a.settings.values, "Parameters: Kd=.5 tint=1,0,0 name=text")
        ->type_name("PARAMETER=VALUE");
    run->add_option("--size", a.size, "Points across and down; default 64x64")->type_name("WxH");
    run->add_option("-o,--output", a.settings.output,
                    "A picture to write: .png, else EXR with all outputs as layers; without it "
                    "numbers are printed, a line a point");
    run->add_option("--show", a.settings.shown,
                    "The output that is the picture's R, G, B; default Ci, of lights Cl, of what "
                    "moves points P")
        ->type_name("OUTPUT");
    run->add_flag("--bounds", a.settings.bounds,
                  "Of a surface: reflectance in a uniform field, Ce and Oi over boxes of the grid: "
                  "the value in the middle, slopes by u and v, the tolerance, and the deviation of "
                  "64 points; the picture is \"reflectance tolerance\"");
    run->add_option("--shader-path", a.settings.shaderPath, "Folders to look for shaders in: a:b:c")
        ->delimiter(':')
        ->allow_extra_args(false);
    run->add_option("--texture-path", a.settings.texturePath,
                    "Folders to look for textures in, before the current one: a:b:c")
        ->delimiter(':')
        ->allow_extra_args(false);
    run->add_option("--lanes", a.lanes, "Lane width of compiled shaders; default 16")
        ->check(CLI::IsMember({1, 16}));
    run->add_option("--cpu", a.cpu,
                    "x86-64 level of all code: v2, v3 or v4; default: $CANDELA_CPU, else the best");
    run->callback([arguments, &status] {
        status = instructionSetIsAsAsked(arguments->cpu) ? runGiven(*arguments) : 2;
    });
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"
#include "apps/verbs.h"

#include "render/filter_file.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    FilterFileSettings settings;
    std::vector<float> exposure;
    std::string cpu;
    int lanes = laneBlock;
    bool list = false;
};

/// What is wrong with the pair of --exposure; empty if nothing is.
std::string flawOfExposure(const std::vector<float> &exposure) {
    const bool good = exposure.empty() || (exposure[0] >= 0 && std::isfinite(exposure[0]) &&
                                           exposure[1] > 0 && std::isfinite(exposure[1]));
    return good ? "" : "--exposure: expected a gain from 0 up and a gamma above 0";
}

int run(Arguments &a) {
    FilterFileSettings &settings = a.settings;
    settings.jit.width = a.lanes;
    if (a.list)
        return listFilters(settings);
    const std::string flaw = settings.input.empty() || settings.output.empty()
                                 ? "expected two pictures: in.exr out.exr"
                                 : flawOfExposure(a.exposure);
    if (!flaw.empty()) {
        std::fprintf(stderr, "candela filter: %s\nRun with --help for more information.\n",
                     flaw.c_str());
        return 2;
    }
    if (!a.exposure.empty())
        settings.exposure = {a.exposure[0], a.exposure[1]};
    return filterFile(settings);
}

} // namespace

void addFilter(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    FilterFileSettings &s = a.settings;
    CLI::App *filter = app.add_subcommand(
        "filter", "Run filter shaders on a picture, as PushFilter does on a frame: tone mapping, "
                  "denoising, bloom");
    filter->footer(
        "R, G, B (or else the layer radiance) are what filters read as \"Cs\", A is \"Oi\", other "
        "channels and layers are maps of their names. All channels of the picture are written, "
        "R, G, B as filtered; a PNG picture gets R, G, B, A alone.\n"
        "Exit status: 0 all went well, 1 something was wrong and has been reported, 2 the command "
        "line cannot be understood, 130 interrupted: nothing is written.");
    filter->add_option("in", s.input,
                       "A picture: EXR, or PNG, whose values are taken to be sRGB and made linear");
    filter->add_option("out", s.output, "The picture to write: .png, else EXR");
    filter
        ->add_option("-f,--filter", s.filters,
                     "A filter, and its parameters: -f ward94 L_dmax=80 tint=1,0.9,0.8; several "
                     "run in their order; none: the picture in another format")
        ->type_name("NAME [PARAMETER=VALUE]");
    filter
        ->add_option("--exposure", a.exposure,
                     "GAIN GAMMA, applied to R, G, B at the end; default 1 1, and for PNG the "
                     "curve of sRGB")
        ->type_name("NUMBER")
        ->expected(2);
    filter
        ->add_option(
            "--keep", s.kept,
            "Also writes these maps, which the filters make: a,b (their other maps are for "
            "their own use)")
        ->delimiter(',')
        ->type_name("MAP")
        ->allow_extra_args(false);
    filter->add_flag("--list", a.list,
                     "List filters, those of the library and of --shader-path: name, parameters, "
                     "what they do");
    filter->add_option("--shader-path", s.shaderPath, "Folders to look for shaders in: a:b:c")
        ->delimiter(':')
        ->allow_extra_args(false);
    filter->add_option("--threads", s.threads, "Threads; default: all cores")
        ->check(CLI::Range(1, 1024));
    filter->add_flag("--quiet", s.quiet, "No progress, only messages");
    filter->add_option("--lanes", a.lanes, "Lane width of compiled shaders; default 16")
        ->check(CLI::IsMember({1, 16}));
    filter->add_option("--cpu", a.cpu,
                       "x86-64 level of all code: v2, v3 or v4; default: $CANDELA_CPU, else the "
                       "best");
    filter->callback([arguments, &status] {
        status = instructionSetIsAsAsked(arguments->cpu) ? run(*arguments) : 2;
    });
}

} // namespace candela

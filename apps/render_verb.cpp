// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"
#include "apps/shared_options.h"
#include "apps/verbs.h"

#include "render/render.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

/// "640x480"
std::optional<std::array<int, 2>> parseFormat(const std::string &text) {
    int width = 0, height = 0, used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &width, &height, &used) != 2 ||
        used != int(text.size()) || width < 1 || height < 1 || width > 65536 || height > 65536)
        return std::nullopt;
    return std::array<int, 2>{width, height};
}

/// "0,0.5,0,1"
std::optional<std::array<float, 4>> parseCrop(const std::string &text) {
    std::array<float, 4> c{};
    int used = 0;
    if (std::sscanf(text.c_str(), "%f,%f,%f,%f%n", &c[0], &c[1], &c[2], &c[3], &used) != 4 ||
        used != int(text.size()))
        return std::nullopt;
    bool good = c[0] >= 0 && c[0] < c[1] && c[1] <= 1 && c[2] >= 0 && c[2] < c[3] && c[3] <= 1;
    return good ? std::optional(c) : std::nullopt;
}

template <class Parse> auto checked(Parse parse, const char *expected) {
    return [parse, expected](const std::string &text) {
        return parse(text) ? std::string() : "expected " + std::string(expected);
    };
}

struct Arguments {
    RenderSettings settings;
    std::vector<std::string> files;
    std::string format, crop, integrator, frames, checkpoint;
    int samples = 0;
    TestingArguments testing;
};

} // namespace

void addRender(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    RenderSettings &s = a.settings;

    app.add_option("scene", a.files,
                   "RIB files to render, read as if they were one; - reads standard input");
    app.add_option("-o,--output", s.outputFile,
                   "The picture's file, by its extension, in place of the first display's; #### "
                   "becomes the number of the frame")
        ->type_name("FILE");
    app.add_option("--frames", a.frames, "The frames to render: 1-10,20; default: all")
        ->check(CLI::Validator(checked(parseFrameNumbers, "numbers and ranges: 1-10,20"), ""));
    app.add_option("--spp", a.samples, "Samples a pixel, in place of PixelSamples")
        ->check(CLI::Range(1, maximumSamplesPerPixel));
    app.add_option("--threads", s.threads, "Threads; default: all cores")
        ->check(CLI::Range(1, 1024));
    app.add_option("--seed", s.seed, "Seed of all random choices; default 0");
    app.add_option("--integrator", a.integrator,
                   "path, bidir, vcm, radiosity or classic; default: as the RIB has it")
        ->check(CLI::IsMember({"path", "bidir", "vcm", "radiosity", "classic"}));
    app.add_option("--crop", a.crop, "X0,X1,Y0,Y1: part of the frame, 0 to 1 from the top left")
        ->check(CLI::Validator(checked(parseCrop, "X0,X1,Y0,Y1 within 0 and 1"), ""));
    app.add_option(
           "--format", a.format,
           "WxH: resolution in pixels, in place of Format; a FrameAspectRatio makes it smaller")
        ->check(CLI::Validator(checked(parseFormat, "WIDTHxHEIGHT"), ""));
    app.add_option("--time-limit", s.timeLimit,
                   "Seconds after which the pictures are written as they are")
        ->check(CLI::Range(0.001, 1e9))
        ->type_name("SECONDS");
    app.add_option("--checkpoint", a.checkpoint,
                   "A file that says how far the render is, written now and then: --resume goes on "
                   "from there")
        ->type_name("FILE");
    app.add_option("--every", s.secondsBetweenCheckpoints,
                   "Seconds from one checkpoint to the next; default 60")
        ->check(CLI::Range(0.01, 1e9))
        ->type_name("SECONDS");
    app.add_option("--resume", s.resumeFile,
                   "Goes on from this checkpoint of the same scene and settings; it goes on being "
                   "written unless --checkpoint names another")
        ->type_name("FILE");
    app.add_option("--solution", s.solutionFile,
                   "Radiosity: begins with the solution in this file, of whatever view of the same "
                   "scene; written if it is not there")
        ->type_name("FILE");
    app.add_option("--solution-mesh", s.solutionMesh,
                   "Radiosity: writes the solution's elements and their radiance, PLY")
        ->type_name("FILE");
    app.add_option("--output-dir", s.outputDirectory, "Folder for pictures; default: this one");
    addSearchPaths(app, s);
    app.add_flag(
        "--trust,--allow-programs", s.trust,
        "Trust the RIB: let it run programs (Procedural \"RunProgram\"), write outside the "
        "output folder and replace files that are no pictures");
    app.add_flag("--quiet", s.quiet, "No progress, only messages");
    addTestingOptions(app, a.testing, s);

    app.callback([arguments, &app, &status] {
        Arguments &a = *arguments;
        if (!app.get_subcommands().empty())
            return;
        if (a.files.empty())
            throw CLI::CallForHelp();
        RenderSettings &s = a.settings;
        if (a.samples > 0)
            s.samplesPerPixel = a.samples;
        if (!a.integrator.empty())
            s.integrator = a.integrator;
        s.checkpointFile = a.checkpoint.empty() ? s.resumeFile : a.checkpoint;
        if (!a.frames.empty())
            s.frames = *parseFrameNumbers(a.frames);
        s.resolution = parseFormat(a.format);
        s.crop = parseCrop(a.crop);
        a.testing.apply(s);
        if (!instructionSetIsAsAsked(a.testing.cpu)) {
            status = 2;
            return;
        }
        status = renderFiles(a.files, s);
    });
}

} // namespace candela

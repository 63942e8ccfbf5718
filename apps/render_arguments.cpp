// SPDX-License-Identifier: Apache-2.0
#include "apps/render_arguments.h"

#include "apps/asked_instruction_set.h"

#include <cstdio>

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

} // namespace

void RenderArguments::addTo(CLI::App &app) {
    app.add_option("-o,--output", settings.outputFile,
                   "The picture's file, by its extension, in place of the first display's; #### "
                   "becomes the number of the frame")
        ->type_name("FILE");
    app.add_option("--frames", frames, "The frames to render: 1-10,20; default: all")
        ->check(CLI::Validator(checked(parseFrameNumbers, "numbers and ranges: 1-10,20"), ""));
    app.add_option("--spp", samples,
                   "Samples of every pixel, in place of PixelSamples and PixelVariance")
        ->check(CLI::Range(1, maximumSamplesPerPixel));
    app.add_option("--pixel-variance", settings.pixelVariance,
                   "Pixels take as many samples as this variance needs, in place of PixelVariance; "
                   "--spp or PixelSamples are the most")
        ->check(CLI::Range(0.0, 1e30));
    app.add_option("--threads", settings.threads, "Threads; default: all cores")
        ->check(CLI::Range(1, 1024));
    app.add_option("--seed", settings.seed, "Seed of all random choices; default 0");
    app.add_option("--integrator", integrator,
                   "path, bidir, vcm, radiosity or classic; default: as the RIB has it")
        ->check(CLI::IsMember({"path", "bidir", "vcm", "radiosity", "classic"}));
    app.add_option("--crop", crop, "X0,X1,Y0,Y1: part of the frame, 0 to 1 from the top left")
        ->check(CLI::Validator(checked(parseCrop, "X0,X1,Y0,Y1 within 0 and 1"), ""));
    app.add_option(
           "--format", format,
           "WxH: resolution in pixels, in place of Format; a FrameAspectRatio makes it smaller")
        ->check(CLI::Validator(checked(parseFormat, "WIDTHxHEIGHT"), ""));
    app.add_option("--time-limit", settings.timeLimit,
                   "Seconds after which the pictures are written as they are")
        ->check(CLI::Range(0.001, 1e9))
        ->type_name("SECONDS");
    app.add_option("--checkpoint", checkpoint,
                   "A file that says how far the render is, written now and then: --resume goes on "
                   "from there")
        ->type_name("FILE");
    app.add_option("--every", settings.secondsBetweenCheckpoints,
                   "Seconds from one checkpoint to the next; default 60")
        ->check(CLI::Range(0.01, 1e9))
        ->type_name("SECONDS");
    app.add_option("--resume", settings.resumeFile,
                   "Goes on from this checkpoint of the same scene and settings; it goes on being "
                   "written unless --checkpoint names another")
        ->type_name("FILE");
    addSolutionFiles(app, settings);
    app.add_option("--output-dir", settings.outputDirectory,
                   "Folder for pictures; default: this one");
    addSearchPaths(app, settings);
    app.add_flag(
        "--trust,--allow-programs", settings.trust,
        "Trust the RIB: let it run programs (Procedural \"RunProgram\"), write outside the "
        "output folder and replace files that are no pictures");
    app.add_flag("--quiet", settings.quiet, "No progress, only messages");
    addTestingOptions(app, testing, settings);
}

bool RenderArguments::apply() {
    if (samples > 0)
        settings.samplesPerPixel = samples;
    if (!integrator.empty())
        settings.integrator = integrator;
    settings.checkpointFile = checkpoint.empty() ? settings.resumeFile : checkpoint;
    if (!frames.empty())
        settings.frames = *parseFrameNumbers(frames);
    settings.resolution = parseFormat(format);
    settings.crop = parseCrop(crop);
    testing.apply(settings);
    return instructionSetIsAsAsked(testing.cpu);
}

} // namespace candela

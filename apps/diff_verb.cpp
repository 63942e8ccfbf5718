// SPDX-License-Identifier: Apache-2.0
#include "apps/verbs.h"

#include "image/compare.h"
#include "image/difference_picture.h"
#include "image/picture_file.h"
#include "render/picture_output.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> pictures, against;
    CompareSettings settings;
    int regionSize = SeedSettings{}.regionSize;
    std::string output;
    float full = 0.1f;
    bool flip = false, quiet = false;
};

int refuse(const std::string &problem) {
    std::fprintf(stderr, "candela diff: %s\n", problem.c_str());
    return 2;
}

/// Nothing, and `problem`, if one cannot be read.
std::optional<std::vector<Picture>> readAll(const std::vector<std::string> &files,
                                            std::string &problem) {
    std::vector<Picture> pictures;
    for (const std::string &file : files) {
        std::optional<Picture> picture = readPicture(file, problem);
        if (!picture)
            return std::nullopt;
        pictures.push_back(std::move(*picture));
    }
    return pictures;
}

/// The values as EXR, or what is for the eye as PNG; the exit status.
int writeDifference(const Arguments &arguments, Picture values, Picture shown, int status) {
    std::string problem;
    if (!writePicture(isPngName(arguments.output) ? shown : values, arguments.output, std::nullopt,
                      problem))
        return refuse(problem);
    return status;
}

/// By RiExposure: values that are no light any more.
bool hasGamma(const Picture &picture) {
    const auto exposure = picture.metadata.find("exposure");
    return exposure != picture.metadata.end() && !picture.hasDisplayValues &&
           !exposure->second.ends_with(" 1");
}

int compareTwo(const Arguments &arguments, const Picture &a, const Picture &b) {
    const Comparison comparison = comparePictures(a, b, arguments.settings);
    const int status = exitCodeOf(comparison);
    std::optional<FlipMap> flip;
    if (arguments.flip && comparison.problem.empty()) {
        flip = flipOf(a, b);
        if (!flip)
            return refuse("FLIP compares R, G and B, which both pictures must have");
    }
    std::string report = reportOf(comparison);
    if (flip) {
        char line[120];
        std::snprintf(line, sizeof line, "FLIP         mean %.6g (of %d exposure%s)\n", flip->mean,
                      flip->exposures, flip->exposures == 1 ? "" : "s");
        report.insert(report.rfind('\n', report.size() - 2) + 1, line); // Before the verdict.
    }
    if (!arguments.quiet)
        std::fputs(report.c_str(), stdout);
    if (hasGamma(a) && hasGamma(b))
        std::fputs(
            "candela diff: note: the colors have gone through Exposure with a gamma, and are no "
            "light any more; give Exposure 1 1 to compare light\n",
            stderr);
    if (arguments.output.empty() || status == 2)
        return status;
    return writeDifference(arguments, differenceOf(a, b, flip),
                           shownDifference(a, b, flip, arguments.full), status);
}

int compareGroups(const Arguments &arguments, const std::vector<Picture> &a,
                  const std::vector<Picture> &b) {
    const SeedComparison comparison =
        compareSeeds(a, b, {arguments.regionSize, arguments.settings.channels});
    const int status = exitCodeOf(comparison);
    if (!arguments.quiet)
        std::fputs(reportOf(comparison).c_str(), stdout);
    if (arguments.output.empty() || status == 2)
        return status;
    return writeDifference(arguments, differenceOf(comparison, a[0].window),
                           shownDifference(comparison, a[0].window), status);
}

int compareFiles(const Arguments &arguments) {
    if (arguments.against.empty() && arguments.pictures.size() != 2)
        return refuse("expected two pictures, or several --against several others");
    std::string problem;
    const auto pictures = readAll(arguments.pictures, problem);
    const auto against = pictures ? readAll(arguments.against, problem) : std::nullopt;
    if (!against)
        return refuse(problem);
    return against->empty() ? compareTwo(arguments, (*pictures)[0], (*pictures)[1])
                            : compareGroups(arguments, *pictures, *against);
}

} // namespace

void addDiff(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *diff = app.add_subcommand(
        "diff",
        "Compare two pictures (EXR or PNG): differences, errors, FLIP, and confidence where "
        "both carry variance; or the means of two integrators, by pictures of several seeds");
    diff->footer(
        "candela diff a.exr b.exr: b is the reference. candela diff a1.exr a2.exr a3.exr --against "
        "b1.exr b2.exr b3.exr: z-scores of regions, from how pictures of other seeds differ; a "
        "single one behind --against is taken to have no error.\n"
        "Exit status: 0 the same within the tolerance (several: as far as the seeds tell, at a "
        "level of 0.001), 1 they differ, 2 unusable.");
    diff->add_option("pictures", a.pictures, "Two pictures, or those of one kind")->required();
    diff->add_option("--against", a.against, "Pictures of the other kind")->type_name("PICTURE");
    diff->add_option("--regions", a.regionSize, "Pixels on a region's side; default 16")
        ->check(CLI::Range(1, 65536));
    diff->add_option("--tolerance", a.settings.tolerance,
                     "Largest absolute difference that counts as the same; default 0");
    diff->add_option("--relative", a.settings.relativeTolerance,
                     "The same, relative to the larger value; default 0");
    diff->add_option("--channels", a.settings.channels, "Only these channels: R,G,Z...")
        ->delimiter(',')
        ->allow_extra_args(false);
    diff->add_flag("--flip", a.flip, "FLIP of two pictures, HDR-FLIP of light");
    diff->add_option(
            "-o,--output", a.output,
            "A picture of the difference: .png red where the first is brighter, blue where "
            "the second is (with --flip its map); else EXR of a - b, flip, z")
        ->type_name("FILE");
    diff->add_option("--full", a.full,
                     "The difference, as a part of the value, that is all red or blue; default 0.1")
        ->check(CLI::Range(1e-6f, 1.0f));
    diff->add_flag("--quiet", a.quiet, "No report, only the exit status");
    diff->callback([arguments, &status] { status = compareFiles(*arguments); });
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/verbs.h"

#include "image/compare.h"
#include "image/picture_file.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::string a, b;
    CompareSettings settings;
    bool quiet = false;
};

int compareFiles(const Arguments &arguments) {
    std::string problem;
    std::optional<Picture> a = readPicture(arguments.a, problem);
    std::optional<Picture> b = a ? readPicture(arguments.b, problem) : std::nullopt;
    if (!a || !b) {
        std::fprintf(stderr, "candela diff: %s\n", problem.c_str());
        return 2;
    }
    Comparison comparison = comparePictures(*a, *b, arguments.settings);
    if (!arguments.quiet)
        std::fputs(reportOf(comparison).c_str(), stdout);
    return exitCodeOf(comparison);
}

} // namespace

void addDiff(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App *diff = app.add_subcommand(
        "diff", "Compare two pictures (EXR or PNG): largest and mean difference, relative error, "
                "and confidence where both carry variance");
    diff->footer("Exit status: 0 the same within the tolerance, 1 they differ, 2 unusable.");
    diff->add_option("a", arguments->a, "A picture")->required();
    diff->add_option("b", arguments->b, "The reference to compare it with")->required();
    diff->add_option("--tolerance", arguments->settings.tolerance,
                     "Largest absolute difference that counts as the same; default 0");
    diff->add_option("--relative", arguments->settings.relativeTolerance,
                     "The same, relative to the larger value; default 0");
    diff->add_option("--channels", arguments->settings.channels, "Only these channels: R,G,Z...")
        ->delimiter(',')
        ->allow_extra_args(false);
    diff->add_flag("--quiet", arguments->quiet, "No report, only the exit status");
    diff->callback([arguments, &status] { status = compareFiles(*arguments); });
}

} // namespace candela

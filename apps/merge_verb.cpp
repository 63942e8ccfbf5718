// SPDX-License-Identifier: Apache-2.0
#include "apps/verbs.h"

#include "foundation/base/whole_file.h"
#include "image/merge_pictures.h"
#include "image/picture_file.h"
#include "render/picture_output.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> files;
    std::string output;
};

int refuse(const std::string &problem) {
    std::fprintf(stderr, "candela merge: error: %s\n", problem.c_str());
    return 1;
}

int mergeFiles(const Arguments &arguments) {
    std::string problem;
    if (!canWriteFile(arguments.output, problem))
        return refuse(problem);
    std::vector<NamedPicture> pictures;
    for (const std::string &file : arguments.files) {
        std::optional<Picture> picture = readPicture(file, problem);
        if (!picture)
            return refuse(problem);
        pictures.push_back({file, std::move(*picture)});
    }
    std::optional<Picture> merged = mergePictures(pictures, problem);
    if (!merged || !writePicture(*merged, arguments.output, std::nullopt, problem))
        return refuse(problem);
    std::printf("wrote %s, %s samples a pixel\n", arguments.output.c_str(),
                merged->metadata.at("spp").c_str());
    return 0;
}

} // namespace

void addMerge(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *merge = app.add_subcommand(
        "merge", "Join pictures of one scene by different seeds, each as its samples count: "
                 "candela merge a.exr b.exr -o all.exr");
    merge->footer(
        "For render farms: run candela scene.rib --seed 1, --seed 2... on as many machines. The "
        "pictures have to be EXR, as they come: not exposed, quantised or filtered. Merged "
        "pictures can be merged again.\n"
        "Exit status: 0 all went well, 1 nothing is written, and why has been said, 2 the command "
        "line cannot be understood.");
    merge->add_option("pictures", a.files, "EXR pictures")->required();
    merge->add_option("-o,--output", a.output, "The picture to write: .png, else EXR")
        ->required()
        ->type_name("FILE");
    merge->callback([arguments, &status] { status = mergeFiles(*arguments); });
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/render_arguments.h"
#include "apps/verbs.h"

#include "foundation/base/letters.h"
#include "image/picture_file.h"
#include "image/view/picture_window.h"
#include "render/interrupt.h"

#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

namespace candela {

namespace {

constexpr const char *keys =
    "Keys: + - exposure by half a stop, 0 none; r g b a l one channel or luminance, again: all; "
    "page down, page up: the next layer or display; z x zoom, 1 pixel by pixel, f all of it; "
    "mouse: "
    "the wheel zooms, dragging moves; the title has the values under the pointer; q or Esc closes, "
    "and ends the render with the samples that there are.";

bool isPicture(const std::string &file) {
    const std::string extension = inSmallLetters(std::filesystem::path(file).extension().string());
    return extension == ".exr" || extension == ".png";
}

int complain(const std::string &problem) {
    std::fprintf(stderr, "candela: error: %s\n", problem.c_str());
    return 1;
}

/// 1 if some of them cannot be read; the others are shown.
int showPictures(const std::vector<std::string> &files, PictureWindow &window) {
    int status = 0;
    for (const std::string &file : files) {
        std::string problem;
        if (auto picture = readPicture(file, problem))
            window.take(file, std::move(*picture), true);
        else
            status = complain(problem);
    }
    return status;
}

int view(RenderArguments &arguments) {
    const auto pictures = std::ranges::count_if(arguments.files, isPicture);
    if (pictures > 0 && pictures < std::ssize(arguments.files))
        return complain("view shows pictures or a scene, not both at once"), 2;
    std::string problem;
    PictureWindow window(PictureWindow::Purpose::Viewer);
    if (!window.open(problem))
        return complain("there is no window: " + problem);
    if (pictures > 0)
        return showPictures(arguments.files, window);
    arguments.settings.taker = &window;
    const int status = renderFiles(arguments.files, arguments.settings);
    if (status != statusOfInterrupt)
        return status;
    const bool isClosed = window.wantsEnd(); // By the user, who is done with it.
    window.close();
    return isClosed ? 0 : status;
}

} // namespace

void addView(CLI::App &app, int &status) {
    CLI::App *verb = app.add_subcommand(
        "view",
        "Shows pictures, or a scene while it is rendered, in a window; the scene's displays "
        "become no files, but for the one of -o");
    auto arguments = std::make_shared<RenderArguments>();
    verb->add_option("files", arguments->files,
                     "Pictures (OpenEXR, PNG), or RIB files, read as if they were one; - reads "
                     "standard input")
        ->required();
    arguments->addTo(*verb);
    verb->footer(keys);
    verb->callback([arguments, &status] {
        if (!arguments->apply())
            status = 2;
        else
            status = view(*arguments);
    });
}

} // namespace candela

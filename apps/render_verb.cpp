// SPDX-License-Identifier: Apache-2.0
#include "apps/render_arguments.h"
#include "apps/verbs.h"

#include "image/view/picture_window.h"
#include "render/interrupt.h"

#include <CLI/CLI.hpp>
#include <memory>

namespace candela {

void addRender(CLI::App &app, int &status) {
    auto arguments = std::make_shared<RenderArguments>();
    app.add_option("scene", arguments->files,
                   "RIB files to render, read as if they were one; - reads standard input");
    arguments->addTo(app);
    app.callback([arguments, &app, &status] {
        if (!app.get_subcommands().empty())
            return;
        if (arguments->files.empty())
            throw CLI::CallForHelp();
        if (!arguments->apply()) {
            status = 2;
            return;
        }
        PictureWindow window(PictureWindow::Purpose::Framebuffers);
        arguments->settings.taker = &window;
        status = renderFiles(arguments->files, arguments->settings);
        if (status == statusOfInterrupt)
            window.close();
    });
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The command line: `candela scene.rib` renders, verbs do the rest.
#include "apps/verbs.h"

#include <CLI/CLI.hpp>

int main(int argc, char **argv) {
    CLI::App app{"Candela: a physically based renderer compatible with the RenderMan Interface."};
    app.set_version_flag("--version", std::string("candela ") + CANDELA_VERSION);
    app.footer(
        "Exit status: 0 all went well; 1 something was wrong and has been reported, the rest "
        "was rendered; 2 the command line cannot be understood.\n"
        "See also: candela compile --help, candela diff --help");
    app.get_formatter()->column_width(34);

    int status = 0;
    candela::addRender(app, status);
    candela::addDiff(app, status);
    candela::addCompile(app, status);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError &error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    return status;
}

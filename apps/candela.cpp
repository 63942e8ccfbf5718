// SPDX-License-Identifier: Apache-2.0
// The command line: `candela scene.rib` renders, verbs do the rest.
#include "apps/command_line_facts.h"
#include "apps/verbs.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

/// The exit status if what was written to standard output has got there; else `lost`, or what is
/// worse.
static int afterOutput(int status, int lost) {
    errno = 0;
    if (std::fflush(stdout) == 0 && !std::ferror(stdout))
        return status;
    // An error of earlier has left no reason.
    std::fprintf(stderr, "candela: error: cannot write to standard output%s%s\n", errno ? ": " : "",
                 errno ? std::strerror(errno) : "");
    return status ? status : lost;
}

/// `candela help VERB` is `candela VERB --help`.
static std::vector<std::string> argumentsOf(int argc, char **argv, const CLI::App &app) {
    std::vector<std::string> arguments(argv + 1, argv + argc);
    const std::vector<const CLI::App *> verbs = candela::verbsOf(app);
    if (arguments.size() == 2 && arguments[0] == "help" &&
        std::ranges::find(verbs, arguments[1], &CLI::App::get_name) != verbs.end())
        arguments = {arguments[1], "--help"};
    return arguments;
}

int main(int argc, char **argv) {
    CLI::App app{"Candela: a physically based renderer compatible with the RenderMan Interface."};
    app.set_version_flag("--version", std::string("candela ") + CANDELA_VERSION);
    app.footer(
        "Exit status: 0 all went well; 1 something was wrong and has been reported, the rest "
        "was rendered; 2 the command line cannot be understood.\n"
        "See also: candela compile --help, candela info --help, candela run --help, candela view "
        "--help, candela diff --help, candela merge --help, candela filter --help, candela tex "
        "--help, candela probe --help, candela cat --help. candela help WORD tells of requests, "
        "options, functions and shaders.");
    app.get_formatter()->column_width(34);

    // Beyond RLIMIT_FSIZE writing just fails, as on a full disk.
    std::signal(SIGXFSZ, SIG_IGN);
    int status = 0;
    candela::addRender(app, status);
    candela::addView(app, status);
    candela::addDiff(app, status);
    candela::addMerge(app, status);
    candela::addFilter(app, status);
    candela::addCompile(app, status);
    candela::addInfo(app, status);
    candela::addRun(app, status);
    candela::addTex(app, status);
    candela::addProbe(app, status);
    candela::addCat(app, status);
    candela::addHelp(app, status);
    try {
        std::vector<std::string> arguments = argumentsOf(argc, argv, app);
        std::ranges::reverse(arguments); // As CLI11 wants them.
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError &error) {
        return afterOutput(app.exit(error) == 0 ? 0 : 2, 1);
    }
    // To diff, 1 means that pictures differ.
    return afterOutput(status, app.got_subcommand("diff") ? 2 : 1);
}

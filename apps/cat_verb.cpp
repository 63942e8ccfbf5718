// SPDX-License-Identifier: Apache-2.0
#include "apps/verbs.h"

#include "interface/rib/rib_stream.h"
#include "interface/rib/rib_writer.h"
#include "render/console.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> files{"-"};
    std::string output = "-";
    bool ascii = false, binary = false, gzip = false;
};

int refuse(const std::string &problem, int status) {
    std::fprintf(stderr, "candela cat: error: %s\n", problem.c_str());
    return status;
}

bool isSameFile(const std::string &a, const std::string &b) {
    std::error_code error;
    return std::filesystem::equivalent(a, b, error) && !error;
}

int concatenate(const Arguments &a) {
    if (std::ranges::any_of(a.files, [&](const auto &file) { return isSameFile(file, a.output); }))
        return refuse(a.output + " would be overwritten while it is read; write another file", 2);
    std::string why;
    const auto packing = a.gzip ? ByteOutput::Packing::Gzip : ByteOutput::Packing::Plain;
    const auto output = ByteOutput::open(a.output, packing, why);
    if (!output)
        return refuse(a.output + " cannot be written: " + why, 1);
    Console console(Console::Words::Messages);
    {
        RibWriter writer(*output, a.binary ? RibEncoding::Binary : RibEncoding::Ascii);
        for (const std::string &file : a.files)
            readRibFile(file, writer, console);
    }
    if (const std::string failure = output->close(); !failure.empty())
        return refuse(a.output + " cannot be written: " + failure, 1);
    return console.failed() ? 1 : 0;
}

} // namespace

void addCat(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *cat = app.add_subcommand(
        "cat", "Write RIB as ASCII or binary RIB, packed or not: candela cat scene.rib --binary "
               "-o small.rib");
    cat->footer(
        "Reads any of them, several one after the other; archives that they name stay named. Every "
        "float comes back to the bit. Comments are kept; one in the midst of a request comes "
        "behind "
        "it. What is wrong in the RIB is reported and left out.\n"
        "Exit status: 0 all went well, 1 something was wrong and has been reported, 2 the command "
        "line cannot be understood.");
    cat->add_option("files", a.files, "RIB files; - or none: standard input");
    cat->add_option("-o,--output", a.output, "The file to be written; default: standard output");
    CLI::Option *ascii =
        cat->add_flag("--ascii", a.ascii, "ASCII RIB, a request a line; the default");
    cat->add_flag("--binary", a.binary, "Binary RIB (RI 3.2, appendix C.2)")->excludes(ascii);
    cat->add_flag("--gzip", a.gzip, "Packed by gzip; all that read RIB read it");
    cat->callback([arguments, &status] { status = concatenate(*arguments); });
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"
#include "apps/shared_options.h"
#include "apps/verbs.h"

#include "render/probe_file.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    ProbeFileSettings settings;
    std::string points, accuracy, plane, grid, integrator;
    int samples = 0;
    TestingArguments testing;
    float offset = 0;
    bool radiance = false, csv = false, turned = false;
};

/// "1%" or "0.01"
std::optional<double> parseAccuracy(const std::string &text) {
    double value = 0;
    const char *end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, value);
    const bool percent = rest + 1 == end && *rest == '%';
    value *= percent ? 0.01 : 1;
    const bool good = error == std::errc() && (rest == end || percent) && value > 0 && value < 1;
    return good ? std::optional(value) : std::nullopt;
}

/// "20x30"
bool parseGrid(const std::string &text, WorkPlane &plane) {
    constexpr int most = 8192;
    char end = 0;
    return std::sscanf(text.c_str(), "%dx%d%c", &plane.columns, &plane.rows, &end) == 2 &&
           plane.columns > 0 && plane.columns <= most && plane.rows > 0 && plane.rows <= most;
}

/// Nine numbers between commas: corner, u, v.
bool parsePlane(const std::string &text, WorkPlane &plane) {
    const char *at = text.data(), *end = at + text.size();
    for (int k = 0; k < 9; ++k) {
        double &value = (k < 3 ? plane.corner : k < 6 ? plane.u : plane.v)[std::size_t(k % 3)];
        const auto [rest, error] = std::from_chars(at, end, value);
        if (error != std::errc() || (k < 8 ? rest == end || *rest != ',' : rest != end))
            return false;
        at = rest + (k < 8);
    }
    return true;
}

/// What is wrong with the grid of a plane; empty if nothing is, and the settings have it.
std::string takePlane(Arguments &a) {
    ProbeFileSettings &s = a.settings;
    if (a.plane.empty())
        return !a.grid.empty() || a.turned || !s.output.empty() || !s.falsecolor.empty()
                   ? "--grid, --turned, -o and -f belong to --plane"
                   : "";
    WorkPlane plane;
    plane.turned = a.turned;
    if (!parsePlane(a.plane, plane))
        return "--plane: expected nine numbers, corner, u and v: X,Y,Z,UX,UY,UZ,VX,VY,VZ";
    if (!plane.flaw().empty())
        return "--plane: " + plane.flaw();
    if (!parseGrid(a.grid, plane))
        return "--grid: expected COLUMNSxROWS, each from 1 to 8192, not '" + a.grid + "'";
    if (!a.points.empty())
        return "a file of points and --plane exclude each other";
    s.plane = plane;
    return "";
}

/// What is wrong; empty if nothing is, and the settings are complete.
std::string take(Arguments &a, bool hasOffset) {
    ProbeFileSettings &s = a.settings;
    if (!a.accuracy.empty() && !(s.probe.accuracy = parseAccuracy(a.accuracy)))
        return "--until: expected a part of the value, 1% or 0.01, not '" + a.accuracy + "'";
    constexpr int usual = 256, usualLimit = 1 << 18;
    s.probe.samples = a.samples > 0 ? a.samples : s.probe.accuracy ? usualLimit : usual;
    s.probe.quantity = a.radiance ? ProbeQuantity::Radiance : ProbeQuantity::Irradiance;
    if (hasOffset)
        s.probe.offset = a.offset;
    if (!a.points.empty())
        s.points = a.points;
    if (s.scene == "-" && s.points == "-" && a.plane.empty())
        return "scene and points cannot both come from standard input: give a file of points";
    s.format = a.csv ? AnswerFormat::Csv : AnswerFormat::Plain;
    if (!a.integrator.empty())
        s.render.integrator = a.integrator;
    a.testing.apply(s.render);
    return takePlane(a);
}

void addQuestion(CLI::App &probe, Arguments &a) {
    ProbeFileSettings &s = a.settings;
    probe.add_option("scene", s.scene, "RIB file; - reads standard input")->required();
    probe.add_option("points", a.points,
                     "File of points, x y z dx dy dz a line (or CSV); - or nothing reads standard "
                     "input");
    auto *radiance =
        probe.add_flag("--radiance", a.radiance,
                       "The radiance that comes to x y z against the ray along dx dy dz");
    probe
        .add_flag_function(
            "-I,--irradiance", [](std::int64_t) {},
            "The irradiance of a plane at x y z that faces along dx dy dz: what is asked "
            "without --radiance")
        ->excludes(radiance);
    probe.add_option("--until", a.accuracy,
                     "Take samples until the half width of the 95 % interval is this part of the "
                     "value: 1% or 0.01");
    probe
        .add_option("--spp", a.samples,
                    "Samples a point, or the most with --until; default 256, or 262144")
        ->check(CLI::Range(1, 1 << 30));
    probe
        .add_option("--offset", a.offset,
                    "Metres by which sensors stand off their points; default: as far as rounding "
                    "needs")
        ->check(CLI::Range(0.0f, 1e6f));
    probe.add_flag("--csv", a.csv, "Answer by CSV with a row of names: points, directions, values");
    probe.add_option("--plane", a.plane,
                     "X,Y,Z,UX,UY,UZ,VX,VY,VZ: a grid of points over the corner and edges of a "
                     "plane, facing along u x v");
    probe.add_option("--grid", a.grid, "COLUMNSxROWS of that grid: along u, along v");
    probe.add_flag("--turned", a.turned, "Its sensors face the other way");
    probe.add_option("-o,--output", s.output,
                     "A picture of the grid in place of a table: .png in false colours with a "
                     "legend, else EXR");
    probe
        .add_option("-f,--falsecolor", s.falsecolor,
                    "Parameters of the filter falsecolor: scale=500 log=1 palette=heat")
        ->type_name("NAME=VALUE");
}

void addScene(CLI::App &probe, Arguments &a) {
    RenderSettings &r = a.settings.render;
    probe
        .add_option("--integrator", a.integrator,
                    "path, bidir, vcm, radiosity or classic; default: as the RIB has it")
        ->check(CLI::IsMember({"path", "bidir", "vcm", "radiosity", "classic"}));
    addSolutionFiles(probe, r);
    probe.add_option("--threads", r.threads, "Threads; default: all cores")
        ->check(CLI::Range(1, 1024));
    probe.add_option("--seed", r.seed, "Seed of all random choices; default 0");
    addSearchPaths(probe, r);
    probe.add_flag("--quiet", r.quiet, "No progress, only messages");
    addTestingOptions(probe, a.testing, r);
}

int run(Arguments &a, bool hasOffset) {
    const std::string flaw = take(a, hasOffset);
    if (flaw.empty())
        return probeFile(a.settings);
    std::fprintf(stderr, "candela probe: %s\nRun with --help for more information.\n",
                 flaw.c_str());
    return 2;
}

} // namespace

void addProbe(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    CLI::App *probe = app.add_subcommand(
        "probe", "Measure light in a scene: irradiance and radiance at points, in W and in lx and "
                 "cd/m^2, or over the grid of a work plane");
    probe->footer(
        "Answers come a line each, in the order of the points: R G B (W/m^2, or W/m^2/sr), their "
        "mean, lx (cd/m^2), half the width of its 95 % interval, samples (0 where a solution of "
        "radiosity has told all). A line that is no point "
        "is answered by nan. Points are in world space.\n"
        "Example: echo 5 0 3 0 1 0 | candela probe --until 1% room.rib\n"
        "Exit status: 0 all went well, 1 something was wrong and has been reported, the rest was "
        "answered, 2 the command line cannot be understood.");
    addQuestion(*probe, *arguments);
    addScene(*probe, *arguments);
    probe->callback([arguments, probe, &status] {
        status = instructionSetIsAsAsked(arguments->testing.cpu)
                     ? run(*arguments, probe->count("--offset") > 0)
                     : 2;
    });
}

} // namespace candela

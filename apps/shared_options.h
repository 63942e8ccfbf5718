// SPDX-License-Identifier: Apache-2.0
// Options that verbs which read scenes have in common.
#pragma once

#include "foundation/base/planes.h"
#include "render/render.h"

#include <CLI/CLI.hpp>
#include <string>

namespace candela {

/// --lanes, --cpu, --sampling and --stats as they were given.
struct TestingArguments {
    int lanes = laneBlock;
    std::string cpu, sampling = "cones";

    void apply(RenderSettings &) const;
};
void addTestingOptions(CLI::App &, TestingArguments &, RenderSettings &);

/// --shader-path, --archive-path, --texture-path.
void addSearchPaths(CLI::App &, RenderSettings &);

/// --solution, --solution-mesh.
void addSolutionFiles(CLI::App &, RenderSettings &);

} // namespace candela

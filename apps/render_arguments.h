// SPDX-License-Identifier: Apache-2.0
// The options of verbs that render scenes.
#pragma once

#include "apps/shared_options.h"

#include <string>
#include <vector>

namespace candela {

struct RenderArguments {
    RenderSettings settings;
    std::vector<std::string> files;
    std::string format, crop, integrator, frames, checkpoint;
    int samples = 0;
    TestingArguments testing;

    /// All but the files. It must live as long as the App.
    void addTo(CLI::App &);
    /// The settings as they have been given. False if the program cannot do so, which it has said.
    bool apply();
};

} // namespace candela

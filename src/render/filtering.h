// SPDX-License-Identifier: Apache-2.0
// A stack of filters at work for the user: progress, Ctrl-C, and what files say of it.
#pragma once

#include "image/filter/filter_stack.h"
#include "render/console.h"

namespace candela {

struct FilteringOutcome {
    int done = 0;             ///< So many filters have run to their ends, from the first on.
    bool interrupted = false; ///< By Ctrl-C.
};
/// Runs the stack over the maps, which hold "Ci".
FilteringOutcome runFilters(const FilterStack &, ImageMaps &, Console &, DiagnosticSink &);

/// The maps that a stack reads or sets, each once.
std::vector<std::string> mapNames(const FilterStack &);

/// The first `count` filters as files name them: "ward94 L_dmax=80; bloom", with the parameters
/// that were given.
std::string textOf(const std::vector<ShaderRecord> &filters, int count);

} // namespace candela

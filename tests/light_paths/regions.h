// SPDX-License-Identifier: Apache-2.0
// How integrators are compared in these worlds: pictures over seeds, region by region.
#pragma once

#include "tests/light_paths/worlds.h"

#include <string>
#include <vector>

namespace candela::test {

/// Metres a unit of the world.
double scaleOf(const World &);

/// The options under which an integrator sees the world.
std::string viewOf(const World &, const std::string &integrator);

/// values[region][seed], of red and behind them of green.
using Regions = std::vector<std::vector<double>>;

struct RegionSettings {
    int regions = 5; ///< Each way; a divisor of 20, the pixels of the view.
    int seeds = 4, samples = 64;
    bool mayWarn = false;
};
/// Empty if a run fails.
Regions renderRegions(const World &, const std::string &options, const RegionSettings &);

} // namespace candela::test

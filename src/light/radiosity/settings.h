// SPDX-License-Identifier: Apache-2.0
// What the solver is told, and what it tells besides the solution.
#pragma once

#include <cstddef>
#include <cstdint>

namespace candela::radiosity {

struct SolverSettings {
    int order = 2; ///< Basis.
    /// The error of a link's irradiance times area, in shares of the flux that is exchanged.
    double epsilon = 1e-5;
    /// Irradiance that a link may get wrong at some point, in shares of what there is on average,
    /// before points ask for it themselves.
    double contrast = 1.5e-3;
    double leastElement = 1e-6; ///< The smallest element, in shares of all area.
    /// Elements that something stands on are made smaller than that.
    double cutElement = 2e-5;
    int directSamples = 64; ///< Of light sources, at each node.
    std::uint32_t seed = 0;
    int mostIterations = 100;
    std::size_t mostElements = 2'000'000, mostLinks = 20'000'000;
};

struct SolverStatistics {
    std::size_t elements = 0, links = 0;
    std::size_t clusterLinks = 0;
    std::size_t lampLinks = 0; ///< Of surfaces that shine; used once.
    int iterations = 0;
    double residual = 0; ///< Of exitance, in shares of it.
    double seconds = 0;
    double directFlux = 0, indirectFlux = 0; ///< That surfaces receive, W.
};

} // namespace candela::radiosity

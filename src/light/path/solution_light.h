// SPDX-License-Identifier: Apache-2.0
// Paths in scenes that have been solved: the light that vertices take from the solution, and where
// paths end on it.
#pragma once

#include "light/path/wave.h"
#include "light/radiosity/solution.h"

namespace candela {

struct SolutionLight {
    explicit SolutionLight(int capacity);

    /// Irradiance that the vertices take from the solution, on their side and behind.
    Planes<float> irradiance, behind;
    Planes<float> indirect; ///< The part of it that is not of light sources.
    std::array<const float *, colorSamples> table{}; ///< The first, as shaders are given it.
    Planes<float> ends;     ///< 1 where the path's finite lobes end on the solution; else 0.
    Planes<float> followed; ///< Importance of those that do not.
    Planes<float> direction, pdf, response;
    Planes<std::int32_t> answered;
};

/// The importance of finite lobes, by vertex, along which directions are followed.
const float *followedTotal(const PathWave &);
/// wanted[i] = 0 where light sources have been asked by the solution.
void leaveToSolution(const PathWave &, float *wanted);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The denoising filters in double precision, pixel by pixel and as their pages have them.
#pragma once

#include "tests/filter_library/support/noisy_scene.h"

namespace candela::filters {

struct MeansSettings {
    int search = 7, patch = 2;
    double tolerance = .45, bend = .3, shade = .05;
};
Picture nonLocalMeans(const NoisyScene &, const MeansSettings & = {});

struct RegressionSettings {
    int search = 5, patch = 2;
    double tolerance = .35;
    int radius = 7;
    double fitTolerance = .3, contrast = .12, bend = .3;
};
Picture regression(const NoisyScene &, const RegressionSettings & = {});

struct PreservingSettings {
    bool byVariance = true;
    double steps = 8, levels = 128, fraction = .01, radius = 8;
};
Picture energyPreserving(const NoisyScene &, const PreservingSettings & = {});

} // namespace candela::filters

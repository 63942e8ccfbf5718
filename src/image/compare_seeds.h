// SPDX-License-Identifier: Apache-2.0
// Do two integrators have the same mean? Pictures of independent seeds say so, region by region.
// Samples of one picture are stratified and tell nothing of its error; pictures of other seeds do.
#pragma once

#include "image/picture.h"

#include <span>
#include <string>
#include <vector>

namespace candela {

struct SeedSettings {
    int regionSize = 16; ///< Pixels; the last column and row of regions may be smaller.
    std::vector<std::string> channels; ///< Empty: the luminance of R, G and B.
};

/// The means over the pixels of a region, over seeds.
struct RegionScore {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0; ///< Absolute pixels of the frame, [x0, x1) x [y0, y1).
    double meanA = 0, meanB = 0;
    double errorA = 0, errorB = 0; ///< Standard errors; 0 for a single picture.
    /// By how many standard deviations of a normal distribution a is above b: Welch's t, and the
    /// normal deviate that is as improbable as it.
    double z = 0;
    double probability = 1; ///< Of so large a |z| by chance.
};

struct ChannelScores {
    std::string name;
    std::vector<RegionScore> regions; ///< Row by row.
    RegionScore whole;                ///< All pixels as one region.
    int columns = 0;
    int worst = 0;          ///< Of the regions.
    double familyWise = 1;  ///< The worst one's probability, times the number of regions.
    double meanSquareZ = 0; ///< 1 if chance alone is at work.
};

struct SeedComparison {
    std::string problem; ///< Why nothing could be compared; empty if it could.
    std::vector<ChannelScores> channels;
    bool referenceIsExact = false; ///< b is one picture, taken to have no error.
};

/// At least two pictures a, and one or several b, all of one window. Values that are not finite
/// count as 0.
SeedComparison compareSeeds(std::span<const Picture> a, std::span<const Picture> b,
                            const SeedSettings & = {});

/// The level at which a difference counts: probability per channel, over regions and the whole.
inline constexpr double seedSignificance = 1e-3;

/// 0 the same as far as the seeds tell, 1 different, 2 not comparable.
int exitCodeOf(const SeedComparison &);
std::string reportOf(const SeedComparison &);

} // namespace candela

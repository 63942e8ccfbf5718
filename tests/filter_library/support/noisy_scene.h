// SPDX-License-Identifier: Apache-2.0
// Small pictures for the tests of what denoises: a textured wall and floor under a soft shadow,
// with noise, and all that the film knows of them.
#pragma once

#include "image/filter/image_maps.h"
#include "tests/filter_library/support/picture.h"

namespace candela::filters {

struct NoisyScene {
    Picture color, clean, variance, normal, albedo, id;

    ImageMaps maps() const;
    /// In place of what is there of another picture.
    void putInto(ImageMaps &) const;
};

/// Each pixel's mean of `samples` samples, the same in each run.
NoisyScene noisyScene(int width, int height, int samples = 16);
/// What a mirror to the left of it shows.
NoisyScene mirrored(const NoisyScene &);
Picture mirrored(const Picture &);

/// The mean over channels of the squared difference.
double squaredError(const Picture &, const Picture &);

} // namespace candela::filters

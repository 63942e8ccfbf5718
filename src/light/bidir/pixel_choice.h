// SPDX-License-Identifier: Apache-2.0
// Which pixel gets a splat: by chance, as the pixel filter has its worth there for each pixel in
// reach.
#pragma once

#include "world/camera/pixel_filter.h"

namespace candela {

struct SplatPlace {
    float x = 0, y = 0; ///< The middle of the pixel.
    float weight = 0;   ///< What all pixels in reach are worth together; 0 = there is none.
};

class PixelChoice {
public:
    explicit PixelChoice(const PixelFilterRecord &);
    /// For a raster position and a uniform number in [0,1).
    SplatPlace choose(float x, float y, float number) const;

private:
    /// The kernel at each pixel in reach of a place in a pixel, given to `body` by the pixel's
    /// column and row from there; their sum.
    template <class Body> double overPixels(double dx, double dy, Body body) const;

    PixelFilterRecord filter_;
    double perKernel_ = 1; ///< 1 over the kernel's integral.
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What each camera sample stands for of its pixel. Samples are stratified: each of N has a cell of
// the pixel filter to itself. What a texture shows over the whole cell, rather than around where
// the sample happens to lie in it, makes no noise: the cells of a pixel add up to what the filter
// sees.
#pragma once

#include "foundation/base/planes.h"
#include "world/camera/pixel_filter.h"
#include "world/rays/ray_batch.h"

#include <vector>

namespace candela {

/// The cells of one axis of the pixel filter: middle and width of the box that has the mean and the
/// variance of the filter there, in pixels.
struct FilterCells {
    std::vector<float> middle, width;
    /// Of the cell of a number in [0,1).
    int at(float number) const {
        const int cells = int(middle.size()), cell = int(number * float(cells));
        return cell < cells ? cell : cells - 1;
    }
};

class SampleShares {
public:
    explicit SampleShares(int capacity)
        : planes_(4, capacity), shares_{planes_[0], planes_[1], planes_[2], planes_[3]} {}

    /// The cells of N samples a pixel; none for filters with negative lobes.
    void prepare(const PixelFilterSampler &, int samples);
    bool areKnown() const { return !x_.middle.empty(); }
    /// Of ray i, whose pair of numbers the filter has sent to (dx, dy).
    void set(int i, float xNumber, float yNumber, float dx, float dy);
    const PixelShares *shares() const { return areKnown() ? &shares_ : nullptr; }

private:
    Planes<float> planes_;
    PixelShares shares_;
    FilterCells x_, y_;
};

} // namespace candela

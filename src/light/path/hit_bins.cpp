// SPDX-License-Identifier: Apache-2.0
#include "light/path/hit_bins.h"

#include "foundation/base/lanes.h"

#include <algorithm>

namespace candela {

namespace {
/// Up to here a pass for each bin, in vectors, is faster than counting lane by lane.
constexpr int fewBins = 16;
} // namespace

HitBins::HitBins(const Scene &scene, int capacity)
    : scene_(scene), bin_(capacity), order_(capacity + laneBlock), start_(scene.binCount() + 1) {}

void HitBins::sort(int count, const HitBatch &hits) {
    scene_.bins(count, hits, bin_.data());
    if (this->count() > fewBins)
        return sortByCounting(count);
    start_[0] = 0;
    for (int bin = 0; bin < this->count(); ++bin)
        start_[bin + 1] =
            start_[bin] + lanes::compactEqual(count, bin_.data(), bin, order_.data() + start_[bin]);
}

void HitBins::sortByCounting(int count) {
    std::fill(start_.begin(), start_.end(), 0);
    for (int i = 0; i < count; ++i)
        if (bin_[i] >= 0)
            ++start_[bin_[i] + 1];
    for (std::size_t bin = 1; bin < start_.size(); ++bin)
        start_[bin] += start_[bin - 1];
    next_ = start_;
    for (int i = 0; i < count; ++i)
        if (bin_[i] >= 0)
            order_[next_[bin_[i]]++] = i;
}

} // namespace candela

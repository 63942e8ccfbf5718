// SPDX-License-Identifier: Apache-2.0
// The rays of a wave by what is to be asked about where they lead: a surface shader each, lights
// apart, and those that escape.
#pragma once

#include "world/scene/scene.h"

#include <span>
#include <vector>

namespace candela {

class HitBins {
public:
    HitBins(const Scene &, int capacity);

    /// Takes the hits of `count` rays. Those that meet nothing are in Scene::escapedBin(), or left
    /// out if there is none.
    void sort(int count, const HitBatch &);
    int count() const { return int(start_.size()) - 1; }
    /// The rays of a bin, in increasing order.
    std::span<const int> rays(int bin) const {
        return {order_.data() + start_[bin], order_.data() + start_[bin + 1]};
    }

private:
    void sortByCounting(int count);

    const Scene &scene_;
    std::vector<int> bin_, order_;
    std::vector<int> start_, next_; ///< In order_.
};

} // namespace candela

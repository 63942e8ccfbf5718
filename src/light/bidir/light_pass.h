// SPDX-License-Identifier: Apache-2.0
// The light paths of a pass: all of them, on all threads, in waves of their numbers.
#pragma once

#include "light/bidir/eye_wave.h"
#include "light/bidir/light_wave.h"

#include <functional>
#include <memory>
#include <vector>

namespace candela {

class LightPass {
public:
    LightPass(FrameContext &, const BidirectionalPlan &, SampleSink &);

    /// Follows the light paths that belong to the samples [first, last) of all the frame's pixels;
    /// none that would begin after `isStopped`.
    void run(int first, int last, const std::function<bool()> &isStopped);
    const LightVertices &vertices() const { return vertices_; }
    /// How often each technique is tried with them.
    const TechniqueCounts &counts() const { return counts_; }

private:
    FrameContext &frame_;
    BidirectionalPlan plan_;
    TechniqueCounts counts_;
    SampleSink &sink_;
    LightVertices vertices_;
    std::vector<std::unique_ptr<LightWave>> waves_; ///< One a thread.
};

} // namespace candela

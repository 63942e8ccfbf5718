// SPDX-License-Identifier: Apache-2.0
#include "light/frame/frame_progress.h"

namespace candela {

void FrameProgress::close() {
    std::unique_lock lock(mutex_);
    stopped_ = isClosed_ = true;
}

void FrameProgress::beginPass(int firstSample, std::size_t tiles) {
    std::unique_lock lock(mutex_);
    if (firstSample != position_.firstSample || tiles != position_.tilesTaken.size())
        position_ = {firstSample, false, std::vector<std::uint8_t>(tiles),
                     std::move(position_.wishes)};
}

void FrameProgress::beginLightPaths() {
    std::unique_lock lock(mutex_);
    lightPathsComing_ = true;
}

void FrameProgress::endLightPaths() {
    std::unique_lock lock(mutex_);
    lightPathsComing_ = false;
    position_.hasLightPaths = true;
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Channels that are read off the first surface a camera ray meets.
#pragma once

#include "language/runtime/shader_abi.h"
#include "world/scene/sample_sink.h"

#include <span>
#include <vector>

namespace candela {

/// One plane of a channel: an input of shaders, the number of the placed shape (from 1), or a
/// sample of the albedo.
struct FirstHitPlane {
    int input = -1; ///< ShaderInput, -1 = not an input.
    bool id = false;
    float background = 0; ///< Where nothing is hit.
    int albedo = -1;      ///< Which of its colour samples (path/albedo.h), -1 = not that.
    bool depth = false;   ///< From the camera at the path's time.
};

/// The planes of all channels after Ci and Oi, in their order. Channels of unknown name stay 0.
std::vector<FirstHitPlane> firstHitPlanes(std::span<const ChannelInfo>);
/// All channels that a first hit has to give.
std::vector<ChannelInfo> firstHitChannels();

} // namespace candela

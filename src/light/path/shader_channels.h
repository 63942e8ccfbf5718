// SPDX-License-Identifier: Apache-2.0
// Channels that shaders make: their output parameters, where displays want to see them.
#pragma once

#include "world/scene/sample_sink.h"
#include "world/scene/scene.h"

#include <map>
#include <span>
#include <vector>

namespace candela {

/// A plane of a channel, and which of a shader's outputs it shows.
struct ShaderChannelPlane {
    int plane;  ///< Of PathResults::channels.
    int output; ///< Of ir::Question::Outputs.
    int sample; ///< Of a colour; -1 = it is no colour.
};

/// Of each surface shader and volume of the scene, the channels of the frame that it has something
/// for.
class ShaderChannels {
public:
    /// `channels` as SampleSink has them. Channels that shaders do not have, or have of another
    /// type, stay 0.
    ShaderChannels(const Scene &, std::span<const ChannelInfo> channels);

    bool empty() const { return empty_; }
    const std::vector<ShaderChannelPlane> &of(int code) const { return codes_[code].planes; }
    /// The same of a volume shader; null = nothing.
    const std::vector<ShaderChannelPlane> *ofVolume(const ShaderCode &code) const {
        const auto found = volumes_.find(&code);
        return found == volumes_.end() ? nullptr : &found->second;
    }
    /// Light has a part in what the shader leaves in its output parameters.
    bool needLight(int code) const { return codes_[code].needLight; }

private:
    struct Code {
        std::vector<ShaderChannelPlane> planes;
        bool needLight = false;
    };
    std::vector<Code> codes_;
    std::map<const ShaderCode *, std::vector<ShaderChannelPlane>> volumes_;
    bool empty_ = true;
};

/// The output parameters of all surface shaders and volumes of the scene, but for strings: of those
/// that share a name, the first one.
std::vector<ChannelInfo> outputParametersOf(const Scene &);

} // namespace candela

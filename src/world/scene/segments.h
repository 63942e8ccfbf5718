// SPDX-License-Identifier: Apache-2.0
// Asking volume shaders what they make of segments of rays.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color.h"
#include "language/runtime/shader_abi.h"
#include "world/scene/scene.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// Room for up to `capacity` segments and what their volumes say of them. Radiance Ci and opacity
/// Oi at a segment's end become, at its beginning, channel by channel
///
///     CiOfCi Ci + CiOfOi Oi + (own) Ci        OiOfOi Oi + (own) Oi
///
/// A shader that is not affine in them is taken for the straight line through what it makes of
/// black and of 1 (docs/flow.md).
class Segments {
public:
    explicit Segments(int capacity);

    int count = 0;
    std::int32_t *medium; ///< By its number; 0 = clear.
    float *input(ShaderInput which, int component = 0) const {
        return inputs_[int(which) + component];
    }

    /// The answer to ambient(); null = black.
    const float *const *ambient = nullptr;

    /// The segments end at these points of surfaces: of the inputs I and seed are to be filled, all
    /// others are the points'.
    void endAt(const ShadingPoints &, const float *objectMatrices);
    /// They end anywhere: P, I, time and seed are to be filled; all other inputs are zero.
    void endAnywhere(const float *objectMatrices);

    /// The segments in volumes of one code, as ShaderArgs::active has them.
    struct Group {
        const ShaderCode *code;
        std::vector<std::uint16_t> active;
    };
    /// Clears the answers; by code, all segments in volumes.
    std::vector<Group> begin(const Scene &);
    /// All that a group makes of its segments. `lights` answers its light loops; null = it is dark.
    void ask(const Group &, VolumeLights *lights, bool prints);
    /// CiOfCi alone, in the dark and without a word.
    void askTransmission(const Group &);

    struct Answers {
        std::array<float *, colorSamples> Ci, Oi, CiOfCi, CiOfOi, OiOfOi;
    };
    const Answers &answers() const { return answers_; }
    /// What was asked last of a group, planes of Function::outputs: its own output parameters among
    /// them, as they are for a black and clear end.
    std::span<float *const> outputs() const { return outputs_; }
    /// Which question that is.
    static ir::Question askedOf(const ShaderCode &code) {
        return code.volumeFacts().affine ? ir::Question::Segment : ir::Question::Volume;
    }

private:
    using Colors = std::array<float *, colorSamples>;
    Colors colors(int first) const;
    void give(ShaderInput, float);
    /// Room for all outputs of the function.
    void placeParameters(const ir::Function &);
    void run(const Group &, ir::Question, VolumeLights *, bool prints);
    /// Question::Volume of this Ci and Oi; what it says is in Ci_ and Oi_.
    void runWhole(const Group &, float Ci, float Oi, VolumeLights *, bool prints);
    void askWhole(const Group &, VolumeLights *, bool prints);

    Planes<float> inputs_, results_, parameters_;
    std::vector<float *> outputs_;
    std::vector<const float *> inputTable_;
    Planes<std::int32_t> integers_;
    MovingParameters moving_; ///< Of the group that is asked.
    Shutter shutter_;
    const std::int32_t *objectIndex_ = nullptr;
    const float *objectMatrices_ = nullptr;
    Answers answers_;
    Colors Ci_, Oi_; ///< Of whole texts.
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// ShaderArgs as one lane of the interpreter sees them.
#pragma once

#include "language/ir/core/evaluate.h"
#include "language/ir/interpret/lane_values.h"
#include "language/runtime/shader_abi.h"

#include <bit>

namespace candela::ir {

/// What the caller gives and takes, as one lane sees it.
class LaneArguments {
public:
    LaneArguments(const ShaderArgs &args, const Function &function, int lane)
        : args_(args), function_(function), colorSamples_(function.colors.samples), lane_(lane) {
        const bool responds = function.lanes == BindingTime::Response;
        const bool isPoint = function.lanes == BindingTime::Surface;
        viewLane_ = responds && args.viewLane ? args.viewLane[lane] : lane;
        surfaceLane_ = !isPoint && args.surfaceLane ? args.surfaceLane[viewLane_] : viewLane_;
    }

    float input(int plane) const {
        return args_.inputs[plane][laneOf(bindingTimeOf(ShaderInput(plane)))];
    }
    float parameter(int slot) const {
        return args_.parameters[args_.parameterOffset[surfaceLane_] + slot];
    }
    float variable(int plane) const { return args_.variables[plane][surfaceLane_]; }
    /// currentFromSpace and then spaceFromCurrent.
    const float *space(int index) const { return args_.spaces[index]; }
    const float *object() const {
        return args_.objectMatrices + 32 * args_.objectIndex[surfaceLane_];
    }
    float random(int site, float turn) const {
        return randomNumber(std::bit_cast<std::uint32_t>(input(int(ShaderInput::seed))), site,
                            turn);
    }

    bool hasAnswered(int request) const { return args_.answeredRequest[lane_] == request; }
    Color answer(int request) const { return colorOf(args_.answers, request); }
    Color ambient() const { return colorOf(args_.ambient, 0); }
    Color irradiance() const { return colorOf(args_.irradiance, 0); }
    /// Whether a category accepts the light of the lane's own sample.
    bool accepts(int category) const { return acceptsRow(category, lane_); }

    /// ShaderArgs::sampleLight of the lane's own sample.
    std::int32_t light() const { return lightOf(lane_); }

    struct LightSample {
        Vector L;
        Color Cl;
        std::int32_t light = 0;
    };
    /// The samples in order, of those lights that the category accepts.
    template <typename Visitor> void forEachSample(int category, Visitor visit) const {
        for (int s = 0; s < args_.sampleCount; ++s) {
            std::size_t row = std::size_t(s) * args_.sampleStride + lane_;
            if (!acceptsRow(category, row))
                continue;
            LightSample sample{};
            for (int k = 0; k < 3; ++k)
                sample.L[k] = args_.sampleL[k][row];
            for (int k = 0; k < colorSamples_; ++k)
                sample.Cl[k] = args_.sampleCl[k][row];
            sample.light = lightOf(row);
            visit(sample);
        }
    }

    float load(int slot) const { return frame(slot, laneOf(spillSlot(function_, slot).frame)); }
    void save(int slot, float value) const { frame(slot, lane_) = value; }
    float &output(int slot) const { return args_.outputs[slot][lane_]; }
    const ShaderCallbacks *callbacks() const { return args_.callbacks; }
    const ShaderArgs &all() const { return args_; }
    int lane() const { return lane_; }

private:
    int laneOf(BindingTime time) const {
        return time == BindingTime::Surface ? surfaceLane_
               : time == BindingTime::View  ? viewLane_
                                            : lane_;
    }
    float &frame(int number, int lane) const {
        const SpillSlot at = spillSlot(function_, number);
        float *memory = at.frame == BindingTime::View ? args_.viewFrame : args_.surfaceFrame;
        return memory[frameIndex(lane, at.slot, at.slots)];
    }
    std::int32_t lightOf(std::size_t row) const {
        return args_.sampleLight ? args_.sampleLight[row] : 0;
    }
    /// Black where the caller gave none.
    Color colorOf(const float *const *planes, int index) const {
        Color color{};
        for (int k = 0; planes && k < colorSamples_; ++k)
            color[k] = planes[index * colorSamples_ + k][lane_];
        return color;
    }
    bool acceptsRow(int category, std::size_t row) const {
        if (category < 0 || !args_.categoryAccepts)
            return true;
        int light = args_.sampleLight ? args_.sampleLight[row] : 0;
        return args_.categoryAccepts[category * (args_.lightCount + 1) + light] != 0;
    }

    const ShaderArgs &args_;
    const Function &function_;
    int colorSamples_, lane_, viewLane_, surfaceLane_;
};

} // namespace candela::ir

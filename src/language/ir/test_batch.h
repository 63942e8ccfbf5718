// SPDX-License-Identifier: Apache-2.0
// For tests: memory for a batch of points, filled reproducibly, and the ShaderArgs on it.
#pragma once

#include "foundation/units/color.h"
#include "language/ir/ir.h"
#include "language/runtime/shader_abi.h"

#include <array>
#include <bit>
#include <random>
#include <vector>

namespace candela::ir {

class TestBatch {
public:
    using Plane = std::vector<float>;

    TestBatch(const Function &function, int count, unsigned seed) : count(count) {
        std::mt19937 bits(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        auto fill = [&](std::vector<Plane> &planes, std::size_t howMany) {
            planes.assign(howMany, Plane(padded()));
            for (Plane &plane : planes)
                for (float &x : plane)
                    x = number(bits);
        };
        fill(inputs, std::size_t(ShaderInput::Count));
        for (float &x : inputs[int(ShaderInput::seed)])
            x = std::bit_cast<float>(std::uint32_t(bits() & 0x7f7fffffu));
        fill(answers, function.requests.size() * colorSamples);
        fill(ambient, colorSamples);
        fill(irradiance, colorSamples);
        fill(variables, function.variables.size());
        parameters.resize(function.parameters.size() * padded());
        for (float &x : parameters)
            x = number(bits);
        for (int i = 0; i < padded(); ++i)
            parameterOffset.push_back(i * int(function.parameters.size()));
        for (std::size_t i = 0; i < function.spaces.size(); ++i)
            spaces.push_back(matrices(bits));
        objects = matrices(bits);
        objectIndex.assign(padded(), 0);
        answered.assign(padded(), finiteRequests);
    }

    int padded() const { return (count + laneBlock - 1) / laneBlock * laneBlock; }

    /// `rows` light samples a point: rows of L and Cl.
    void setSamples(int rows, unsigned seed) {
        std::mt19937 bits(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        sampleCount = rows;
        for (Plane &plane : sampleL) {
            plane.resize(std::size_t(rows) * padded());
            for (float &x : plane)
                x = number(bits);
        }
        for (Plane &plane : sampleCl) {
            plane.resize(std::size_t(rows) * padded());
            for (float &x : plane)
                x = number(bits) + 1.5f;
        }
    }

    /// Runs a function on fresh outputs, all `clear` before; gives the output planes.
    template <typename Run>
    std::vector<Plane> run(const Function &function, Run &&runner, float clear = 0) {
        std::vector<Plane> outputs(function.outputs.size(), Plane(padded(), clear));
        if (std::size_t needed = std::size_t(function.frameSlots) * padded(); frame.size() < needed)
            frame.resize(needed); // Never shrinks: what one question saved, another loads.
        ShaderArgs args;
        args.count = count;
        args.active = active.empty() ? nullptr : active.data();
        auto inputPointers = pointers(inputs), answerPointers = pointers(answers);
        auto ambientPointers = pointers(ambient), irradiancePointers = pointers(irradiance);
        auto variablePointers = pointers(variables), spacePointers = pointers(spaces);
        auto LPointers = pointers(sampleL), ClPointers = pointers(sampleCl);
        auto outputPointers = pointers(outputs);
        args.inputs = inputPointers.data();
        args.parameters = parameters.data();
        args.parameterOffset = parameterOffset.data();
        args.variables = variablePointers.data();
        args.spaces = spacePointers.data();
        args.objectMatrices = objects.data();
        args.objectIndex = objectIndex.data();
        args.frame = frame.data();
        args.outputs = outputPointers.data();
        args.sampleCount = sampleCount;
        args.sampleStride = padded();
        args.sampleL = LPointers.data();
        args.sampleCl = ClPointers.data();
        args.sampleLight = sampleLight.empty() ? nullptr : sampleLight.data();
        args.categoryAccepts = categoryAccepts.empty() ? nullptr : categoryAccepts.data();
        args.lightCount = lightCount;
        args.answeredRequest = answered.data();
        args.answers = useAnswers ? answerPointers.data() : nullptr;
        args.ambient = useAmbient ? ambientPointers.data() : nullptr;
        args.irradiance = useAmbient ? irradiancePointers.data() : nullptr;
        args.callbacks = &callbacks;
        runner(function, args);
        return outputs;
    }

    int count;
    std::vector<Plane> inputs, answers, ambient, irradiance, variables, spaces;
    std::vector<float> parameters, objects;
    std::vector<std::int32_t> parameterOffset, objectIndex, answered, sampleLight;
    std::vector<std::uint16_t> active;
    std::vector<std::uint8_t> categoryAccepts;
    int lightCount = 0;
    int sampleCount = 0;
    std::array<Plane, 3> sampleL;
    std::array<Plane, colorSamples> sampleCl;
    Plane frame;
    bool useAnswers = false, useAmbient = false;
    ShaderCallbacks callbacks;

private:
    static Plane matrices(std::mt19937 &bits) {
        std::uniform_real_distribution<float> number(-1, 1);
        Plane result(32);
        for (float &x : result)
            x = number(bits);
        return result;
    }
    template <typename Planes> static auto pointers(Planes &planes) {
        std::vector<float *> result;
        for (auto &plane : planes)
            result.push_back(plane.data());
        return result;
    }
};

} // namespace candela::ir

// SPDX-License-Identifier: Apache-2.0
// For tests: memory for a batch of points, filled reproducibly, and the ShaderArgs on it.
#pragma once

#include "foundation/units/color.h"
#include "language/ir/core/ir.h"
#include "language/ir/core/test_services.h"
#include "language/runtime/shader_abi.h"

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <vector>

namespace candela::ir {

/// A number a point, padded to whole blocks of lanes.
using TestPlane = std::vector<float>;

/// Samples of the colours of random functions: one in two has the usual three, the others 1, 4
/// or 8.
inline int colorSamplesOf(unsigned seed) {
    constexpr int choices[] = {3, 1, 3, 4, 3, 8};
    return choices[seed % 6];
}

/// Light samples: rows of all points.
struct TestSamples {
    int rows = 0;
    std::array<TestPlane, 3> L;
    std::vector<TestPlane> Cl;       ///< By colour sample.
    std::vector<std::int32_t> light; ///< That each is from; empty = indirect.
    /// As ShaderArgs has them; empty = all categories accept all lights.
    std::vector<std::uint8_t> categoryAccepts;
    int lightCount = 0;
};

/// The memory for values between questions. It never shrinks: what one question saved, another
/// loads.
struct TestFrames {
    TestPlane surface, view;

    /// Room for so many lanes, all `value`.
    void clear(const Function &function, int lanes, float value) {
        surface.assign(std::size_t(function.surfaceSlots * lanes), value);
        view.assign(std::size_t(function.viewSlots * lanes), value);
    }
    void grow(const Function &function, int lanes) {
        const auto fit = [&](TestPlane &frame, int slots) {
            if (std::size_t(slots * lanes) > frame.size())
                frame.resize(std::size_t(slots * lanes));
        };
        fit(surface, function.surfaceSlots);
        fit(view, function.viewSlots);
    }
};

/// What the requests other than light loops are answered.
struct TestAnswers {
    std::vector<TestPlane> traced, ambient, irradiance;
    bool givesTraced = false, givesAmbient = false; ///< Else they are black.
};

class TestBatch {
public:
    using Plane = TestPlane;

    TestBatch(const Function &function, int count, unsigned seed) : count(count) {
        samples.Cl.resize(std::size_t(function.colors.samples));
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
        fill(answers.traced, function.requests.size() * std::size_t(function.colors.samples));
        fill(answers.ambient, std::size_t(function.colors.samples));
        fill(answers.irradiance, std::size_t(function.colors.samples));
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
        answeredRequest.assign(padded(), finiteRequests);
    }

    int padded() const { return (count + laneBlock - 1) / laneBlock * laneBlock; }

    /// The same in all lanes.
    void setParameters(const std::vector<float> &values) {
        for (int i = 0; i < padded(); ++i)
            std::copy(values.begin(), values.end(), parameters.begin() + parameterOffset[i]);
    }

    /// `rows` light samples a point: rows of L and Cl.
    void setSamples(int rows, unsigned seed) {
        std::mt19937 bits(seed);
        std::uniform_real_distribution<float> number(-1, 1);
        samples.rows = rows;
        for (Plane &plane : samples.L) {
            plane.resize(std::size_t(rows) * padded());
            for (float &x : plane)
                x = number(bits);
        }
        for (Plane &plane : samples.Cl) {
            plane.resize(std::size_t(rows) * padded());
            for (float &x : plane)
                x = number(bits) + 1.5f;
        }
    }

    /// Runs a function on fresh outputs, all `clear` before; gives the output planes.
    template <typename Run>
    std::vector<Plane> run(const Function &function, Run &&runner, float clear = 0) {
        std::vector<Plane> outputs(function.outputs.size(), Plane(padded(), clear));
        frames.grow(function, padded());
        ShaderArgs args;
        args.count = count;
        args.active = active.empty() ? nullptr : active.data();
        auto inputPointers = pointers(inputs), variablePointers = pointers(variables);
        auto spacePointers = pointers(spaces), outputPointers = pointers(outputs);
        args.inputs = inputPointers.data();
        args.parameters = parameters.data();
        args.parameterOffset = parameterOffset.data();
        args.variables = variablePointers.data();
        args.spaces = spacePointers.data();
        args.objectMatrices = objects.data();
        args.objectIndex = objectIndex.data();
        args.surfaceFrame = frames.surface.data();
        args.viewFrame = frames.view.data();
        args.surfaceLane = surfaceLane.empty() ? nullptr : surfaceLane.data();
        args.viewLane = viewLane.empty() ? nullptr : viewLane.data();
        args.outputs = outputPointers.data();
        auto LPointers = pointers(samples.L), ClPointers = pointers(samples.Cl);
        args.sampleCount = samples.rows;
        args.sampleStride = padded();
        args.sampleL = LPointers.data();
        args.sampleCl = ClPointers.data();
        args.sampleLight = samples.light.empty() ? nullptr : samples.light.data();
        args.categoryAccepts =
            samples.categoryAccepts.empty() ? nullptr : samples.categoryAccepts.data();
        args.lightCount = samples.lightCount;
        auto tracedPointers = pointers(answers.traced), ambientPointers = pointers(answers.ambient);
        auto irradiancePointers = pointers(answers.irradiance);
        args.answeredRequest = answeredRequest.data();
        args.answers = answers.givesTraced ? tracedPointers.data() : nullptr;
        args.ambient = answers.givesAmbient ? ambientPointers.data() : nullptr;
        args.irradiance = answers.givesAmbient ? irradiancePointers.data() : nullptr;
        args.callbacks = &callbacks;
        args.services = &services;
        runner(function, args);
        return outputs;
    }

    int count;
    std::vector<Plane> inputs, variables, spaces;
    std::vector<float> parameters, objects;
    std::vector<std::int32_t> parameterOffset, objectIndex;
    std::vector<std::uint16_t> active; ///< Empty = all points are.
    TestSamples samples;
    TestAnswers answers;
    std::vector<std::int32_t> answeredRequest; ///< Of each point; finiteRequests at first.
    TestFrames frames;
    std::vector<std::int32_t> surfaceLane, viewLane; ///< Empty = the same lanes.
    ShaderCallbacks callbacks;
    ShaderServices services = testServices();

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

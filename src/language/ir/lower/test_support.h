// SPDX-License-Identifier: Apache-2.0
// For tests: Shading Language source in, what the interpreter makes of it out.
#pragma once

#include "foundation/base/vec3.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/lower/lower.h"
#include "language/semantics/front.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

/// A lowered shader and a batch of points for it, with random inputs; parameters at their defaults.
class ShaderRun {
public:
    using Plane = std::vector<float>;

    explicit ShaderRun(const std::string &source, int count = 21,
                       const std::vector<StringValue> &strings = {},
                       const std::vector<std::string> &variables = {},
                       const LoweringOptions &options = {}) {
        const auto front = sl::analyzeSource({"test.sl", source}, {}, diagnostics);
        if (front)
            lowered = lower(*front->shaders[0], strings, variables, diagnostics, options);
        if (!lowered)
            return;
        EXPECT_EQ(verify(lowered->whole), "") << print(lowered->whole);
        batch.emplace(lowered->whole, count, 7u);
        for (const ShaderParameter &parameter : lowered->parameters)
            if (parameter.computed)
                setParameter(givenName(parameter.name), {0});
        for (int lane = 0; lane < batch->padded(); ++lane)
            for (const ShaderParameter &parameter : lowered->parameters)
                if (parameter.firstSlot >= 0 && parameter.type != "string")
                    setParameter(parameter.name, lane, parameter.defaults);
    }

    void setParameter(const std::string &name, int lane, const std::vector<float> &value) {
        const int stride = int(lowered->whole.parameters.size());
        for (int slot = 0; slot < stride; ++slot)
            if (lowered->whole.parameters[slot].name == name)
                batch->parameters[lane * stride + slot] =
                    value[lowered->whole.parameters[slot].component];
    }
    void setParameter(const std::string &name, const std::vector<float> &value) {
        for (int lane = 0; lane < batch->padded(); ++lane)
            setParameter(name, lane, value);
    }
    void setInput(ShaderInput input, const std::vector<float> &value) {
        for (size_t c = 0; c < value.size(); ++c)
            batch->inputs[size_t(input) + c].assign(size_t(batch->padded()), value[c]);
    }
    /// Sets light samples, the same for all points: rows of L and Cl.
    struct Sample {
        Vec3 L;
        std::array<float, 3> Cl;
        int light = 0;
    };
    void setSamples(const std::vector<Sample> &samples) {
        const int padded = batch->padded();
        batch->setSamples(int(samples.size()), 1);
        batch->samples.light.assign(samples.size() * size_t(padded), 0);
        for (size_t row = 0; row < samples.size(); ++row)
            for (int lane = 0; lane < padded; ++lane) {
                const size_t at = row * size_t(padded) + size_t(lane);
                const float L[3] = {samples[row].L.x, samples[row].L.y, samples[row].L.z};
                for (size_t c = 0; c < 3; ++c)
                    batch->samples.L[c][at] = L[c];
                for (size_t c = 0; c < std::min<size_t>(3, batch->samples.Cl.size()); ++c)
                    batch->samples.Cl[c][at] = samples[row].Cl[c];
                batch->samples.light[at] = samples[row].light;
            }
    }

    /// Planes by "name" of an output, one a component.
    std::map<std::string, std::vector<Plane>> run() {
        const auto planes =
            batch->run(lowered->whole, [](const Function &function, const ShaderArgs &args) {
                interpret(function, args);
            });
        std::map<std::string, std::vector<Plane>> result;
        for (size_t i = 0; i < planes.size(); ++i)
            result[lowered->whole.outputs[i].name.text()].push_back(planes[i]);
        return result;
    }

    double input(ShaderInput plane, int lane, int component = 0) const {
        return batch->inputs[size_t(plane) + size_t(component)][size_t(lane)];
    }

    DiagnosticList diagnostics;
    std::optional<LoweredShader> lowered;
    std::optional<TestBatch> batch;
};

/// A surface shader whose output "result" the body sets.
inline std::string surfaceWith(const std::string &type, const std::string &body,
                               const std::string &before = "") {
    return before + "surface test(output varying " + type + " result = 0;) { " + body + " }";
}

/// The numbers that a body gives at each point.
inline std::vector<ShaderRun::Plane> evaluateBody(const std::string &type, const std::string &body,
                                                  const std::string &before = "") {
    ShaderRun run(surfaceWith(type, body, before));
    EXPECT_TRUE(run.lowered) << body << "\n" << run.diagnostics.text();
    return run.lowered ? run.run().at("result") : std::vector<ShaderRun::Plane>{};
}

} // namespace candela::ir

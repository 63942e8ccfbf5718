// SPDX-License-Identifier: Apache-2.0
// Writes a shader's text anew, under one or several assumptions about the light at once, keeping
// only some binding times. All questions are answered by it.
#pragma once

#include "language/ir/analyse/dependence.h"
#include "language/ir/transform/cone_values.h"
#include "language/ir/transform/value_mapping.h"

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace candela::ir {

/// A function with the whole's name and tables, but no code and no outputs.
Function emptyLike(const Function &whole);

/// What the light requests, ambient() and irradiance() answer.
struct Assumption {
    enum class Light {
        None,    ///< Nothing: loops don't run, answers are black.
        Given,   ///< As the caller gives it.
        Sampled, ///< Unit light as ShaderArgs::answeredRequest has it, from Input sampleL.
        Probed,  ///< A unit contribution through cone `probe` alone, without asking for light.
        Field,   ///< Radiance 1 from all directions (uniform_field.h); ambient() and irradiance()
                 ///< as `ambient` says, which the light rule has given loops of their own.
    };
    Light light = Light::None;
    bool ambient = false; ///< ambient() and irradiance() as given; else black.
    const Cone *probe = nullptr;
};

struct SpecializationOptions {
    BindingTime first = BindingTime::Surface, last = BindingTime::Response;
    /// Binding times are told apart: what is earlier than `first` comes from the frame or is
    /// recomputed if it costs at most `recomputeCost` operations. Otherwise all is written in
    /// place.
    bool framed = false;
    bool fused = false; ///< Surface and View count as one binding time.
    int recomputeCost = 1;
    bool prints = false; ///< Services with effects are asked.
    /// Loops of known count are unrolled where they hold light requests or are small.
    bool unrolls = false;
    /// Every instruction that asks for light gets a request of its own, in program order.
    bool renumbers = false;
    /// Values to save, with their slots. Without it loads number their slots by ValueId.
    const std::map<ValueId, int> *slots = nullptr;
    /// Cones to state in outputs, where the light loops stand.
    const std::vector<Cone> *cones = nullptr;
    /// What is known of loops' answers to light (Light::Field).
    const std::vector<Cone> *lobes = nullptr;
    /// Cone tests of classic loops, by request.
    const std::vector<ConeTest> *coneTests = nullptr;
};

/// What has been written, in terms of the text.
struct SpecializedText {
    const Dependence &dependence;
    ValueMapping mapping;
    /// By name and component: the text's value that its last Output there writes.
    std::map<std::pair<OutputName, int>, ValueId> outputs;

    /// What the output has become; nothing if the text has none of that name.
    std::optional<ValueId> output(int assumption, const OutputName &, int component);
    /// The same under assumption 0, but nothing if light does not reach it.
    std::optional<ValueId> responseOutput(const OutputName &, int component);
};

/// Writes all outputs that the text has, as they have become under assumption 0.
void writeOutputs(SpecializedText &, const Function &text, Builder &);

/// Outputs are for the caller to write. Text and dependence must outlive the result.
SpecializedText specialize(const Function &text, const Dependence &, Builder &,
                           const std::vector<Assumption> &, const SpecializationOptions &);

} // namespace candela::ir

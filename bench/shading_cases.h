// SPDX-License-Identifier: Apache-2.0
// The shaders of shading_bench: their texts, compiled as the renderer compiles them, and a batch of
// points to shade.
#pragma once

#include "by_hand/by_hand.h"

#include "foundation/base/diagnostics.h"
#include "language/ir/interpret/test_batch.h"

#include <array>
#include <optional>
#include <string>

namespace candela::bench {

struct ShadingCase {
    const char *name;
    const char *file;       ///< Below the source tree.
    const char *parameters; ///< The floats that by_hand knows, in order.
    bool ownNoise;          ///< By hand with another noise: results agree on the average.
};

inline constexpr std::array<ShadingCase, 7> shadingCases{{
    {"constant", "shaders/surface/constant.sl", "", false},
    {"noise", "bench/shaders/noise.sl", "", true},
    {"fbm", "bench/shaders/fbm.sl", "", true},
    {"matte", "shaders/surface/matte.sl", "Ka Kd", false},
    {"plastic", "shaders/surface/plastic.sl",
     "Ka Kd Ks roughness specularcolor specularcolor specularcolor", false},
    {"marble", "bench/shaders/marble.sl", "frequency", true},
    {"brick", "bench/shaders/brick.sl", "Ka Kd width height joint blur grain mortar mortar mortar",
     true},
}};

/// The function that shades with all light given, and a batch of one instance, its parameters at
/// their defaults, under four lights.
struct ShadingWork {
    ir::Function function;
    ir::TestBatch batch;
};
/// Nothing, and an error, if the text and what by_hand knows of it do not fit.
std::optional<ShadingWork> shadingWork(const ShadingCase &, int points, DiagnosticSink &);

} // namespace candela::bench

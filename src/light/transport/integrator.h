// SPDX-License-Identifier: Apache-2.0
// The estimators' common face: a scene and a sample count in, samples of whole pixels out.
#pragma once

#include "world/camera/pixel_filter.h"
#include "world/scene/sample_sink.h"
#include "world/scene/scene.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>

namespace candela {

enum class IntegratorKind { Classic, Path };

struct IntegratorSettings {
    IntegratorKind kind = IntegratorKind::Path;
    int samplesPerPixel = 4;
    std::uint32_t seed = 0;
    int maxDepth = 64;           ///< Reflections and refractions along a path.
    bool hemisphereOnly = false; ///< --sampling hemisphere: ignore the shaders' cones.
    std::array<int, 4> crop{};   ///< x0, x1, y0, y1: the pixels to render.
    /// Called after each tile, from any thread, with the share done in [0,1].
    std::function<void(double)> progress;
};

/// What happened besides the picture, for --stats and messages. Counters of all threads.
struct TransportStatistics {
    std::atomic<std::uint64_t> paths{0}, cameraRays{0}, bounceRays{0}, shadowRays{0};
    std::atomic<std::uint64_t> nonFiniteSamples{0};
};

/// Renders all samples of all pixels of the crop window. Non-finite radiance is reported once to
/// `diagnostics`, with shader, pixel and sample, then counted.
void integrate(const Scene &, const IntegratorSettings &, const PixelFilterSampler &, SampleSink &,
               TransportStatistics &, DiagnosticSink &);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Segments of paths that lie in volumes: what the stage `cross` works with.
#pragma once

#include "light/vertex/shadow_rays.h"
#include "world/scene/segments.h"
#include "world/shading/volume_lights.h"

#include <vector>

namespace candela {

struct PathWave;

/// Light samples at points that volume shaders name.
struct PointLight {
    explicit PointLight(int capacity);

    LightSampleStorage sample;
    ShadowRays shadow;
    Planes<float> floats;
    MutableVec3Planes P;
    float *time, *u, *v, *choice, *none, *wanted, *factor, *ignored;
    Planes<std::int32_t> integers;
    std::int32_t *lightSet, *atmosphere, *inShadow, *lanes;
    Planes<std::uint32_t> keys;
    std::uint32_t *key, *sampleIndex, *inner, *outer;
};

struct Crossing {
    /// A shader that asks for more light the more it gets is answered so often.
    static constexpr int rounds = 4;
    /// Segments whose light is noted at once.
    static constexpr int window = 128;
    /// Under `path` a point takes a sample of each of so many lights, or of each group of more.
    static constexpr int everyLight = 8;

    explicit Crossing(int capacity);

    Segments segments;
    VolumeLights lights;
    std::vector<int> order; ///< Of the points that wait for light.
    PointLight point;
    Planes<std::uint32_t> around;    ///< Of segments, MediaAround where they lie.
    Planes<std::int32_t> atmosphere; ///< The air there.
    Planes<float> ambient;
};

} // namespace candela

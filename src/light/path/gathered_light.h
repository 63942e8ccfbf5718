// SPDX-License-Identifier: Apache-2.0
// Light for surfaces that are not affine in it: toon shaders and their kin. What such a shader
// sends of many samples is not the sum of what it sends of each, so no path can carry it on;
// instead it is given a stated number of samples at once, and asked for Ci (DESIGN section 3).
// This is what the stage lightGathered works with.
#pragma once

#include "light/sampling/cone_mixture.h"
#include "light/vertex/shadow_rays.h"

#include <memory>
#include <vector>

namespace candela {

struct PathWave;

/// Rays that leave surfaces of one shader to find the light there, by vertex.
struct GatheringRays {
    ConstVec3Planes origin, direction; ///< Unit directions.
    ConstVec3Planes N;                 ///< LightQuery::N of the vertices.
    const float *time, *width, *spread;
    const float *pdf; ///< Of the direction, per steradian.
    const int *depth; ///< Scatterings up to the vertex; the gathering is one more.
    const int *lightSet;
    int code;
    const Planes<std::uint32_t> *around;         ///< MediaAround; null where there are no volumes.
    const int *x, *y;                            ///< The pixel, for messages.
    const std::uint32_t *pixelKey, *sampleIndex; ///< The address of the paths' random numbers.
};

/// The dimension pairs of a round. The path that it sends out begins on a surface, so it leaves
/// those of the camera free.
enum RoundPair { onLightPair, alongPair, lightPair, roundPairs };

/// The address and the numbers of a round: a sample of a sequence that belongs to the pixel and
/// the number of the vertex.
struct RoundNumbers {
    explicit RoundNumbers(int capacity) : keys(2, capacity), planes(2 * roundPairs, capacity) {
        pixelKey = keys[0], sampleIndex = keys[1];
    }
    float *x(RoundPair pair) const { return planes[2 * pair]; }
    float *y(RoundPair pair) const { return planes[2 * pair + 1]; }
    Planes<std::uint32_t> keys;
    std::uint32_t *pixelKey, *sampleIndex;
    Planes<float> planes;
};

/// The mixture's cones: the shader's own, which all count alike, and a cosine lobe.
struct GatheringCones {
    explicit GatheringCones(int capacity) : planes(2, capacity) {
        hemisphere = planes[0], one = planes[1];
    }
    Planes<float> planes, importance;
    float *hemisphere, *one;
};

/// The rays of a round, and what weighs them.
struct RoundRays {
    explicit RoundRays(int capacity)
        : direction(3, capacity), origin(3, capacity), floats(5, capacity), integers(4, capacity),
          around(2, capacity) {
        wanted = floats[0], pdf = floats[1], factor = floats[2];
        width = floats[3], spread = floats[4];
        x = integers[0], y = integers[1], inShadow = integers[2], shadowed = integers[3];
    }
    Planes<float> direction, origin, floats;
    float *wanted, *pdf, *factor, *width, *spread;
    Planes<int> integers;
    int *x, *y, *inShadow, *shadowed;
    Planes<std::uint32_t> around; ///< As PathMedia has it.
    std::vector<int> lanes;       ///< Those that want light.
};

struct GatheredLight {
    /// Light comes from so many directions, and from lights as many times.
    static constexpr int rounds = 16;

    /// `wave` finds the light that comes along directions; null = light comes straight from
    /// lights alone, as it does to the gathered shaders that gathering meets.
    GatheredLight(int capacity, std::unique_ptr<PathWave> wave);
    ~GatheredLight();

    std::unique_ptr<PathWave> wave;
    ConeMixture mixture;
    GatheringCones cones;
    RoundNumbers numbers;
    RoundRays rays;
    LightSampleStorage sample;
    ShadowRays shadow;
    LightRows rows;
    int rowCount = 0; ///< Of rows, those that were gathered last.
    Planes<float> Ci, Oi;
    Planes<float> darkness; ///< Ci without light.
};

/// Light for all vertices of the chunk in `rounds` rounds, 1 to GatheredLight::rounds of them:
/// rows of the wave's `gathered`, and how many. The stages that state lobes and events come behind.
int gatherLight(PathWave &, int rounds);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// What paths have gathered and what they carry, structure of arrays.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color.h"
#include "light/path/techniques.h"
#include "light/sampling/cone_mixture.h"
#include "world/rays/ray_batch.h"

#include <cstdint>
#include <vector>

namespace candela {

/// What a path has gathered, by slot: one slot a camera sample, fixed while the wave lasts.
struct PathResults {
    PathResults(int capacity, int channelPlanes)
        : pixels(3, capacity), keys(1, capacity), radiance(colorSamples, capacity),
          opacity(colorSamples, capacity), channels(channelPlanes, capacity), weight(1, capacity) {
        x = pixels[0], y = pixels[1], sampleIndex = pixels[2];
    }
    Planes<int> pixels;
    int *x, *y,
        *sampleIndex; ///< The pixel; x is the point's number (IntegratorSettings::atPoints).
    Planes<std::uint32_t> keys; ///< pixelKey() of the slot's pixel.
    Planes<float> radiance, opacity;
    Planes<float> channels; ///< Further channels, from the first surface that the path meets.
    Planes<float> weight;   ///< Of the pixel filter.
};

/// What the last scattering left on a ray: the other half of what light sampling must know where
/// the ray meets a lamp.
struct RayOrigins {
    explicit RayOrigins(int capacity) : floats(4, capacity), integers(2, capacity) {
        pdf = floats[0];
        for (int c = 0; c < 3; ++c)
            N[c] = floats[1 + c];
        lightSet = integers[0], code = integers[1];
    }
    Planes<float> floats;
    Planes<int> integers;
    float *pdf; ///< Of the direction, per steradian; 0 = it had no choice (camera, mirror), so
                ///< emission that it meets counts in full.
    /// LightQuery::N of the vertex that it left; 0 for cameras and mirrors.
    MutableVec3Planes N;
    int *lightSet; ///< Of the vertex that it left; -1 = none.
    int *code;     ///< Of that vertex's shader; -1 = none: it hears all lights.
};

/// What rays carry in scenes that have volumes: what they are in, and what the opacity that they
/// lead to is worth. Volumes may make light of it (a fog that hides nothing where nothing is).
struct PathMedia {
    explicit PathMedia(int capacity)
        : around(2, capacity), veil(colorSamples, capacity), cover(colorSamples, capacity),
          left(2, capacity) {
        air = left[0], entered = left[1];
    }
    Planes<std::uint32_t> around; ///< MediaAround: inner, outer.
    Planes<float> veil;           ///< The radiance that a unit of opacity brings.
    Planes<float> cover;          ///< The opacity that it brings, as long as the camera sees.
    /// Of what the ray has left, which is the far end for an eye that looks against it: the
    /// Atmosphere, and the Interior if the ray has left to that.
    Planes<std::int32_t> left;
    std::int32_t *air, *entered;
};

/// The paths that are still under way, packed: entry i moves as others end.
struct ActivePaths {
    ActivePaths(int capacity, bool inMedia, bool hasTwoEnds = false)
        : rays(capacity), left(capacity), throughput(colorSamples, capacity), integers(3, capacity),
          keys(1, capacity), media(inMedia ? capacity : 0), history(hasTwoEnds ? capacity : 0) {
        slot = integers[0], depth = integers[1], seen = integers[2];
        sampleIndex = keys[0];
    }

    int count = 0;
    RayBatch rays; ///< Unit directions.
    RayOrigins left;
    Planes<float> throughput;
    Planes<int> integers;
    int *slot;
    int *depth; ///< Scatterings so far.
    int *seen;  ///< 1 as long as the camera sees along this ray: it adds to opacity.
    Planes<std::uint32_t> keys;
    std::uint32_t *sampleIndex;    ///< The path's number within its pixel: see path/split.h.
    PathMedia media;               ///< Empty if the scene has no volumes.
    std::vector<PathEdge> history; ///< Empty unless paths have two ends.
};

} // namespace candela

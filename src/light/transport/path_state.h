// SPDX-License-Identifier: Apache-2.0
// The state of a wave: many paths advanced a vertex at a time, structure of arrays.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/units/color.h"
#include "language/runtime/shader_abi.h"
#include "world/rays/ray_batch.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace candela {

/// The dimension pairs of a path: three for the camera, then four a vertex.
enum CameraPair { filterPair, lensPair, timePair, cameraPairs };
enum VertexPair { lightPositionPair, directionPair, lightChoicePair, eventPair, vertexPairs };

/// What a path has gathered, by slot: one slot a camera sample, fixed while the wave lasts.
struct PathResults {
    PathResults(int capacity, int channelPlanes)
        : pixels(4, capacity), keys(1, capacity), radiance(colorSamples, capacity),
          opacity(colorSamples, capacity), channels(channelPlanes, capacity), weight(1, capacity) {
        x = pixels[0], y = pixels[1], sampleIndex = pixels[2];
    }
    Planes<int> pixels;
    int *x, *y, *sampleIndex;
    Planes<std::uint32_t> keys; ///< pixelKey() of the slot's pixel.
    Planes<float> radiance, opacity;
    Planes<float> channels; ///< Further channels, from the first surface that the path meets.
    Planes<float> weight;   ///< Of the pixel filter.
};

/// The paths that are still under way, packed: entry i moves as others end.
struct ActivePaths {
    explicit ActivePaths(int capacity)
        : rays(capacity), throughput(colorSamples, capacity), floats(2, capacity),
          integers(4, capacity) {
        lastPdf = floats[0], travelled = floats[1];
        slot = integers[0], depth = integers[1], lightSet = integers[2], seen = integers[3];
    }

    int count = 0;
    RayBatch rays; ///< Unit directions.
    Planes<float> throughput;
    Planes<float> floats;
    float *lastPdf;   ///< Of the ray's direction, per steradian; 0 = it had no choice (camera,
                      ///< mirror), so emission that it meets counts in full.
    float *travelled; ///< From the last scattering to the ray's origin, through transparency.
    Planes<int> integers;
    int *slot;
    int *depth;    ///< Scatterings so far.
    int *lightSet; ///< Of the last scattering surface; -1 = none.
    int *seen;     ///< 1 as long as the camera sees along this ray: it adds to opacity.
};

} // namespace candela

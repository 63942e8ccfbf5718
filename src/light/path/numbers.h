// SPDX-License-Identifier: Apache-2.0
// Which dimension of the sample sequence serves what.
#pragma once

#include "foundation/base/planes.h"

namespace candela {

/// The dimension pairs of a path: three for the camera, then three a vertex.
enum CameraPair { filterPair, lensPair, timePair, cameraPairs };
enum VertexPair { lightPositionPair, directionPair, lightChoicePair, vertexPairs };

/// The numbers of a chunk's vertices. Those that nothing reads are not drawn.
struct VertexNumbers {
    explicit VertexNumbers(int capacity) : planes(2 * vertexPairs, capacity) {}
    float *x(VertexPair pair) const { return planes[2 * pair]; }
    float *y(VertexPair pair) const { return planes[2 * pair + 1]; }
    /// The second number of the pair that chooses the light.
    float *roulette() const { return y(lightChoicePair); }
    Planes<float> planes;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Rays and hits in structure-of-arrays batches, current space.
#pragma once

#include "world/scene/planes.h"

#include <cstdint>

namespace candela {

inline constexpr std::uint32_t noHit = 0xffffffff;

struct RayBatch {
    explicit RayBatch(int capacity)
        : originX(capacity), originY(capacity), originZ(capacity), directionX(capacity),
          directionY(capacity), directionZ(capacity), tMax(capacity), time(capacity) {}

    struct Plane {
        explicit Plane(int capacity) : storage(1, capacity) {}
        Planes<float> storage;
        operator float *() const { return storage[0]; }
    };
    int count = 0;
    Plane originX, originY, originZ;
    Plane directionX, directionY, directionZ; ///< Any length; distances are in its multiples.
    Plane tMax;                               ///< <= 0: the ray is not traced (it misses).
    Plane time;
};

/// What the rays met, index by index.
struct HitBatch {
    explicit HitBatch(int capacity) : integers(2, capacity), floats(3, capacity) {
        primitive = integers[0], triangle = integers[1];
        t = floats[0], u = floats[1], v = floats[2];
    }
    Planes<std::uint32_t> integers;
    Planes<float> floats;
    std::uint32_t *primitive; ///< Index into Scene's primitives, or noHit.
    std::uint32_t *triangle;
    float *t, *u, *v; ///< Distance in ray directions; barycentric coordinates of the triangle.
};

} // namespace candela

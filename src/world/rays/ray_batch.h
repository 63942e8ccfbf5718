// SPDX-License-Identifier: Apache-2.0
// Rays and hits in structure-of-arrays batches, current space.
#pragma once

#include "foundation/base/planes.h"

#include <array>
#include <cstdint>

namespace candela {

inline constexpr std::uint32_t noHit = 0xffffffff;

/// What camera rays stand for of their pixels: how far, along the raster's axes and in pixels, the
/// middle of its share lies from the ray, and how wide the share is. By ray.
struct PixelShares {
    const float *x, *y;
    const float *wide, *high;
};

/// Kinds of rays, from which shapes may be hidden: bits.
namespace ray_kind {
inline constexpr std::uint8_t camera = 1, diffuse = 2, specular = 4;
}

/// Points of a ray are origin + t direction with tMin < t <= tMax. A ray that passes a surface
/// straight on keeps its origin and direction and raises tMin to the t of the surface.
struct RayBatch {
    explicit RayBatch(int capacity) : planes(11, capacity) {
        for (int c = 0; c < 3; ++c)
            origin[c] = planes[c], direction[c] = planes[3 + c];
        tMin = planes[6], tMax = planes[7], time = planes[8];
        width = planes[9], spread = planes[10];
    }

    int count = 0;
    /// They run against the eye's: what is seen from one side alone stops them on both.
    bool fromLights = false;
    Planes<float> planes;
    std::array<float *, 3> origin, direction; ///< Directions of any length: t is in its multiples.
    float *tMin;                              ///< >= 0. Hits lie strictly beyond.
    float *tMax;                              ///< <= tMin: the ray is not traced (it misses).
    float *time;                              ///< Seconds, within the shutter interval.
    /// The footprint: a cone that is `width` metres wide at the origin and grows by `spread`
    /// metres a unit of t. What one sample stands for is about as wide.
    float *width, *spread;
    /// Of camera rays, whose footprints these tell better; else null.
    const PixelShares *shares = nullptr;
    /// Of what kind each ray is; null: they see what either diffuse or specular ones do.
    const std::uint8_t *kinds = nullptr;
};

/// The tMin of a ray that passes what it has met at t: beyond t by more than the rounding with
/// which the same element is met again.
inline float passing(float t) { return t * (1 + 4 * 0x1p-23f); }

/// What the rays met, index by index.
struct HitBatch {
    explicit HitBatch(int capacity) : integers(3, capacity), floats(6, capacity) {
        shape = integers[0], element = integers[1], instance = integers[2];
        t = floats[0], u = floats[1], v = floats[2];
        for (int c = 0; c < 3; ++c)
            Ng[c] = floats[3 + c];
    }
    Planes<std::uint32_t> integers;
    Planes<float> floats;
    std::uint32_t *shape;    ///< Which shape of the scene, or noHit.
    std::uint32_t *element;  ///< Which triangle (or other element) of the shape.
    std::uint32_t *instance; ///< Which instance, noHit for shapes that stand in the world itself.
    float *t, *u, *v; ///< Distance in ray directions; barycentric coordinates on the element.
    /// Normal of the element, of any length, in the instance's object space (current space in the
    /// world itself), along (p1 - p0) x (p2 - p0) of the element's corners.
    std::array<float *, 3> Ng;
};

} // namespace candela

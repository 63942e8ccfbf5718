// SPDX-License-Identifier: Apache-2.0
// Triangles in current space and the rays that meet them. The one file that knows Embree is
// ray_world.cpp.
#pragma once

#include "foundation/base/vec3.h"
#include "world/rays/ray_batch.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace candela {

/// The triangles of one primitive.
struct RayMesh {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool opaque = true;
    /// Not zero: only rays that come against this sign times (p1 - p0) x (p2 - p0) are stopped.
    int frontSign = 0;
};

/// Flush-to-zero and denormals-are-zero for as long as it lives, as Embree wants them.
class FlushDenormals {
public:
    FlushDenormals();
    ~FlushDenormals();
    FlushDenormals(const FlushDenormals &) = delete;

private:
    unsigned saved_;
};

class RayWorld {
public:
    /// meshes[i] becomes primitive i. What the meshes hold is not needed afterwards.
    explicit RayWorld(const std::vector<RayMesh> &meshes);
    ~RayWorld();
    RayWorld(const RayWorld &) = delete;

    bool hasTransparent() const { return hasTransparent_; }

    enum class Which { All, Transparent };
    /// Nearest hits, see Scene::intersect.
    void intersect(const RayBatch &, HitBatch &, Which, bool coherent) const;
    /// blocked[i] = 1 if an opaque triangle stands in ray i's way (or it is not to be traced, 2).
    void occluded(const RayBatch &, std::uint8_t *blocked) const;

private:
    struct Handles;
    std::unique_ptr<Handles> handles_;
    bool hasTransparent_ = false;
};

} // namespace candela

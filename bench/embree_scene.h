// SPDX-License-Identifier: Apache-2.0
// A benchmark scene in bare Embree, and its lamps by power, for the yardstick.
#pragma once

#include "scenes/description.h"

#include <embree3/rtcore.h>

namespace candela::bench {

struct SurfaceTriangle {
    Vec3 normal; ///< Unit, geometric.
    float albedo = 0;
    float radiance = 0; ///< Above zero: a lamp, which reflects nothing.
};

/// Geometry 0 holds all triangles, geometry 1 the spheres.
class EmbreeScene {
public:
    explicit EmbreeScene(const SceneDescription &description);
    ~EmbreeScene();
    EmbreeScene(const EmbreeScene &) = delete;
    EmbreeScene &operator=(const EmbreeScene &) = delete;

    RTCScene scene() const { return scene_; }
    const SurfaceTriangle &triangle(std::uint32_t index) const { return triangles_[index]; }
    std::size_t lamps() const { return cumulative_.size(); }
    /// Chooses a lamp by its share of the power with a number in [0, 1); quads come first.
    std::size_t chooseLamp(float random, float &probability) const;

private:
    void addTriangles(const SceneDescription &description);
    void addSpheres(const SceneDescription &description);

    RTCDevice device_;
    RTCScene scene_;
    std::vector<SurfaceTriangle> triangles_;
    std::vector<float> cumulative_; ///< Shares of the power, summed; the last is 1.
};

} // namespace candela::bench

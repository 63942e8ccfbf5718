// SPDX-License-Identifier: Apache-2.0
// Surfaces by their own parameters, without rays: for estimators whose unknowns live on them.
#pragma once

#include "world/geometry/surface.h"
#include "world/points/shading_points.h"

#include <cstdint>
#include <vector>

namespace candela {

struct SceneState;

/// A shape where it stands.
struct PlacedDomain {
    std::uint32_t instance = 0, shape = 0; ///< As HitBatch has them.
    SurfaceDomain domain;
    int code = 0;            ///< Of the shader there.
    int light = 0;           ///< The light that it is: index + 1, 0 = none.
    int lightSet = 0;        ///< Which lights shine on it: Lights::isOn.
    bool isOneSided = false; ///< See Scene::isOneSided.
    /// Rays that start no farther off the true surface may meet it (docs/ray-offset.md).
    float offset = 0;
};

/// Points on placed shapes; see SurfaceQuery for (piece, u, v).
struct SurfacePlaces {
    int count = 0;
    const std::uint32_t *instance = nullptr, *shape = nullptr, *piece = nullptr;
    const float *u = nullptr, *v = nullptr;
};

class SurfaceDomains {
public:
    /// In the order of the world's shapes, then of instances and their shapes.
    std::vector<PlacedDomain> all() const;
    /// Current space: the point, the unit geometric normal as shaders see it when it is not turned
    /// to the viewer, and area per unit of (u,v), 0 at poles.
    void frames(const SurfacePlaces &, const Vec3Planes &P, const Vec3Planes &Ng,
                float *areaScale) const;
    /// Shading points, all of one code, seen along I (from a viewer at P - I).
    void shadingPoints(const SurfacePlaces &, const Vec3Planes &I, float time,
                       ShadingPoints &) const;
    /// (piece, u, v) of points that rays have met.
    void name(ShadingPoints &, std::uint32_t *piece, float *u, float *v) const;

private:
    friend class Scene;
    explicit SurfaceDomains(const SceneState &state) : state_(&state) {}
    const SceneState *state_;
};

} // namespace candela

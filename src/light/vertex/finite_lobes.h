// SPDX-License-Identifier: Apache-2.0
// The density of directions that a view of a surface asks light from, its finite lobes together.
#pragma once

#include "light/vertex/surface_vertices.h"

namespace candela {

/// The cosine lobe that stands for all cones under --sampling hemisphere.
struct HemisphereCone {
    explicit HemisphereCone(int capacity) : planes(3, capacity) {
        angle = planes[0], exponent = planes[1], importance = planes[2];
    }
    Planes<float> planes;
    float *angle, *exponent, *importance;
};

/// All finite cones, or with `hemisphere` a cosine lobe about the facing normal that is as
/// important as all of them together. `transmits` as ConeMixture::state() has it.
void stateFiniteLobes(int count, const std::vector<ConePlanes> &cones,
                      const ConstVec3Planes &facing, const float *transmits,
                      HemisphereCone *hemisphere, ConeMixture &);

/// Vertices as they are seen from elsewhere than where they were met: what the other end of a path
/// makes of them.
class VertexView {
public:
    explicit VertexView(int capacity);

    /// Looks along I (from the viewer to P, any length), which is kept by pointer. Silent.
    void look(SurfaceVertices &, const ConstVec3Planes &I, bool hemisphereOnly);
    /// For densities alone: looks at vertices of[0..count), which may come again and again, a lane
    /// each view. approach() must come before, once for all views of the same vertices.
    void lookAgain(int count, const std::int32_t *of, const ConstVec3Planes &I,
                   bool hemisphereOnly);
    void approach(SurfaceVertices &);
    /// The density per steradian with which directions (unit) would be drawn from here; 0 where
    /// there are no finite lobes.
    void pdf(const ConstVec3Planes &direction, float *pdf);
    /// As SurfaceVertices::scatter().
    void scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                 const std::int32_t *light, float *const *g);
    const PreparedSurface &answers() const { return view_.answers; }

private:
    void stateLobes(int count, bool hemisphereOnly);

    SurfaceVertices *vertices_ = nullptr;
    int count_ = 0;
    ConstVec3Planes I_{};
    PreparedView view_;
    Planes<float> facing_, transmission_, normals_;
    HemisphereCone hemisphere_;
    ConeMixture mixture_;
};

} // namespace candela

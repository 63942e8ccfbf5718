// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/finite_lobes.h"

#include "light/vertex/scattering_event.h"

#include <algorithm>

namespace candela {

void stateFiniteLobes(int count, const std::vector<ConePlanes> &cones,
                      const ConstVec3Planes &facing, const float *transmits,
                      HemisphereCone *hemisphere, ConeMixture &mixture) {
    mixture.state(count, cones, facing, transmits);
    if (!hemisphere)
        return;
    HemisphereCone &cone = *hemisphere;
    std::copy_n(mixture.total(), count, cone.importance);
    std::fill_n(cone.angle, count, 180.0f);
    std::fill_n(cone.exponent, count, 1.0f);
    mixture.state(count,
                  {{facing, cone.angle, cone.exponent, cone.importance, cone.angle, 0, true}},
                  facing, transmits);
}

VertexView::VertexView(int capacity)
    : facing_(3, capacity), transmission_(1, capacity), hemisphere_(capacity), mixture_(capacity) {}

void VertexView::look(SurfaceVertices &vertices, const ConstVec3Planes &I, bool hemisphereOnly) {
    vertices_ = &vertices, I_ = I;
    vertices.prepareFrom(I, view_);
    facingNormals(vertices.count(), vertices.input(ShaderInput::Ng), I,
                  {facing_[0], facing_[1], facing_[2]});
    const bool transmits = transmittedLight(vertices.count(), view_.answers.Oi, transmission_[0]);
    stateFiniteLobes(vertices.count(), view_.answers.cones, {facing_[0], facing_[1], facing_[2]},
                     transmits ? transmission_[0] : nullptr,
                     hemisphereOnly ? &hemisphere_ : nullptr, mixture_);
}

void VertexView::pdf(const ConstVec3Planes &direction, float *pdf) {
    mixture_.pdf(direction, pdf);
    const float *total = mixture_.total();
    for (int i = 0; i < vertices_->count(); ++i)
        pdf[i] = total[i] > 0 ? pdf[i] : 0.0f;
}

void VertexView::scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                         const std::int32_t *light, float *const *g) {
    vertices_->scatterFrom(I_, view_, direction, answered, light, g);
}

} // namespace candela

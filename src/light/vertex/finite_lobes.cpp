// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/finite_lobes.h"

#include "foundation/base/lanes.h"
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
    : facing_(3, capacity), transmission_(1, capacity), normals_(3, capacity),
      hemisphere_(capacity), mixture_(capacity) {}

void VertexView::look(SurfaceVertices &vertices, const ConstVec3Planes &I, bool hemisphereOnly) {
    vertices_ = &vertices, I_ = I;
    vertices.prepareFrom(I, view_);
    facingNormals(vertices.count(), vertices.input(ShaderInput::Ng), I,
                  {facing_[0], facing_[1], facing_[2]});
    stateLobes(vertices.count(), hemisphereOnly);
}

void VertexView::approach(SurfaceVertices &vertices) {
    vertices_ = &vertices;
    vertices.prepareSurface(view_);
}

void VertexView::lookAgain(int count, const std::int32_t *of, const ConstVec3Planes &I,
                           bool hemisphereOnly) {
    I_ = I;
    vertices_->prepareOf(count, of, I, view_);
    const ConstVec3Planes Ng = vertices_->input(ShaderInput::Ng);
    for (int c = 0; c < 3; ++c)
        lanes::gather(count, of, Ng[c], normals_[c]);
    facingNormals(count, {normals_[0], normals_[1], normals_[2]}, I,
                  {facing_[0], facing_[1], facing_[2]});
    stateLobes(count, hemisphereOnly);
}

void VertexView::stateLobes(int count, bool hemisphereOnly) {
    count_ = count;
    const bool transmits = transmittedLight(count, view_.answers.Oi, transmission_[0]);
    stateFiniteLobes(count, view_.answers.cones, {facing_[0], facing_[1], facing_[2]},
                     transmits ? transmission_[0] : nullptr,
                     hemisphereOnly ? &hemisphere_ : nullptr, mixture_);
}

void VertexView::pdf(const ConstVec3Planes &direction, float *pdf) {
    mixture_.pdf(direction, pdf);
    const float *total = mixture_.total();
    for (int i = 0; i < count_; ++i)
        pdf[i] = total[i] > 0 ? pdf[i] : 0.0f;
}

void VertexView::scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                         const std::int32_t *light, float *const *g) {
    vertices_->scatterFrom(I_, view_, direction, answered, light, g);
}

} // namespace candela

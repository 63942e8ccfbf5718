// SPDX-License-Identifier: Apache-2.0
// Rays that shaders ask for, followed in batches: occlusion(), transmission(), rayhittest(),
// gather.
#pragma once

#include "world/scene/scene.h"
#include "world/shading/ray_answers.h"

namespace candela {

class ShaderRays : public RayAnswers {
public:
    explicit ShaderRays(const Scene &scene) : scene_(scene) {}

    void transmission(const ServiceCall &) const override;
    void occlusion(const ServiceCall &) const override;
    void nearestHit(const ServiceCall &) const override;

private:
    const Scene &scene_;
};

} // namespace candela

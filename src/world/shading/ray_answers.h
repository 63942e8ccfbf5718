// SPDX-License-Identifier: Apache-2.0
// Who follows the rays that shaders ask for: the scene, as soon as there is one.
#pragma once

#include "language/runtime/services.h"

namespace candela {

/// The services of language/runtime/services.def that need rays. Called from any thread, also while
/// a shader runs that another call of the same thread has asked.
class RayAnswers {
public:
    virtual ~RayAnswers() = default;
    virtual void transmission(const ServiceCall &) const = 0;
    virtual void occlusion(const ServiceCall &) const = 0;
    virtual void nearestHit(const ServiceCall &) const = 0;
};

} // namespace candela

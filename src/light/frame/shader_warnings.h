// SPDX-License-Identifier: Apache-2.0
// What users of a shader should know of how paths serve it: said once a shader and run.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/scene/scene.h"

#include <set>
#include <string>

namespace candela {

class ShaderWarnings {
public:
    explicit ShaderWarnings(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {}

    /// Warns of surface shaders in the scene that are not affine in the light (their pictures
    /// depend on GatheredLight::rounds) and of those whose requests are not static (they cost
    /// time): nothing under `classic`, which runs every surface shader whole. And of volume shaders
    /// that are not affine in what they are given.
    void look(const Scene &);

private:
    void once(const std::string &message);

    DiagnosticSink &diagnostics_;
    std::set<std::string> said_;
};

} // namespace candela

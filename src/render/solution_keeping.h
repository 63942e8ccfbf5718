// SPDX-License-Identifier: Apache-2.0
// Radiosity's solution in files: one that other views of the same scene begin with, and one for
// other programs.
#pragma once

#include "light/path/settings.h"
#include "render/frame_identity.h"
#include "render/render.h"
#include "world/scene/scene.h"

namespace candela {

/// What a solution depends on: the world (WorldFingerprint), the shaders, seed and version. Where
/// the camera stands is not of it, but how large it makes the world: light falls off with distance.
FrameIdentity solutionIdentity(const Scene &, const RenderSettings &, const std::string &world,
                               const std::string &shaders);

/// Has the integrator begin with the solution in settings.solutionFile, if that is there, or write
/// it when it is made; and write settings.solutionMesh. False if the file is of another scene, or
/// none: it stays as it is, and the frame is not to be rendered. What is wrong is reported. `scene`
/// must outlive the render.
bool keepSolution(const Scene &, const RenderSettings &, const FrameIdentity &,
                  IntegratorSettings &, DiagnosticSink &);

} // namespace candela

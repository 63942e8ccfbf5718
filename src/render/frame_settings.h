// SPDX-License-Identifier: Apache-2.0
// What options and command line make of a frame: what integrators are told, what files tell of it.
#pragma once

#include "image/displays.h"
#include "light/path/settings.h"
#include "render/checkpoint.h"
#include "render/render.h"
#include "world/scene/scene.h"

#include <string>

namespace candela {

IntegratorSettings integratorSettings(const Scene &, const RenderSettings &);

/// As RIB and command line name it.
const char *integratorName(const IntegratorSettings &);

/// For a picture that has all its samples. `file` is the RIB's name.
FrameDescription describeFrame(const Scene &, const IntegratorSettings &, const std::string &file);

/// All that the frame's picture depends on; `requests` and `shaders` are fingerprints.
FrameIdentity identityOf(const Scene &, const RenderSettings &, const std::string &requests,
                         const std::string &shaders);

} // namespace candela

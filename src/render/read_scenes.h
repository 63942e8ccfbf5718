// SPDX-License-Identifier: Apache-2.0
// From the bytes of a RIB file to the scenes in it.
#pragma once

#include "render/frame.h"
#include "world/scene/scene.h"

#include <functional>
#include <string>

namespace candela {

/// Gets the scenes in their order, each for as long as the call lasts.
using SceneReceiver = std::function<void(const Scene &, ShaderLibrary &)>;

/// Reads a RIB file ("-" = standard input) with the settings' options, folders and code generation.
/// What is wrong is reported, and so is a file without a world.
void readScenes(const std::string &path, const RenderSettings &, const FrameListeners &,
                const SceneReceiver &);

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// From the bytes of a RIB file to the scenes in it.
#pragma once

#include "interface/rib/rib_reader.h"
#include "render/frame.h"
#include "world/scene/scene.h"

#include <functional>
#include <memory>
#include <string>

namespace candela {

/// What a scene has been made of.
struct SceneFingerprints {
    std::string requests; ///< All up to its end; empty unless there are to be checkpoints.
    std::string world;    ///< See WorldFingerprint; empty unless a solution is to be kept.
};

/// Gets the scenes in their order, each for as long as the call lasts.
using SceneReceiver =
    std::function<void(const Scene &, ShaderLibrary &, const SceneFingerprints &)>;

/// Makes scenes of requests, with the settings' options, folders and code generation.
class SceneReading {
public:
    /// `name` is that of the file, or stands for it. All must outlive it.
    SceneReading(const std::string &name, const RenderSettings &, const FrameListeners &,
                 SceneReceiver);
    ~SceneReading();

    RibReader &reader();
    /// After the last request. What is still open, and that there was no world, is reported, unless
    /// the requests were `cut` short.
    void finish(bool cut = false);

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// Reads RIB files ("-" = standard input) as if they were one. What is wrong is reported.
void readScenes(const std::vector<std::string> &paths, const RenderSettings &,
                const FrameListeners &, const SceneReceiver &);

} // namespace candela

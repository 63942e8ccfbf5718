// SPDX-License-Identifier: Apache-2.0
// The frames of one command: which of them are rendered, how long, and where they go on.
#pragma once

#include "render/frame.h"
#include "render/read_scenes.h"

#include <optional>
#include <string>

namespace candela {

class RenderRun {
public:
    /// `name` is that of the RIB. All must outlive it; the clock of the time limit starts.
    RenderRun(const std::string &name, const RenderSettings &, const FrameListeners &);

    /// Before the first request. False if --resume names what is no checkpoint: nothing is
    /// rendered.
    bool begin();
    /// A world that has been read.
    void take(const Scene &, ShaderLibrary &, const SceneFingerprints &);
    /// After the last one.
    void finish();

    /// How the last frame that was rendered came to its end.
    FrameEnd end() const { return end_; }

private:
    /// False if the frame has been rendered by the run before.
    bool isToDo(const FrameIdentity &);
    void noteDone(const FrameIdentity &);

    const std::string name_;
    const RenderSettings &settings_;
    const FrameListeners listeners_;
    FrameKeeping keeping_;
    std::optional<Checkpoint> from_; ///< Until its frame has come.
    int worlds_ = 0, frames_ = 0;    ///< That have come; that have been seen to.
    FrameEnd end_ = FrameEnd::Whole;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
#include "render/render_run.h"

#include "foundation/base/whole_file.h"
#include "render/frame_settings.h"
#include "render/solution_keeping.h"

#include <filesystem>
#include <fmt/format.h>

namespace candela {

RenderRun::RenderRun(const std::string &name, const RenderSettings &settings,
                     const FrameListeners &listeners)
    : name_(name), settings_(settings), listeners_(listeners) {
    using Clock = FrameKeeping::Clock;
    keeping_.heedsSignals = true;
    if (settings.timeLimit > 0)
        keeping_.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                               std::chrono::duration<double>(settings.timeLimit));
    keeping_.checkpointFile = settings.checkpointFile;
    keeping_.secondsBetween = settings.secondsBetweenCheckpoints;
}

bool RenderRun::begin() {
    DiagnosticSink &diagnostics = listeners_.diagnostics;
    std::string problem;
    if (!settings_.checkpointFile.empty() && !canWriteFile(settings_.checkpointFile, problem)) {
        diagnostics.error({}, "there can be no checkpoint: " + problem);
        return false;
    }
    const std::string &file = settings_.resumeFile;
    if (file.empty())
        return true;
    if (!std::filesystem::exists(file)) { // A run may have ended before it wrote its first one.
        diagnostics.warning({}, "there is no checkpoint " + file +
                                    ": the render begins at its beginning");
        return true;
    }
    const auto bytes = readWholeFile(file, problem);
    if (bytes)
        from_ = decodeCheckpoint(*bytes, problem);
    if (!from_)
        diagnostics.error({}, "the render cannot go on from " + file + ": " + problem);
    return from_.has_value();
}

bool RenderRun::isToDo(const FrameIdentity &identity) {
    if (!from_)
        return true;
    if (frames_ < from_->frame)
        return false;
    if (!from_->isDone)
        return true;
    if (const std::string difference = differenceOf(from_->identity, identity);
        !difference.empty()) {
        listeners_.diagnostics.error({}, "the checkpoint is not of this render: " + difference);
        end_ = FrameEnd::Refused;
    }
    from_.reset();
    return false;
}

void RenderRun::noteDone(const FrameIdentity &identity) {
    if (keeping_.checkpointFile.empty())
        return;
    std::string problem;
    if (!writeWholeFile(keeping_.checkpointFile,
                        encodeCheckpoint({frames_, true, identity, {}, {}}, nullptr), problem))
        listeners_.diagnostics.error({}, "the checkpoint cannot be written: " + problem);
}

void RenderRun::take(const Scene &scene, ShaderLibrary &shaders,
                     const SceneFingerprints &fingerprints) {
    ++worlds_;
    if (end_ != FrameEnd::Whole)
        return;
    FrameIdentity identity;
    if (!settings_.checkpointFile.empty() || from_)
        identity = identityOf(scene, settings_, fingerprints.requests, shaders.fingerprint());
    if (frames_ == 1 && !settings_.outputFile.empty() &&
        settings_.outputFile.find('#') == std::string::npos)
        listeners_.diagnostics.warning({}, "all frames are written to " + settings_.outputFile +
                                               ", one over the other: #### in the name becomes "
                                               "the number of the frame");
    if (isToDo(identity)) {
        keeping_.frame = frames_;
        keeping_.identity = identity;
        keeping_.from.swap(from_);
        if (!settings_.solutionFile.empty())
            keeping_.solution =
                solutionIdentity(scene, settings_, fingerprints.world, shaders.fingerprint());
        end_ = renderFrame(scene, shaders, settings_, name_, listeners_, keeping_);
        keeping_.from.reset();
        if (end_ == FrameEnd::Whole)
            noteDone(identity);
    }
    ++frames_;
}

void RenderRun::finish() {
    if (from_ && end_ == FrameEnd::Whole && !listeners_.console.failed())
        listeners_.diagnostics.error(
            {}, fmt::format("the checkpoint is not of this render: it is of world {}, and there "
                            "are {}",
                            from_->frame + 1, worlds_));
    const int left = worlds_ - frames_;
    if (left > 0 && end_ != FrameEnd::Refused)
        listeners_.diagnostics.warning(
            {}, fmt::format("{} that follow{} not rendered",
                            left == 1 ? "a frame" : fmt::format("{} frames", left),
                            left == 1 ? "s is" : " are"));
}

} // namespace candela

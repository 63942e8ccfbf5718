// SPDX-License-Identifier: Apache-2.0
#include "render/render_session.h"

#include "foundation/base/parallel.h"
#include "render/console.h"
#include "render/read_scenes.h"
#include "render/statistics.h"

namespace candela {

struct RenderSession::State {
    State(const std::string &name, const RenderSettings &given, DiagnosticSink &heard)
        : settings(given),
          console(given.quiet ? Console::Words::Messages : Console::Words::Progress),
          diagnostics(heard), threads(given.threads), listeners{diagnostics, console, statistics},
          scenes(
              name, settings, listeners,
              [this, name](const Scene &scene, ShaderLibrary &shaders, const SceneFingerprints &) {
                  FrameKeeping keeping;
                  keeping.heedsSignals = settings.heedsSignals;
                  if (end == FrameEnd::Whole)
                      end = renderFrame(scene, shaders, settings, name, listeners, keeping);
              }) {}

    const RenderSettings settings;
    Console console;
    ErrorPolicy diagnostics;
    ThreadLimit threads;
    Statistics statistics;
    const FrameListeners listeners;
    FrameEnd end = FrameEnd::Whole;
    SceneReading scenes;
};

RenderSession::RenderSession(const std::string &name, const RenderSettings &settings,
                             DiagnosticSink &heard)
    : state_(std::make_unique<State>(name, settings, heard)) {}
RenderSession::~RenderSession() = default;

StreamSink &RenderSession::requests() { return state_->scenes.reader().stream(); }
ErrorPolicy &RenderSession::diagnostics() { return state_->diagnostics; }

FrameEnd RenderSession::end() const { return state_->end; }

void RenderSession::finish() {
    state_->scenes.finish();
    const std::string &file = state_->settings.statisticsFile;
    if (!file.empty())
        state_->statistics.write(file, state_->diagnostics);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Renders what it is told, world by world: what RIB files are to renderFiles(), calls are to this.
#pragma once

#include "interface/ri/error_policy.h"
#include "interface/ri/stream_sink.h"
#include "render/frame.h"

#include <memory>
#include <string>

namespace candela {

class RenderSession {
public:
    /// `name` stands for the file in messages and in pictures. What is found is told to `heard`,
    /// which must outlive it.
    RenderSession(const std::string &name, const RenderSettings &, DiagnosticSink &heard);
    ~RenderSession();

    StreamSink &requests();
    ErrorPolicy &diagnostics();
    /// How the last frame came to its end.
    FrameEnd end() const;
    /// After the last request.
    void finish();

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace candela

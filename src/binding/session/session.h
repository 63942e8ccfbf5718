// SPDX-License-Identifier: Apache-2.0
// What Begin of the RenderMan Interface begins, whatever language its calls come from: a renderer,
// or RIB that is written.
#pragma once

#include "interface/ri/stream_sink.h"

#include <memory>
#include <string>

namespace candela {

struct RenderSettings;

class Session {
public:
    /// As RiBegin is told: no name renders, each world at its end; "x.rib" (".gz": packed) and
    /// "|command" write RIB. Null, and `problem` says why, if it cannot be written. What is found
    /// is told to the sink, which must outlive it.
    static std::unique_ptr<Session> begin(const std::string &name, const RenderSettings &,
                                          DiagnosticSink &, std::string &problem);
    virtual ~Session() = default;

    virtual StreamSink &requests() = 0;
    /// Where others report what they find wrong with requests.
    virtual DiagnosticSink &diagnostics() = 0;
    /// RiArchiveRecord: "comment", "structure" or "verbatim", which is RIB. False, and reported, if
    /// the type is another.
    bool record(const SourceLocation &, const std::string &type, std::string text);
    /// Ctrl-C has ended a render, where the settings say that it is heeded.
    virtual bool wasInterrupted() const { return false; }
    /// After the last request. What has gone wrong with writing; empty if nothing has.
    virtual std::string end() = 0;
};

} // namespace candela

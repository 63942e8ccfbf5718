// SPDX-License-Identifier: Apache-2.0
// All that a stream of requests may hold: the requests of the interface, and those that decide what
// comes (archives, conditions). Readers call a StreamSink: one that does what those say and hands
// the rest on (interface/rib/stream_expander.h), or one that writes all down as it stands.
#pragma once

#include "interface/ri/request_sink.h"

namespace candela {

class StreamSink : public RequestSink {
public:
#define REQUEST_OF_STREAM(Name, handler, scopes, ...)                                              \
    virtual void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) = 0;
#include "interface/ri/requests.def"

    /// True where a condition does not hold: of what comes, only conditions will be heard.
    virtual bool skips() const = 0;

    /// A comment: what stands behind the first '#' up to the end of the line. One within or before
    /// a request may come behind it.
    virtual void comment(const SourceLocation &, const std::string &) {}
    virtual bool wantsComments() const { return false; }
};

} // namespace candela

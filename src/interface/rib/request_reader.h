// SPDX-License-Identifier: Apache-2.0
// The requests of one RIB stream, one after the other. Private to the room.
#pragma once

#include "interface/ri/stream_sink.h"
#include "interface/rib/argument_cursor.h"

namespace candela {

class RequestReader {
public:
    RequestReader(Lexer, StreamSink &, DiagnosticSink &);

    /// Reads requests until the stream ends or the sink wants no more.
    void run();

private:
    void readRequest();
    void tellComments();
    void dispatch(RequestId, const SourceLocation &);
    template <class Sink, class... Arguments>
    void call(void (Sink::*)(const SourceLocation &, Arguments...), const SourceLocation &);

    ArgumentCursor cursor_;
    StreamSink &sink_;
    DiagnosticSink &diagnostics_;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The requests of one RIB stream, one after the other. Private to the room.
#pragma once

#include "interface/ri/request_sink.h"
#include "interface/rib/argument_cursor.h"

#include <functional>
#include <string>

namespace candela {

class RequestReader {
public:
    /// Reads in its place the archive that a request names.
    using ArchiveReader = std::function<void(const SourceLocation &, const std::string &name)>;

    RequestReader(Lexer, RequestSink &, DiagnosticSink &, ArchiveReader);

    /// Reads requests until the stream ends or the sink wants no more.
    void run();

private:
    void dispatch(RequestId, const SourceLocation &);
    template <class Receiver, class... Arguments>
    void call(Receiver &, void (Receiver::*)(const SourceLocation &, Arguments...),
              const SourceLocation &);

    // The requests of the stream itself, in the form of a sink's.
    void version(const SourceLocation &, float number);
    void readArchive(const SourceLocation &, const std::string &name, const TokenList &);

    ArgumentCursor cursor_;
    RequestSink &sink_;
    DiagnosticSink &diagnostics_;
    ArchiveReader archives_;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Reads RIB (ASCII, plain or compressed with gzip) and makes its requests to a sink.
#pragma once

#include "interface/ri/request_sink.h"

#include <string>
#include <vector>

namespace candela {

class Lexer;

class RibReader {
public:
    /// For a GraphicsState give its ErrorPolicy. Both must outlive it.
    RibReader(RequestSink &sink, DiagnosticSink &diagnostics)
        : sink_(sink), diagnostics_(diagnostics) {}

    /// Reads the file, "-" for the standard input, with the archives that it names. What is wrong
    /// in it is reported with file, line and column, and the reading goes on with the next
    /// request. False if the file cannot be opened, which is reported too.
    bool readFile(const std::string &path);
    /// The same from memory; `name` stands in locations in place of a file's.
    void readText(std::string text, const std::string &name);

private:
    void read(Lexer);
    /// The archive that a request asks for, read in its place.
    void readArchive(const SourceLocation &, const std::string &name);

    RequestSink &sink_;
    DiagnosticSink &diagnostics_;
    std::vector<std::string> open_; ///< Files that are being read, one inside the other.
    int nestedReadings_ = 0;        ///< Archives that archives have asked for so far.
};

} // namespace candela

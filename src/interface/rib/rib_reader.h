// SPDX-License-Identifier: Apache-2.0
// Reads scenes: RIB with the archives that it names and the conditions that it makes.
#pragma once

#include "interface/rib/stream_expander.h"

#include <string>

namespace candela {

class RibReader {
public:
    /// For a GraphicsState give its ErrorPolicy. Both must outlive it.
    RibReader(RequestSink &sink, DiagnosticSink &diagnostics, const ProceduralSettings & = {});

    /// As readRibFile and readRibText (rib_stream.h) do.
    bool readFile(const std::string &path);
    void readText(std::string text, const std::string &name);

    /// Takes requests that come from elsewhere, as if they stood in a file.
    StreamExpander &stream() { return stream_; }

private:
    void readArchive(const std::string &path);

    DiagnosticSink &diagnostics_;
    StreamExpander stream_;
};

} // namespace candela

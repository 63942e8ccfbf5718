// SPDX-License-Identifier: Apache-2.0
// Reads RIB (ASCII, plain or compressed with gzip) and makes its requests to a sink, as they stand:
// what archives and conditions mean is the sink's to know.
#pragma once

#include "interface/ri/stream_sink.h"

#include <string>

namespace candela {

/// Reads the file, "-" for the standard input. What is wrong in it is reported with file, line and
/// column, and the reading goes on with the next request. False if the file cannot be opened, which
/// is reported too.
bool readRibFile(const std::string &path, StreamSink &, DiagnosticSink &);
/// The same from memory; `name` stands in locations in place of a file's.
void readRibText(std::string text, const std::string &name, StreamSink &, DiagnosticSink &);

} // namespace candela

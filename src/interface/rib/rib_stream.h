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
/// The same for a file that another one names. One that is not named so (.rib) and whose first
/// word, comments apart, is no request is no RIB: it is left out, and nothing of what it holds is
/// told.
bool readRibArchive(const std::string &path, StreamSink &, DiagnosticSink &);
/// The same as readRibFile() from memory; `name` stands in locations in place of a file's.
void readRibText(std::string text, const std::string &name, StreamSink &, DiagnosticSink &);

} // namespace candela

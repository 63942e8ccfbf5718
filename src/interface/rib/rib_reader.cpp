// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_reader.h"

#include "interface/rib/rib_stream.h"

namespace candela {

RibReader::RibReader(RequestSink &sink, DiagnosticSink &diagnostics,
                     const ProceduralSettings &procedurals)
    : diagnostics_(diagnostics),
      stream_(
          sink, diagnostics, [this](const std::string &path) { readArchive(path); }, procedurals) {}

bool RibReader::readFile(const std::string &path) {
    stream_.beginFile(path);
    const bool opened = readRibFile(path, stream_, diagnostics_);
    stream_.endFile();
    return opened;
}

void RibReader::readArchive(const std::string &path) {
    stream_.beginFile(path);
    readRibArchive(path, stream_, diagnostics_);
    stream_.endFile();
}

void RibReader::readText(std::string text, const std::string &name) {
    stream_.beginFile(name);
    readRibText(std::move(text), name, stream_, diagnostics_);
    stream_.endFile();
}

} // namespace candela

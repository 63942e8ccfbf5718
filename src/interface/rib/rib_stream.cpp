// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_stream.h"

#include "interface/rib/request_reader.h"

namespace candela {

bool readRibFile(const std::string &path, StreamSink &sink, DiagnosticSink &diagnostics) {
    std::string why;
    std::unique_ptr<ByteSource> source = ByteSource::open(path, why);
    if (!source) {
        diagnostics.error({std::make_shared<const std::string>(path)},
                          "the file cannot be opened: " + why);
        return false;
    }
    RequestReader(Lexer(std::move(source), path, diagnostics), sink, diagnostics).run();
    return true;
}

void readRibText(std::string text, const std::string &name, StreamSink &sink,
                 DiagnosticSink &diagnostics) {
    auto source = ByteSource::fromMemory(std::move(text));
    RequestReader(Lexer(std::move(source), name, diagnostics), sink, diagnostics).run();
}

} // namespace candela

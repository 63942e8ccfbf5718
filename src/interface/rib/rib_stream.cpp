// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_stream.h"

#include "foundation/base/letters.h"
#include "interface/rib/request_names.h"
#include "interface/rib/request_reader.h"

#include <cctype>

namespace candela {

namespace {

SourceLocation fileItself(const std::string &path) {
    return {std::make_shared<const std::string>(path)};
}

void skipLine(ByteSource &source) {
    while (source.peek() >= 0 && source.peek() != '\n' && source.peek() != '\r')
        source.skip();
}

/// ASCII whose first word is a request, or binary.
bool beginsAsRib(ByteSource &source) {
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf";
    source.peek(byteOrderMark.size());
    if (source.window().starts_with(byteOrderMark))
        source.skip(byteOrderMark.size());
    for (; source.peek() == '#' || (source.peek() > 0 && source.peek() <= ' '); source.skip())
        if (source.peek() == '#')
            skipLine(source);
    if (source.peek() < 0 || source.peek() >= 0x80) // Nothing, or binary.
        return true;
    std::string word;
    constexpr std::size_t longest = 64;
    for (; word.size() < longest && std::isalnum(source.peek()); source.skip())
        word += char(source.peek());
    return requestNamed(word).has_value();
}

bool isNamedAsRib(const std::string &path) {
    const std::string name = inSmallLetters(path);
    return name.ends_with(".rib") || name.ends_with(".rib.gz");
}

} // namespace

bool readRibFile(const std::string &path, StreamSink &sink, DiagnosticSink &diagnostics) {
    std::string why;
    std::unique_ptr<ByteSource> source = ByteSource::open(path, why);
    if (!source) {
        diagnostics.error(fileItself(path), "the file cannot be opened: " + why);
        return false;
    }
    RequestReader(Lexer(std::move(source), path, diagnostics), sink, diagnostics).run();
    return true;
}

bool readRibArchive(const std::string &path, StreamSink &sink, DiagnosticSink &diagnostics) {
    std::string why;
    const auto beginning = ByteSource::open(path, why);
    if (!beginning || isNamedAsRib(path) || beginsAsRib(*beginning))
        return readRibFile(path, sink, diagnostics);
    diagnostics.error(fileItself(path),
                      "this is no RIB: it begins with no request; it is left out");
    return true;
}

void readRibText(std::string text, const std::string &name, StreamSink &sink,
                 DiagnosticSink &diagnostics) {
    auto source = ByteSource::fromMemory(std::move(text));
    RequestReader(Lexer(std::move(source), name, diagnostics), sink, diagnostics).run();
}

} // namespace candela

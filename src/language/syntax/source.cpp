// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/source.h"

#include <algorithm>

namespace candela::sl {

/// Without the mark that some editors put before a text and the end marks (Ctrl-Z) of DOS behind
/// it.
static std::string_view withoutMarks(std::string_view text) {
    constexpr std::string_view byteOrderMark = "\xef\xbb\xbf", padding = "\x1a\0 \t\r\n";
    constexpr char endMark = '\x1a';
    if (text.starts_with(byteOrderMark))
        text.remove_prefix(byteOrderMark.size());
    const size_t last = text.find_last_not_of(padding);
    const size_t mark = text.find(endMark, last == text.npos ? 0 : last + 1);
    return text.substr(0, mark);
}

static std::string withUnixLineEnds(std::string_view text) {
    std::string result;
    result.reserve(text.size());
    for (size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '\r')
            result += text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            result += '\n';
    }
    return result;
}

SourceFile::SourceFile(std::string name, std::string_view text, bool mayBeQuoted)
    : name_(std::make_shared<const std::string>(std::move(name))), mayBeQuoted_(mayBeQuoted),
      text_(withUnixLineEnds(withoutMarks(text))) {
    lineStarts_.push_back(0);
    for (size_t i = 0; i < text_.size(); ++i)
        if (text_[i] == '\n')
            lineStarts_.push_back(i + 1);
}

std::string_view SourceFile::line(int n) const {
    if (n < 1 || size_t(n) > lineStarts_.size())
        return {};
    size_t begin = lineStarts_[n - 1];
    size_t end = size_t(n) < lineStarts_.size() ? lineStarts_[n] - 1 : text_.size();
    return std::string_view(text_).substr(begin, end - begin);
}

SourceLocation Place::location() const {
    return {file ? file->sharedName() : nullptr, line, column};
}

Diagnostic diagnosticAt(Severity severity, const Place &where, std::string message) {
    Diagnostic result{severity, where.location(), std::move(message), {}, 1};
    if (!where.file || !where.file->mayBeQuoted())
        return result;
    result.sourceLine = where.file->line(where.line);
    int room = int(result.sourceLine.size()) - where.column + 1;
    result.caretLength = std::max(1, std::min(where.length, room));
    return result;
}

} // namespace candela::sl

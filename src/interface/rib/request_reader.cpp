// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/request_reader.h"

#include "interface/rib/arguments.h"
#include "interface/rib/request_names.h"

#include <tuple>

namespace candela {

/// Heard where a condition does not hold, too.
static bool isConditional(RequestId id) {
    return id == RequestId::IfBegin || id == RequestId::ElseIf || id == RequestId::Else ||
           id == RequestId::IfEnd;
}

static Lexer prepared(Lexer lexer, const StreamSink &sink) {
    if (sink.wantsComments())
        lexer.keepComments();
    return lexer;
}

RequestReader::RequestReader(Lexer lexer, StreamSink &sink, DiagnosticSink &diagnostics)
    : cursor_(prepared(std::move(lexer), sink), diagnostics), sink_(sink),
      diagnostics_(diagnostics) {}

void RequestReader::run() {
    tellComments();
    while (!cursor_.at(TokenKind::End) && !sink_.stopped()) {
        readRequest();
        tellComments();
    }
}

void RequestReader::tellComments() {
    for (const RibComment &comment : cursor_.takeComments())
        sink_.comment(comment.where, comment.text);
}

void RequestReader::readRequest() {
    const RibToken name = cursor_.token();
    const bool word = cursor_.at(TokenKind::Request), skips = sink_.skips();
    const auto id = word ? requestNamed(name.text) : std::nullopt;
    const bool heard = id.has_value() && (!skips || isConditional(id.value()));
    cursor_.setSilent(skips && !heard);
    if (heard) {
        cursor_.begin(describe(id.value()));
        return dispatch(id.value(), name.where);
    }
    if (!skips)
        diagnostics_.error(name.where, word ? "unknown request '" + name.text + "'" +
                                                  requestSuggestion(name.text)
                                            : "expected the name of a request");
    cursor_.next();
    cursor_.skipToRequest();
}

/// Calls the handler of the request.
void RequestReader::dispatch(RequestId id, const SourceLocation &where) {
    switch (id) {
#define REQUEST(Name, handler, ...)                                                                \
    case RequestId::Name:                                                                          \
        return call(&StreamSink::handler, where);
#define REQUEST_LATER(Name, handler, ...)                                                          \
    case RequestId::Name:                                                                          \
        return call(&StreamSink::handler, where);
#define REQUEST_OF_BLOCKS(Name, handler, ...)                                                      \
    case RequestId::Name:                                                                          \
        return call(&StreamSink::handler, where);
#define REQUEST_OF_STREAM(Name, handler, ...)                                                      \
    case RequestId::Name:                                                                          \
        return call(&StreamSink::handler, where);
#include "interface/ri/requests.def"
    }
}

/// Reads the arguments of the method by their types, then calls it.
template <class Sink, class... Arguments>
void RequestReader::call(void (Sink::*method)(const SourceLocation &, Arguments...),
                         const SourceLocation &where) {
    std::tuple<std::decay_t<Arguments>...> values;
    bool complete = std::apply(
        [&](auto &...value) {
            return (readNext(cursor_, value) && ...) && cursor_.atEndOfArguments();
        },
        values);
    if (!complete)
        return cursor_.skipToRequest();
    std::apply([&](const auto &...value) { (sink_.*method)(where, value...); }, values);
}

} // namespace candela

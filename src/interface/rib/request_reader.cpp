// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/request_reader.h"

#include "interface/rib/arguments.h"
#include "interface/rib/request_names.h"

#include <tuple>

namespace candela {

RequestReader::RequestReader(Lexer lexer, RequestSink &sink, DiagnosticSink &diagnostics,
                             ArchiveReader archives)
    : cursor_(std::move(lexer), diagnostics), sink_(sink), diagnostics_(diagnostics),
      archives_(std::move(archives)) {}

void RequestReader::run() {
    while (!cursor_.at(TokenKind::End) && !sink_.stopped()) {
        const RibToken name = cursor_.token();
        const bool word = cursor_.at(TokenKind::Request);
        if (const auto id = word ? requestNamed(name.text) : std::nullopt) {
            cursor_.begin(describe(*id));
            dispatch(*id, name.where);
        } else {
            diagnostics_.error(name.where, word ? "unknown request '" + name.text + "'"
                                                : "expected the name of a request");
            cursor_.next();
            cursor_.skipToRequest();
        }
    }
}

/// Calls the handler of the request.
void RequestReader::dispatch(RequestId id, const SourceLocation &where) {
    switch (id) {
#define REQUEST(Name, handler, ...)                                                                \
    case RequestId::Name:                                                                          \
        return call(sink_, &RequestSink::handler, where);
#define REQUEST_LATER(Name, handler, ...)                                                          \
    case RequestId::Name:                                                                          \
        return call(sink_, &RequestSink::handler, where);
#define REQUEST_OF_BLOCKS(Name, handler, ...)                                                      \
    case RequestId::Name:                                                                          \
        return call(sink_, &RequestSink::handler, where);
#define REQUEST_OF_READER(Name, handler, ...)                                                      \
    case RequestId::Name:                                                                          \
        return call(*this, &RequestReader::handler, where);
#include "interface/ri/requests.def"
    }
}

/// Reads the arguments of the method by their types, then calls it.
template <class Receiver, class... Arguments>
void RequestReader::call(Receiver &receiver,
                         void (Receiver::*method)(const SourceLocation &, Arguments...),
                         const SourceLocation &where) {
    std::tuple<std::decay_t<Arguments>...> values;
    bool complete = std::apply(
        [&](auto &...value) {
            return (readNext(cursor_, value) && ...) && cursor_.atEndOfArguments();
        },
        values);
    if (!complete)
        return cursor_.skipToRequest();
    std::apply([&](const auto &...value) { (receiver.*method)(where, value...); }, values);
}

/// RIB 3.03 and its successors differ in nothing that is read here.
void RequestReader::version(const SourceLocation &, float) {}

void RequestReader::readArchive(const SourceLocation &where, const std::string &name,
                                const TokenList &) {
    archives_(where, name);
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// The names of requests, and their calls.
#include "interface/rib/request_reader.h"

#include <tuple>
#include <unordered_map>

namespace candela {

namespace {

using Dispatcher = void (*)(RequestReader &, const SourceLocation &);

RequestSink &receiverOf(RequestReader &reader, const RequestSink *) { return reader.sink(); }
RequestReader &receiverOf(RequestReader &reader, const RequestReader *) { return reader; }

/// Reads the arguments of a handler by their types, then calls it.
template <auto Method> struct Call;
template <class Receiver, class... Arguments,
          void (Receiver::*Method)(const SourceLocation &, Arguments...)>
struct Call<Method> {
    static void dispatch(RequestReader &reader, const SourceLocation &where) {
        std::tuple<std::decay_t<Arguments>...> values;
        bool complete = std::apply(
            [&](auto &...value) { return (reader.read(value) && ...) && reader.argumentsEnd(); },
            values);
        if (!complete)
            return reader.skipToRequest();
        Receiver &receiver = receiverOf(reader, static_cast<const Receiver *>(nullptr));
        std::apply([&](const auto &...value) { (receiver.*Method)(where, value...); }, values);
    }
};

struct Entry {
    RequestId id;
    Dispatcher dispatch;
};

const Entry *find(const std::string &name) {
    static const std::unordered_map<std::string_view, Entry> table = {
#define REQUEST(Name, handler, ...)                                                                \
    {#Name, {RequestId::Name, &Call<&RequestSink::handler>::dispatch}},
#define REQUEST_LATER(Name, handler, ...)                                                          \
    {#Name, {RequestId::Name, &Call<&RequestSink::handler>::dispatch}},
#define REQUEST_OF_BLOCKS(Name, handler, ...)                                                      \
    {#Name, {RequestId::Name, &Call<&RequestSink::handler>::dispatch}},
#define REQUEST_OF_READER(Name, handler, ...)                                                      \
    {#Name, {RequestId::Name, &Call<&RequestReader::handler>::dispatch}},
#include "interface/ri/requests.def"
    };
    auto found = table.find(name);
    return found == table.end() ? nullptr : &found->second;
}

} // namespace

RequestReader::RequestReader(RibReader &reader, Lexer lexer)
    : reader_(reader), lexer_(std::move(lexer)) {
    next();
}

void RequestReader::run() {
    while (!at(TokenKind::End) && !sink().stopped()) {
        RibToken name = token_;
        const Entry *entry = at(TokenKind::Request) ? find(name.text) : nullptr;
        if (!entry) {
            reader_.diagnostics_.error(name.where, at(TokenKind::Request)
                                                       ? "unknown request '" + name.text + "'"
                                                       : "expected the name of a request");
            next();
            skipToRequest();
            continue;
        }
        const RequestDescription &description = describe(entry->id);
        request_ = description.name;
        argumentNames_ = description.argumentNames;
        argumentIndex_ = -1;
        inBracket_ = false;
        next();
        entry->dispatch(*this, name.where);
    }
}

/// What follows something wrong is silently passed, up to the next request that is one.
void RequestReader::skipToRequest() {
    while (!at(TokenKind::End) && !(at(TokenKind::Request) && find(token_.text)))
        next();
}

/// RIB 3.03 and its successors differ in nothing that is read here.
void RequestReader::version(const SourceLocation &, float) {}

void RequestReader::readArchive(const SourceLocation &where, const std::string &name,
                                const TokenList &) {
    reader_.readArchive(where, name);
}

} // namespace candela

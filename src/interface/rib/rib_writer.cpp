// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/rib_writer.h"

#include "interface/rib/rib_encoder.h"

#include <algorithm>
#include <charconv>

namespace candela {

// An argument each.
static void write(RibEncoder &to, RequestId, float value) { to.number(value); }
static void write(RibEncoder &to, RequestId, int value) { to.number(value); }
static void write(RibEncoder &to, RequestId, bool value) { to.number(int(value)); }
static void write(RibEncoder &to, RequestId, const std::string &text) { to.string(text); }
static void write(RibEncoder &to, RequestId, const Color &color) { to.array(color.c); }
static void write(RibEncoder &to, RequestId, const Matrix4 &matrix) { to.array(matrix.m); }
static void write(RibEncoder &to, RequestId, const Floats &values) {
    to.array(std::span<const float>(values));
}
static void write(RibEncoder &to, RequestId, const Integers &values) {
    to.array(std::span<const int>(values));
}
static void write(RibEncoder &to, RequestId, const Strings &values) { to.array(values); }

/// A handle that is a whole number is written as one.
static void write(RibEncoder &to, RequestId, const Handle &handle) {
    int number = 0;
    const char *begin = handle.text.data(), *end = begin + handle.text.size();
    const auto [stop, error] = std::from_chars(begin, end, number);
    if (error == std::errc() && stop == end && std::to_string(number) == handle.text)
        to.number(number);
    else
        to.string(handle.text);
}

static void write(RibEncoder &to, RequestId, const BasisArgument &basis) {
    if (const auto *name = std::get_if<std::string>(&basis))
        to.string(*name);
    else
        to.array(std::get<1>(basis));
}

/// RI 3.2: those of DepthOfField stand without brackets.
static void write(RibEncoder &to, RequestId id, const LooseFloats &loose) {
    if (id != RequestId::DepthOfField)
        return to.array(std::span<const float>(loose.values));
    for (const float value : loose.values)
        to.number(value);
}

static void write(RibEncoder &to, RequestId id, const SubdivisionTags &tags) {
    if (tags.names.empty() && tags.argumentCounts.empty() && tags.integers.empty() &&
        tags.floats.empty())
        return;
    write(to, id, tags.names);
    write(to, id, tags.argumentCounts);
    write(to, id, tags.integers);
    write(to, id, tags.floats);
}

static void write(RibEncoder &to, RequestId, const TokenList &list) {
    for (const TokenValue &parameter : list.all) {
        to.token(parameter.token);
        if (!parameter.strings.empty())
            to.array(parameter.strings);
        else if (!parameter.integers.empty())
            to.array(std::span<const int>(parameter.integers));
        else
            to.array(std::span<const float>(parameter.floats));
    }
}

RibWriter::RibWriter(ByteOutput &output, RibEncoding encoding)
    : output_(output),
      encoder_(encoding == RibEncoding::Ascii ? RibEncoder::ascii() : RibEncoder::binary()) {}

RibWriter::~RibWriter() { flush(); }

#define WRITE_ARGUMENT(type, name) write(*encoder_, id, name);
#define WRITE(Name, handler, ...)                                                                  \
    void RibWriter::handler(const SourceLocation &CANDELA_PARAMETERS(__VA_ARGS__)) {               \
        [[maybe_unused]] constexpr RequestId id = RequestId::Name;                                 \
        begin(RequestId::Name);                                                                    \
        CANDELA_FOR_EACH(WRITE_ARGUMENT, __VA_ARGS__)                                              \
        end(RequestId::Name);                                                                      \
    }
#define REQUEST(Name, handler, scopes, ...) WRITE(Name, handler, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) WRITE(Name, handler, __VA_ARGS__)
#define REQUEST_OF_STREAM(Name, handler, scopes, ...) WRITE(Name, handler, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) WRITE(Name, handler, __VA_ARGS__)
#include "interface/ri/requests.def"

void RibWriter::comment(const SourceLocation &, const std::string &text) {
    encoder_->comment(text);
}

static bool isBetween(RequestId id) { return id == RequestId::ElseIf || id == RequestId::Else; }

void RibWriter::begin(RequestId id) {
    const std::string_view name = describe(id).name;
    if (name.ends_with("End"))
        depth_ = std::max(depth_ - 1, 0);
    encoder_->begin(name, std::max(depth_ - int(isBetween(id)), 0));
}

void RibWriter::end(RequestId id) {
    encoder_->end();
    depth_ += describe(id).name.ends_with("Begin");
    constexpr std::size_t enough = 1 << 16;
    if (encoder_->bytes.size() >= enough)
        flush();
}

void RibWriter::flush() {
    output_.write(encoder_->bytes);
    encoder_->bytes.clear();
}

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Has a program hear the comments of an archive, and hands all requests on. Private to the room.
#pragma once

#include "interface/ri/stream_sink.h"
#include "ri.h"

namespace candela::c {

class CommentListener final : public StreamSink {
public:
    CommentListener(StreamSink &sink, RtArchiveCallback callback)
        : sink_(sink), callback_(callback) {}

#define FORWARDED(Name, handler, scopes, ...)                                                      \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override {           \
        sink_.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                                       \
    }
#define REQUEST(...) FORWARDED(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) FORWARDED(__VA_ARGS__)
#define REQUEST_OF_STREAM(...) FORWARDED(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    FORWARDED(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef FORWARDED

    /// "# a comment", "##a structure"
    void comment(const SourceLocation &, const std::string &text) override {
        char format[] = "%s";
        const bool structure = text.starts_with('#');
        callback_(structure ? RI_STRUCTURE : RI_COMMENT, format, text.c_str() + structure);
    }
    bool wantsComments() const override { return true; }

    bool skips() const override { return sink_.skips(); }
    bool stopped() const override { return sink_.stopped(); }
    std::optional<std::string> locate(const char *path, const std::string &name,
                                      const SourceLocation &where) const override {
        return sink_.locate(path, name, where);
    }
    float detailOf(const std::array<float, 6> &bound) const override {
        return sink_.detailOf(bound);
    }
    std::optional<Matrix4d> cameraFrom(const std::string &system) const override {
        return sink_.cameraFrom(system);
    }
    std::optional<StateValue> valueOf(const std::string &name) const override {
        return sink_.valueOf(name);
    }

private:
    StreamSink &sink_;
    const RtArchiveCallback callback_;
};

} // namespace candela::c

// SPDX-License-Identifier: Apache-2.0
// Stands before a sink and hands all requests on: for those who want to see or hold back some.
#pragma once

#include "interface/ri/request_sink.h"

namespace candela {

class ForwardingSink : public RequestSink {
public:
    /// It must outlive this one.
    explicit ForwardingSink(RequestSink &sink) : sink_(sink) {}

#define FORWARDED(Name, handler, scopes, ...)                                                      \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST(...) FORWARDED(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) FORWARDED(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    FORWARDED(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef FORWARDED

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
    bool stopped() const override { return sink_.stopped(); }

protected:
    /// Asked before each request; what is not admitted is not handed on.
    virtual bool admits(RequestId) { return true; }

private:
    RequestSink &sink_;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Hands all requests on, and makes a fingerprint of them: equal for equal requests, in whatever
// encoding and archives they come.
#pragma once

#include "foundation/base/hash.h"
#include "interface/ri/forwarding_sink.h"
#include "interface/rib/rib_writer.h"

#include <memory>
#include <string>

namespace candela {

class FingerprintSink final : public ForwardingSink {
public:
    /// It must outlive this one.
    explicit FingerprintSink(RequestSink &sink)
        : ForwardingSink(sink), output_(ByteOutput::toHash(hash_)),
          writer_(*output_, RibEncoding::Binary) {}

#define TAKEN(Name, handler, scopes, ...)                                                          \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override {           \
        writer_.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                                     \
        ForwardingSink::handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                             \
    }
#define REQUEST(...) TAKEN(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) TAKEN(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    TAKEN(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef TAKEN

    /// Of the requests so far.
    std::string text() {
        writer_.flush();
        return hash_.text();
    }

private:
    ContentHash hash_;
    std::unique_ptr<ByteOutput> output_;
    RibWriter writer_;
};

} // namespace candela

// SPDX-License-Identifier: Apache-2.0
// Hands all requests on, and makes a fingerprint of those that it is of: equal for equal requests,
// in whatever encoding and archives they come.
#pragma once

#include "interface/ri/forwarding_sink.h"
#include "interface/rib/request_hash.h"

#include <string>

namespace candela {

class FingerprintSink : public ForwardingSink {
public:
    using ForwardingSink::ForwardingSink;

#define TAKEN(Name, handler, scopes, ...)                                                          \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) final;
#define REQUEST(...) TAKEN(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) TAKEN(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    TAKEN(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef TAKEN

private:
    /// Which hash a request goes into; null if into none.
    virtual RequestHash *hashFor(RequestId) = 0;
};

/// Of all requests.
class StreamFingerprint final : public FingerprintSink {
public:
    using FingerprintSink::FingerprintSink;

    /// Of those so far.
    std::string text() { return hash_.text(); }

private:
    RequestHash *hashFor(RequestId) override { return &hash_; }

    RequestHash hash_;
};

} // namespace candela

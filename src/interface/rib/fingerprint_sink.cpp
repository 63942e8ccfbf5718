// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/fingerprint_sink.h"

namespace candela {

#define TAKEN(Name, handler, scopes, ...)                                                          \
    void FingerprintSink::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {   \
        if (RequestHash *const hash = hashFor(RequestId::Name))                                    \
            hash->writer().handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                          \
        ForwardingSink::handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                             \
    }
#define REQUEST(...) TAKEN(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) TAKEN(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    TAKEN(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef TAKEN

} // namespace candela

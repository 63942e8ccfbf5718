// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/forwarding_sink.h"

namespace candela {

#define FORWARDED(Name, handler, scopes, ...)                                                      \
    void ForwardingSink::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {    \
        if (admits(RequestId::Name))                                                               \
            sink_.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                                   \
    }
#define REQUEST(...) FORWARDED(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) FORWARDED(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    FORWARDED(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef FORWARDED

} // namespace candela
